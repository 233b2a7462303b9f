#include "exact/point_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace sightline {

PointTable::PointTable(const Grid& grid, std::span<const glm::dvec3> world)
    : grid_(grid), stride_(words_for(static_cast<std::uint32_t>(grid.bits()))) {
  const auto bits = static_cast<std::uint32_t>(grid.bits());
  words_.resize(std::size_t{3} * stride_ * world.size());
  approx_.reserve(world.size());
  std::uint64_t* out = words_.data();
  GridPoint g;  // keeps its room
  for (const glm::dvec3& p : world) {
    std::uint32_t longest = 0;
    if (std::array<std::int64_t, 3> c; grid.short_point(p, c)) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        longest = std::max(longest, magnitude_bits(c[k]));
        out[k * stride_] = static_cast<std::uint64_t>(c[k]);
        std::fill(out + k * stride_ + 1, out + (k + 1) * stride_, c[k] < 0 ? ~std::uint64_t{0} : 0);
      }
    } else {
      grid.point(p, g);
      if (g.shift > 0) throw std::invalid_argument("a point is finer than the grid");
      for (std::uint32_t k = 0; k < 3; ++k) {
        longest = std::max(longest, magnitude_bits(g.c[k]));
        store_words(g.c[k], out + k * stride_, stride_);
      }
    }
    if (longest > bits) throw std::invalid_argument("a point is too far away for the grid");
    glm::dvec3& approx = approx_.emplace_back();
    for (int k = 0; k < 3; ++k, out += stride_) approx[k] = words_to_double(out, stride_, -grid.unit_bits());
  }
}

std::array<Integer, 3> PointTable::point(PointId p) const {
  const std::uint64_t* const w = words(p);
  return {load_integer(w, stride_), load_integer(w + stride_, stride_), load_integer(w + 2 * stride_, stride_)};
}

bool PointTable::equal(PointId a, PointId b) const {
  return a == b || std::equal(words(a), words(a) + 3 * stride_, words(b));
}

Limbs PointTable::coordinate(PointId p, int axis) const {
  const std::uint64_t* const w = words(p) + static_cast<std::size_t>(axis) * stride_;
  return {w, stride_, magnitude_bits(w, stride_)};
}

}  // namespace sightline
