// The subdivision of the plane by line segments, exactly. CGAL behind a plain interface.
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

namespace sightline::oracle {

struct Point {
  mpq_class x, y;
  bool operator==(const Point& o) const { return x == o.x && y == o.y; }
  bool operator<(const Point& o) const { return x < o.x || (x == o.x && y < o.y); }
};
using Segment = std::pair<Point, Point>;

/// A half-edge runs from `origin` to its twin's origin with its face on the left; `next` follows on that face's border.
struct HalfEdge {
  std::uint32_t origin, twin, next, face;
};

struct Arrangement {
  std::vector<Point> points;
  std::vector<HalfEdge> half_edges;
  /// One half-edge of each border component of each face; of a bounded face the outer one first. Face 0 is unbounded.
  std::vector<std::vector<std::uint32_t>> faces;

  const Point& origin(std::uint32_t h) const { return points[half_edges[h].origin]; }
  const Point& target(std::uint32_t h) const { return origin(half_edges[h].twin); }
};

/// Segments may cross, touch, overlap and be repeated; each must have two different ends.
Arrangement arrange(const std::vector<Segment>& segments);

}  // namespace sightline::oracle
