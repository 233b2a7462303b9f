// Doubles as integers on one grid: nothing is rounded unless the user asks for a snap.
#pragma once

#include "exact/types.hpp"

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

namespace sightline {

/// A point of the grid refined by 2^shift: coordinates are c * 2^-shift in grid units. shift >= 0.
struct GridPoint {
  std::array<Integer, 3> c;
  int shift = 0;
};

/// All coordinates of a scene as integers: world = (integer + origin) * step, where step is 2^exponent, or the
/// decimal unit of a snap. `origin` is the integer nearest to the centre of the bounding box, so that scenes far from
/// zero stay short. Unit coordinates are grid coordinates times 2^-unit_bits: every point of the enlarged bounding
/// box (by half its largest extent on every side, one step at least) has |unit coordinate| <= 1/2. All filters work in
/// unit coordinates.
///
/// Laws. 1: world(point(p)) = p for the points of the grid, with shift 0. 2: differences of points are those of the
/// doubles, in steps. 3: bits() is the length of the longest coordinate, and the enlarged box lies within 1/2.
/// 4: a snap takes the nearest multiple, ties to even; snapping again changes nothing. 5: points of a PointTable are
/// equal just if their doubles are; their approximations are within 2^-54.
class Grid {
 public:
  /// Grid of all the given points, losslessly. Points must be finite.
  static Grid covering(std::span<const glm::dvec3> points);
  /// Grid of integer multiples of the decimal `unit` ("1e-6", "0.25", "3"): throws std::invalid_argument if `unit`
  /// is not a positive decimal. Points are moved to the nearest multiple (ties to even).
  static Grid snapped(std::span<const glm::dvec3> points, const std::string& unit);

  /// The point on the grid. Without a snap it is exact, with shift > 0 where the point is finer than the grid (an
  /// eye may be); with a snap it is the nearest multiple, shift 0.
  GridPoint point(const glm::dvec3& world) const;
  /// The same into numbers that are at hand: without a snap, nothing is allocated once they have grown.
  void point(const glm::dvec3& world, GridPoint& p) const;
  /// The same for a point that lies on the grid and whose coordinates are short: false, and nothing written, where
  /// that is not so. Quick; allocates nothing.
  bool short_point(const glm::dvec3& world, std::array<std::int64_t, 3>& c) const;
  /// The double nearest to a grid coordinate's world value.
  double world(const Integer& c, int axis) const;
  /// The same of the grid coordinate numerator / denominator; denominator not zero.
  double world(const Integer& numerator, const Integer& denominator, int axis) const;
  /// Unit coordinate of a world coordinate, rounded; for boxes and drawings, never for decisions.
  glm::dvec3 unit(const glm::dvec3& world) const;

  int unit_bits() const { return unit_bits_; }
  /// B: the bit length of the largest grid coordinate of the points given.
  int bits() const { return bits_; }
  const std::array<Integer, 3>& origin() const { return origin_; }
  /// The unit of the snap as the user wrote it; empty without one.
  const std::string& snap() const { return snap_; }
  /// World length of a grid step, rounded to the nearest double.
  double step() const;
  mpq_class exact_step() const;

 private:
  int exponent_ = 0;   // without a snap: step = 2^exponent_
  mpq_class unit_{1};  // with a snap: step = unit_
  std::array<Integer, 3> origin_;
  int unit_bits_ = 1;
  int bits_ = 0;
  std::string snap_;
};

}  // namespace sightline
