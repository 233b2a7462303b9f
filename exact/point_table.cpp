#include "exact/point_table.hpp"

#include "exact/rounding.hpp"

#include <algorithm>

namespace sightline {

PointTable::PointTable(const Grid& grid, std::span<const glm::dvec3> world)
    : grid_(grid), stride_(words_for(static_cast<std::uint32_t>(grid.bits()))) {
  const auto count = static_cast<std::uint32_t>(world.size());
  words_.resize(std::size_t{3} * stride_ * count);
  approx_.resize(count);
  for (std::uint32_t p = 0; p < count; ++p) {
    const GridPoint g = grid.point(world[p]);
    for (int k = 0; k < 3; ++k) {
      std::uint64_t* const out = words_.data() + (std::size_t{3} * p + static_cast<std::size_t>(k)) * stride_;
      store_words(g.c[static_cast<std::size_t>(k)], out, stride_);
      approx_[p][k] = words_to_double(out, stride_, -grid.unit_bits());
    }
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
