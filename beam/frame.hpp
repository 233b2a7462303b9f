// Bounds of what is seen, on a plane before the eye. Internal to beam/.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "bsp/tree.hpp"

namespace sightline {

/// A rectangle of the frame, as the four numbers low x, low y, -high x, -high y, so that one comparison does for all.
struct alignas(16) FrameBox {
  float side[4];

  static FrameBox everything() {
    constexpr float far = std::numeric_limits<float>::infinity();
    return {{-far, -far, -far, -far}};
  }
  bool bounded() const { return side[0] != -std::numeric_limits<float>::infinity(); }
  bool meets(const FrameBox& o) const {
#ifdef __SSE__
    const __m128 other = _mm_load_ps(o.side);
    const __m128 most = _mm_xor_ps(_mm_shuffle_ps(other, other, _MM_SHUFFLE(1, 0, 3, 2)), _mm_set1_ps(-0.0f));
    return _mm_movemask_ps(_mm_cmple_ps(_mm_load_ps(side), most)) == 15;
#else
    return (side[0] <= -o.side[2]) & (side[1] <= -o.side[3]) & (side[2] <= -o.side[0]) & (side[3] <= -o.side[1]);
#endif
  }
  /// The smallest that holds both.
  FrameBox around(const FrameBox& o) const {
    FrameBox b;
#ifdef __SSE__
    _mm_store_ps(b.side, _mm_min_ps(_mm_load_ps(side), _mm_load_ps(o.side)));
#else
    for (int k = 0; k < 4; ++k) b.side[k] = side[k] < o.side[k] ? side[k] : o.side[k];
#endif
    return b;
  }
};

/// A plane before the eye, at distance 1 along `ahead`, with coordinates of its own. Rectangles are conservative: they
/// hold what they bound, all rounding included.
class Frame {
 public:
  const glm::dvec3& across() const { return x_; }
  const glm::dvec3& upwards() const { return y_; }
  const glm::dvec3& ahead() const { return z_; }
  void set(const glm::dvec3& eye, const glm::dvec3& ahead, double doubt);
  /// Bounds of a corner, the product of two lines' rounded normals; everything if it is not clearly ahead of the eye.
  FrameBox bounds(const glm::dvec3& corner) const;
  /// Where a direction from the eye is seen, or a corner, each coordinate within `error`; false unless it is clearly
  /// ahead.
  bool place(const glm::dvec3& ray, glm::dvec2& at, double& error) const;
  /// Where a corner, the product of two lines' rounded normals, is seen, each coordinate within `error`; false unless
  /// it is clearly ahead.
  bool place_corner(const glm::dvec3& corner, glm::dvec2& at, double& error) const;
  /// Bounds of what is seen of a box; false if all of it lies behind the eye.
  bool bounds(const TreeBox& box, FrameBox& out) const;

 private:
  glm::dvec3 eye_{0}, x_{0}, y_{0}, z_{0}, abs_x_{0}, abs_y_{0}, abs_z_{0};
  double doubt_ = 0;  // of a product of an axis and a difference from the eye
};

}  // namespace sightline
