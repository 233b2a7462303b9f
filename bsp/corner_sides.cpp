#include "bsp/corner_sides.hpp"

#include "exact/tally.hpp"

namespace sightline {

/// The bound is that of a point against a plane, 32 units of 2^-53, and what the corner itself may be off by: at most
/// `error` along each axis, times components of at most 1.
Sign CornerSides::of(const PieceCorner& corner) {
  const ApproxPlane& q = planes_.approx(plane_);
  const glm::dvec3& p = corner.place.approx;
  const double value = q.n[0] * p.x + q.n[1] * p.y + q.n[2] * p.z - q.d;
  const double bound = 32 * 0x1p-53 + 3.25 * corner.place.error;
  if (value > bound || value < -bound) {
    ++tally().filter;
    return value > 0 ? 1 : -1;
  }
  return exact(corner);
}

Sign CornerSides::exact(const PieceCorner& corner) {
  const PlaneId* const named = corner.place.plane;
  if (plane_ == named[0] || plane_ == named[1] || plane_ == named[2] || plane_ == corner.side) {
    ++tally().identity;
    return 0;
  }
  if (corner.point != none) return point_side(planes_, corner.point, plane_);
  Sign found = uncertain;
  bool amid = true;  // the surface, not one of its sides
  for (std::size_t k = 0; k < edges_.size() && found == uncertain; ++k) {
    if (edges_[k].wall != named[1] && edges_[k].wall != named[2]) continue;
    amid = false;
    found = by_side(k, named[edges_[k].wall == named[1] ? 2 : 1]);
  }
  if (amid) found = by_surface();
  return found != uncertain ? found : vertex_side(planes_, corner.place, plane_);
}

Sign CornerSides::of_point(std::size_t k) {
  if (k >= remembered) return point_side(planes_, edges_[k].corner, plane_);
  if (sign_[k] == unknown) sign_[k] = static_cast<std::int8_t>(point_side(planes_, edges_[k].corner, plane_));
  return sign_[k];
}

/// A place on the line of a side, strictly between its ends where these are corners of the surface; where `cut` meets
/// it.
Sign CornerSides::by_side(std::size_t edge, PlaneId cut) {
  const SurfaceEdge& e = edges_[edge];
  const std::size_t before = edge == 0 ? edges_.size() - 1 : edge - 1;
  const bool whole = e.corner == e.b && edges_[before].corner == e.a;
  const Sign a = whole ? of_point(before) : point_side(planes_, e.a, plane_);
  const Sign b = whole ? of_point(edge) : point_side(planes_, e.b, plane_);
  if (a == 0 && b == 0) return 0;
  if (!whole) return uncertain;
  if (a * b < 0) return edge_vertex_side(planes_, cut, e.a, e.b, plane_);
  return a != 0 ? a : b;
}

/// A place strictly inside of the surface, which does not lie in the plane.
Sign CornerSides::by_surface() {
  Sign all = 0;
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    if (edges_[k].corner == none) return uncertain;
    const Sign s = of_point(k);
    if (s * all < 0) return uncertain;
    if (s != 0) all = s;
  }
  return all;
}

}  // namespace sightline
