// Which scene vertices lie near a place.
#pragma once

#include "exact/point_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace sightline {

/// Points in the cells of a regular grid over the box that bounds them. For finding candidates only: who asks decides
/// exactly.
class PlaceIndex {
 public:
  PlaceIndex() = default;
  PlaceIndex(const PointTable& points, std::span<const PointId> members);

  /// Calls visit(point) for at least every member within `radius` of a place along each axis (unit coordinates). A
  /// radius that is infinite or not a number asks for all.
  template <class Visit>
  void near(const glm::dvec3& place, double radius, Visit&& visit) const {
    if (members_.empty()) return;
    // Mostly one cell. A place in cells is at most 4096 and off by less than 2^-39, so that with 2^-37 more on each
    // side no member is missed that lies a rounding away. What is not a number asks for all: a comparison with it keeps
    // the first argument of min and max.
    std::size_t from[3], to[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      const double at = (place[axis] - low_[axis]) * scale_[axis], wide = radius * scale_[axis] + 0x1p-37;
      const double low = std::min(last_[axis], std::max(0.0, at - wide));
      const double high = std::max(0.0, std::min(last_[axis], at + wide));
      from[k] = static_cast<std::size_t>(static_cast<int>(low));
      to[k] = static_cast<std::size_t>(static_cast<int>(high));
    }
    for (std::size_t x = from[0]; x <= to[0]; ++x) {
      for (std::size_t y = from[1]; y <= to[1]; ++y) {
        const std::size_t row = (x * cells_[1] + y) * cells_[2];
        for (std::uint32_t k = first_[row + from[2]]; k < first_[row + to[2] + 1]; ++k) {
          const glm::dvec3& at = members_[k].at;
          if (std::abs(at.x - place.x) > radius || std::abs(at.y - place.y) > radius) continue;
          if (!(std::abs(at.z - place.z) > radius)) visit(members_[k].point);
        }
      }
    }
  }

 private:
  glm::dvec3 low_{0}, scale_{0};               // a place in cells is (place - low) * scale
  std::array<std::size_t, 3> cells_{1, 1, 1};  // along each axis
  glm::dvec3 last_{0};                         // the last cell of each axis
  std::vector<std::uint32_t> first_;           // by cell, into members_
  struct Member {
    PointId point;
    glm::dvec3 at;
  };
  std::vector<Member> members_;
};

}  // namespace sightline
