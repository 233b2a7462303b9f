// Exact points and lines of one plane, for the decomposition of polygons.
#pragma once

#include "exact/point_table.hpp"

#include <array>

namespace sightline {

/// A point of the plane in grid coordinates, with its unit coordinates in doubles, each within 2^-52.
struct PlanePoint {
  mpq_class x, y;
  double near_x, near_y;
};

/// The line a x + b y = c, directed: a x + b y > c on its left. The doubles are of the same line in unit coordinates,
/// a near_a multiple: near_a (x - near_x) + near_b (y - near_y), and |near_a|, |near_b| <= 1.
struct PlaneLine {
  Integer a, b, c;
  double near_a, near_b, near_x, near_y;
};

/// A view of the scene's points along an axis: x is the coordinate axis + 1, y the coordinate axis + 2.
class PlaneView {
 public:
  PlaneView(const PointTable& points, int axis) : points_(points), x_((axis + 1) % 3), y_((axis + 2) % 3) {}

  std::array<Integer, 2> grid(PointId p) const;
  PlanePoint point(PointId p) const { return point(grid(p)); }
  PlanePoint point(const std::array<Integer, 2>& grid) const;
  /// The line from p to q, which differ.
  PlaneLine line(const std::array<Integer, 2>& p, const std::array<Integer, 2>& q) const;
  /// The point in which two lines meet; they are not parallel.
  PlanePoint meet(const PlaneLine& l, const PlaneLine& m) const;

 private:
  PlanePoint point(mpq_class x, mpq_class y) const;
  double unit(const mpq_class& x) const;

  const PointTable& points_;
  int x_, y_;
};

/// The side of the line on which the point lies: +1 left, 0 on the line.
Sign side(const PlaneLine& line, const PlanePoint& p);

}  // namespace sightline
