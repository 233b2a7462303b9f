// Plain exact geometry of loops in a plane, in rationals: obvious, slow, and shared with nothing that it checks.
#pragma once

#include "scene/scene.hpp"

#include <gmpxx.h>

#include <vector>

namespace sightline::test {

struct Flat {
  mpq_class x, y;
  bool operator==(const Flat& o) const { return x == o.x && y == o.y; }
};
using FlatLoop = std::vector<Flat>;

inline mpq_class cross(const Flat& o, const Flat& a, const Flat& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// Twice the signed area.
mpq_class twice_area(const FlatLoop& loop);
/// Twice the area inside by the even-odd rule: trapezoids between consecutive abscissae of vertices and crossings.
mpq_class twice_even_odd_area(const FlatLoop& loop);
/// How often the loop runs around the point, counter-clockwise.
int winding_number(const FlatLoop& loop, const Flat& p);

/// The polygon's loop of a scene in the view along the axis, in grid coordinates.
Flat flat(const Scene& scene, PointId p, int axis);
FlatLoop flat_loop(const Scene& scene, PolygonId p, int axis);
/// The axis in which the surface's plane is steepest, and the sign of the normal's component there.
int axis_of(const Scene& scene, const Surface& s);
Sign slope_of(const Scene& scene, const Surface& s);
/// The corners of a surface in the view along its axis: corner k is where the lines of edges k and k + 1 meet.
FlatLoop flat_corners(const Scene& scene, const Surface& s);

/// Fails (by gtest) unless the surface is what scene.hpp promises: convex, counter-clockwise seen from the front of its
/// plane, edges directed, walls through them with the piece on their inner side, corners named rightly.
void expect_sound_surface(const Scene& scene, const Surface& s);

}  // namespace sightline::test
