// The planes through one camera's eye, interned: lines of the window that coincide have one id.
#pragma once

#include "exact/predicates.hpp"

#include <span>

namespace sightline {

/// All sightlines of one eye. A sightline is a plane through the eye, given by its normal; normals that are multiples
/// of one another share one id (canonical: the one that came first; refs carry the sign). Reusable: `reset` forgets
/// the lines, keeps the buffers. Not for use by two threads at once.
///
/// A ray r lies in the front of line n when n.r > 0. The *corner* of two refs is the ray  n_b x n_a  (see corner()).
class SightlineTable {
 public:
  explicit SightlineTable(const PlaneTable& planes) { reset(planes, {}); }
  void reset(const PlaneTable& planes, const GridPoint& eye);

  /// Normal (a - eye) x (b - eye). id none: eye, a and b are collinear.
  SightlineRef of_points(PointId a, PointId b);
  /// Normal P(eye) n_q - Q(eye) n_p with P(x) = n_p.x - d_p: the plane of the eye and the line of planes p and q.
  /// id none: the planes are parallel or both contain the eye.
  SightlineRef of_planes(PlaneId p, PlaneId q);
  /// Normal n_p. The caller states that plane p contains the eye.
  SightlineRef of_plane(PlaneId p);
  /// Any integer normal, not zero.
  SightlineRef of_normal(const std::array<Integer, 3>& n);

  /// Side of the eye against a plane; remembered.
  Sign eye_side(PlaneId p);
  /// Sign of det(n_a, n_b, n_c) of the oriented normals: 0 at once when two ids are equal, then filter, then exact.
  /// The workhorse: with a = b's neighbour it tells on which side of c the corner of a and b lies.
  Sign order(SightlineRef a, SightlineRef b, SightlineRef c);
  /// Side of a line on which a point of the scene is seen: sign of n.(p - eye).
  Sign side(SightlineRef a, PointId p);
  /// Is the point p in the eye?
  bool is_eye(PointId p) const;

  std::uint32_t size() const;
  /// The canonical normal scaled by a power of two to largest component in [1/2, 1], each component within 2^-53.
  const glm::dvec3& approx(SightlineId id) const;
  std::array<Integer, 3> normal(SightlineId id) const;
  const PlaneTable& planes() const { return *planes_; }
  const GridPoint& eye() const { return eye_; }

 private:
  const PlaneTable* planes_ = nullptr;
  GridPoint eye_;
  // The rest is exact/'s own; see sightline_table.cpp.
};

/// The window of a perspective camera: the ray of (s,t) in [0,1]^2 is forward + (s-1/2) right + (t-1/2) up.
class Window {
 public:
  enum Side { left, right, bottom, top };
  /// Throws std::invalid_argument if the three vectors are linearly dependent or not finite.
  Window(const glm::dvec3& forward, const glm::dvec3& right, const glm::dvec3& up);
  /// The window's side as a sightline of the table, its normal pointing into the window.
  SightlineRef side(SightlineTable& table, Side which) const;
  /// +1: right x up points backwards, as in every camera made from angles; -1: a mirrored camera.
  Sign handedness() const { return handedness_; }
  /// (s,t) of the ray in which two different sightlines meet, each coordinate the nearest double.
  glm::dvec2 st(const SightlineTable& table, SightlineId a, SightlineId b) const;
  /// Sign of the forward component of the ray n_b x n_a (oriented normals).
  Sign forwardness(const SightlineTable& table, SightlineRef a, SightlineRef b) const;

 private:
  std::array<std::array<Integer, 3>, 3> vectors_;  // forward, right, up, times one power of two
  Sign handedness_ = 1;
};

}  // namespace sightline
