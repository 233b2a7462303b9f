#include "flat_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sightline::test {
namespace {

std::size_t next(std::size_t k, std::size_t n) { return k + 1 == n ? 0 : k + 1; }

Flat meet(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
  const mpq_class ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const mpq_class t = ((c.x - a.x) * vy - (c.y - a.y) * vx) / (ux * vy - uy * vx);
  return {a.x + t * ux, a.y + t * uy};
}

std::size_t as_size(int axis) { return static_cast<std::size_t>(axis); }

/// The value n.p - d of a wall, which is parallel to the axis, for a point of the view along it.
mpq_class wall_value(const Scene& scene, PlaneId wall, const Flat& p, int axis) {
  const PlaneTable& planes = scene.planes();
  EXPECT_EQ(planes.integer(wall, axis), 0);
  return planes.integer(wall, (axis + 1) % 3) * p.x + planes.integer(wall, (axis + 2) % 3) * p.y -
         planes.integer(wall, 3);
}

mpq_class plane_value(const Scene& scene, PlaneId plane, PointId p) {
  const auto c = scene.points().point(p);
  Integer value = -scene.planes().integer(plane, 3);
  for (int k = 0; k < 3; ++k) value += scene.planes().integer(plane, k) * c[as_size(k)];
  return value;
}

}  // namespace

mpq_class twice_area(const FlatLoop& loop) {
  mpq_class sum;
  for (std::size_t k = 0; k < loop.size(); ++k) sum += cross({0, 0}, loop[k], loop[next(k, loop.size())]);
  return sum;
}

mpq_class twice_even_odd_area(const FlatLoop& loop) {
  const std::size_t n = loop.size();
  std::vector<mpq_class> stops;
  for (const Flat& p : loop) stops.push_back(p.x);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Flat &a = loop[i], &b = loop[next(i, n)], &c = loop[k], &d = loop[next(k, n)];
      if ((b.x - a.x) * (d.y - c.y) != (b.y - a.y) * (d.x - c.x)) stops.push_back(meet(a, b, c, d).x);
    }
  }
  std::sort(stops.begin(), stops.end());
  mpq_class sum;
  for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
    const mpq_class &left = stops[s], &right = stops[s + 1];
    if (left == right) continue;
    const mpq_class middle = (left + right) / 2;
    std::vector<mpq_class> heights;  // of the edges over the middle; the trapezoid's area is its middle height x width
    for (std::size_t i = 0; i < n; ++i) {
      const Flat &a = loop[i], &b = loop[next(i, n)];
      if ((a.x < middle) == (b.x < middle)) continue;
      heights.push_back(a.y + (b.y - a.y) * (middle - a.x) / (b.x - a.x));
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 0; i + 1 < heights.size(); i += 2) sum += 2 * (heights[i + 1] - heights[i]) * (right - left);
  }
  return sum;
}

int winding_number(const FlatLoop& loop, const Flat& p) {
  int turns = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Flat &a = loop[k], &b = loop[next(k, loop.size())];
    if (a.y <= p.y && b.y > p.y && cross(a, b, p) > 0) ++turns;
    if (b.y <= p.y && a.y > p.y && cross(a, b, p) < 0) --turns;
  }
  return turns;
}

Flat flat(const Scene& scene, PointId p, int axis) {
  const auto c = scene.points().point(p);
  return {c[as_size((axis + 1) % 3)], c[as_size((axis + 2) % 3)]};
}

FlatLoop flat_loop(const Scene& scene, PolygonId p, int axis) {
  FlatLoop loop;
  for (const PointId v : scene.corners(p)) loop.push_back(flat(scene, v, axis));
  return loop;
}

int axis_of(const Scene& scene, const Surface& s) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (abs(scene.planes().integer(s.plane, k)) > abs(scene.planes().integer(s.plane, axis))) axis = k;
  }
  return axis;
}

Sign slope_of(const Scene& scene, const Surface& s) { return sgn(scene.planes().integer(s.plane, axis_of(scene, s))); }

FlatLoop flat_corners(const Scene& scene, const Surface& s) {
  const int axis = axis_of(scene, s);
  const auto edges = scene.edges(s);
  FlatLoop corners;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const SurfaceEdge &e = edges[k], &f = edges[next(k, edges.size())];
    corners.push_back(
        meet(flat(scene, e.a, axis), flat(scene, e.b, axis), flat(scene, f.a, axis), flat(scene, f.b, axis)));
  }
  return corners;
}

void expect_sound_surface(const Scene& scene, const Surface& s) {
  const int axis = axis_of(scene, s);
  const Sign slope = slope_of(scene, s);
  const auto edges = scene.edges(s);
  const std::size_t n = edges.size();
  ASSERT_GE(n, 3u);
  // Along the axis a plane of negative slope is seen from its back.
  for (std::size_t k = 0; k < n; ++k) {
    const Flat a = flat(scene, edges[k].a, axis), b = flat(scene, edges[k].b, axis);
    const Flat c = flat(scene, edges[next(k, n)].a, axis), d = flat(scene, edges[next(k, n)].b, axis);
    ASSERT_EQ(sgn(mpq_class((b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x))), slope) << "a turn, edge " << k;
  }
  const FlatLoop corners = flat_corners(scene, s);
  EXPECT_EQ(sgn(twice_area(corners)), slope);
  for (std::size_t k = 0; k < n; ++k) {
    const SurfaceEdge& e = edges[k];
    const Flat a = flat(scene, e.a, axis), b = flat(scene, e.b, axis);
    const Flat &from = corners[k == 0 ? n - 1 : k - 1], &to = corners[k];
    EXPECT_GT((b.x - a.x) * (to.x - from.x) + (b.y - a.y) * (to.y - from.y), 0) << "direction of edge " << k;
    EXPECT_EQ(plane_value(scene, s.plane, e.a), 0);
    EXPECT_EQ(plane_value(scene, s.plane, e.b), 0);
    EXPECT_EQ(wall_value(scene, e.wall, a, axis), 0);
    EXPECT_EQ(wall_value(scene, e.wall, b, axis), 0);
    for (std::size_t i = 0; i < n; ++i) {
      const Sign side = sgn(wall_value(scene, e.wall, corners[i], axis));
      EXPECT_EQ(side, i == k || next(i, n) == k ? 0 : e.inside) << "edge " << k << " corner " << i;
    }
    if (e.corner != none) {
      EXPECT_EQ(flat(scene, e.corner, axis), to);
    }
    const auto own = scene.corners(s.polygon);
    for (const PointId p : {e.a, e.b}) EXPECT_NE(std::find(own.begin(), own.end(), p), own.end());
    const auto is_here = [&](PointId p) { return flat(scene, p, axis) == to && plane_value(scene, s.plane, p) == 0; };
    EXPECT_EQ(e.corner != none, std::any_of(own.begin(), own.end(), is_here)) << "corner of edge " << k;
  }
}

}  // namespace sightline::test
