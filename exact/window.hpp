// The window of a perspective camera, exactly.
#pragma once

#include "exact/sightline_table.hpp"

#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace sightline {

/// The window of a perspective camera: the ray of (s,t) in [0,1]^2 is forward + (s-1/2) right + (t-1/2) up.
///
/// Laws. 1: the corners of the window are (0,0), (1,0), (0,1), (1,1), exactly. 2: every corner lies on the inner side
/// of the other two sides, and forward. 3: a common power of two in the vectors changes nothing. 4: with right negated
/// the handedness changes, and left and right are exchanged.
class Window {
 public:
  enum Side { left, right, bottom, top };
  /// Throws std::invalid_argument if the three vectors are linearly dependent or not finite.
  Window(const glm::dvec3& f, const glm::dvec3& r, const glm::dvec3& u);  // forward, right, up
  /// The window's side as a sightline of the table, its normal pointing into the window.
  SightlineRef side(SightlineTable& table, Side which) const;
  /// The line s = k / n of the window, 0 < k < n < 2^16, its normal pointing towards greater s.
  SightlineRef upright(SightlineTable& table, unsigned k, unsigned n) const;
  /// +1: right x up points backwards, as in every camera made from angles; -1: a mirrored camera.
  Sign handedness() const { return handedness_; }
  /// The normal of the window's own plane, away from the eye: largest component in [1/2, 1], each within 2^-53.
  glm::dvec3 ahead() const { return across_ * static_cast<double>(-handedness_); }
  /// (s,t) of the ray in which two different sightlines meet, each coordinate the nearest double; not a number where
  /// they meet at infinity (a ray parallel to the window).
  glm::dvec2 st(const SightlineTable& table, SightlineId a, SightlineId b) const;
  /// Sign of the forward component of the ray n_b x n_a (oriented normals).
  Sign forwardness(const SightlineTable& table, SightlineRef a, SightlineRef b) const;

 private:
  const std::uint64_t* words() const { return stride_ <= short_stride ? short_words_.data() : long_words_.data(); }

  static constexpr std::uint32_t short_stride = 4;
  Sign handedness_ = 1;
  // Forward, right, up, times one power of two: nine integers of stride_ words, here or there.
  std::array<std::uint64_t, 9 * short_stride> short_words_{};
  std::vector<std::uint64_t> long_words_;
  std::uint32_t stride_ = 1;
  int bits_ = 0;
  glm::dvec3 across_{0};  // right x up, scaled as sightlines are
};

}  // namespace sightline
