// Which scene vertices lie near a place.
#pragma once

#include "exact/point_table.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace sightline {

/// Points in the cells of a regular grid over the unit box. For finding candidates only: who asks decides exactly.
class PlaceIndex {
 public:
  PlaceIndex() = default;
  PlaceIndex(const PointTable& points, std::span<const PointId> members);

  /// Calls visit(point) for at least every member within `radius` of a place along each axis (unit coordinates). A
  /// radius that is infinite or not a number asks for all.
  template <class Visit>
  void near(const glm::dvec3& place, double radius, Visit&& visit) const {
    if (members_.empty()) return;
    // Mostly one cell. A place in cells is at most 128 and off by less than 2^-45, so that with 2^-43 more on each side
    // no member is missed that lies a rounding away. What is not a number asks for all.
    std::size_t from[3], to[3];
    const double side = static_cast<double>(side_), wide = radius * side + 0x1p-43;
    for (int k = 0; k < 3; ++k) {
      const double at = (place[k] + 0.5) * side, low = at - wide, high = at + wide;
      from[k] = !(low > 0) ? 0 : low >= side ? side_ - 1 : static_cast<std::size_t>(low);
      to[k] = !(high < side) ? side_ - 1 : high <= 0 ? 0 : static_cast<std::size_t>(high);
    }
    for (std::size_t x = from[0]; x <= to[0]; ++x) {
      for (std::size_t y = from[1]; y <= to[1]; ++y) {
        const std::size_t row = (x * side_ + y) * side_;
        for (std::uint32_t k = first_[row + from[2]]; k < first_[row + to[2] + 1]; ++k) {
          const glm::dvec3& at = members_[k].at;
          if (std::abs(at.x - place.x) > radius || std::abs(at.y - place.y) > radius) continue;
          if (!(std::abs(at.z - place.z) > radius)) visit(members_[k].point);
        }
      }
    }
  }

 private:
  std::size_t cell(double coordinate, std::size_t otherwise) const {
    const double at = (coordinate + 0.5) * static_cast<double>(side_);
    if (!(at == at)) return otherwise;
    return at <= 0 ? 0 : at >= static_cast<double>(side_) ? side_ - 1 : static_cast<std::size_t>(at);
  }

  std::size_t side_ = 1;              // cells along each axis
  std::vector<std::uint32_t> first_;  // by cell, into members_
  struct Member {
    PointId point;
    glm::dvec3 at;
  };
  std::vector<Member> members_;
};

}  // namespace sightline
