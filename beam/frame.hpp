// Bounds of what is seen, on a plane before the eye. Internal to beam/.
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "beam/region.hpp"
#include "bsp/tree.hpp"

namespace sightline {

/// A rectangle of the frame, as the four numbers low x, low y, -high x, -high y, so that one comparison does for all.
struct FrameBox {
  float side[4];

  static FrameBox everything() {
    constexpr float far = std::numeric_limits<float>::infinity();
    return {{-far, -far, -far, -far}};
  }
  bool bounded() const { return side[0] != -std::numeric_limits<float>::infinity(); }
  bool meets(const FrameBox& o) const {
    return (side[0] <= -o.side[2]) & (side[1] <= -o.side[3]) & (side[2] <= -o.side[0]) & (side[3] <= -o.side[1]);
  }
  FrameBox common(const FrameBox& o) const {
    FrameBox b;
    for (int k = 0; k < 4; ++k) b.side[k] = side[k] > o.side[k] ? side[k] : o.side[k];
    return b;
  }
};

/// A plane before the eye, at distance 1 along `ahead`, with coordinates of its own. Rectangles are conservative: they
/// hold what they bound, all rounding included.
class Frame {
 public:
  void set(const glm::dvec3& eye, const glm::dvec3& ahead, double doubt);
  /// Bounds of a region, which lies ahead of the eye.
  FrameBox bounds(std::span<const RegionSide> region) const;
  /// Bounds of what is seen of a box; false if all of it lies behind the eye.
  bool bounds(const TreeBox& box, FrameBox& out) const;

 private:
  glm::dvec3 eye_{0}, x_{0}, y_{0}, z_{0}, abs_x_{0}, abs_y_{0}, abs_z_{0};
  double doubt_ = 0;  // of a product of an axis and a difference from the eye
};

}  // namespace sightline
