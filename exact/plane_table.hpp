// Interned canonical planes: coplanar polygons share one id.
#pragma once

#include "exact/limbs.hpp"
#include "exact/point_table.hpp"

#include <array>
#include <unordered_map>

namespace sightline {

/// A plane n.x = d in unit coordinates, scaled by a power of two so that the largest |n| lies in [1/2, 1]; each of the
/// four numbers is within 2^-53 of the exact one (|d| <= 2: planes of a scene meet its box).
struct ApproxPlane {
  double n[3];
  double d;
};

/// How a plane was first made; enough to make it again exactly from the scene's points. Written to .wp files.
struct PlaneSource {
  enum Kind : std::uint8_t { points, axis, wall } kind = points;
  std::uint32_t a = 0, b = 0, c = 0;  // points: three points; axis: a = axis, value is d; wall: points a, b; c = axis
};

/// Planes n.x = d on the grid, gcd-reduced, with the first non-zero component of n positive; equal planes get one id.
/// The side n.x > d is the plane's front.
class PlaneTable {
 public:
  struct Interned {
    PlaneId id = none;     // none: the plane is not defined (collinear points, a = b, the axis along a-b)
    bool flipped = false;  // the canonical normal is opposite to that of the definition
  };
  PlaneTable() = default;
  /// `points` must outlive the table (a Scene keeps both; copies of a table share the points).
  explicit PlaneTable(const PointTable& points) : points_(&points) {}

  /// The plane through three points; definition's normal (b-a) x (c-a): counter-clockwise seen from its front.
  Interned add_points(PointId a, PointId b, PointId c);
  /// The plane coordinate[axis] = value (grid units); never flipped.
  Interned add_axis(int axis, const Integer& value);
  /// The plane through points a and b that is parallel to an axis; definition's normal (b-a) x e_axis.
  Interned add_wall(PointId a, PointId b, int axis);

  std::uint32_t size() const { return static_cast<std::uint32_t>(approx_.size()); }
  const ApproxPlane& approx(PlaneId p) const { return approx_[p]; }
  const PlaneSource& source(PlaneId p) const { return source_[p]; }
  /// Component k of the plane: 0..2 the normal, 3 the offset d.
  Limbs component(PlaneId p, int k) const { return store_[4 * p + static_cast<std::uint32_t>(k)]; }
  Integer integer(PlaneId p, int k) const { return store_.integer(4 * p + static_cast<std::uint32_t>(k)); }
  std::uint32_t normal_bits(PlaneId p) const { return normal_bits_[p]; }  // the longest component of n
  std::uint32_t offset_bits(PlaneId p) const { return component(p, 3).bits; }
  /// The axis k with n = e_k, or -1.
  int axis(PlaneId p) const { return axis_[p]; }
  const PointTable& points() const { return *points_; }
  void rebind(const PointTable& points) { points_ = &points; }  // after the points have moved in memory

 private:
  Interned intern(const std::array<Integer, 3>& n, const Integer& d, const PlaneSource& source);

  const PointTable* points_ = nullptr;
  LimbStore store_;
  std::vector<ApproxPlane> approx_;
  std::vector<PlaneSource> source_;
  std::vector<std::uint32_t> normal_bits_;
  std::vector<std::int8_t> axis_;
  std::unordered_multimap<std::uint64_t, PlaneId> index_;
};

}  // namespace sightline
