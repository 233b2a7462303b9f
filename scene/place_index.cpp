#include "scene/place_index.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {

PlaceIndex::PlaceIndex(const PointTable& points, std::span<const PointId> members) {
  // More cells than points: buildings are flat, cities empty.
  side_ = std::clamp<std::size_t>(static_cast<std::size_t>(3 * std::cbrt(static_cast<double>(members.size()))), 1, 128);
  const auto cell_of = [&](PointId p) {
    const glm::dvec3& at = points.approx(p);
    return (cell(at.x, 0) * side_ + cell(at.y, 0)) * side_ + cell(at.z, 0);
  };
  first_.assign(side_ * side_ * side_ + 1, 0);
  for (const PointId p : members) ++first_[cell_of(p) + 1];
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  members_.resize(members.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const PointId p : members) members_[next[cell_of(p)]++] = {p, points.approx(p)};
}

}  // namespace sightline
