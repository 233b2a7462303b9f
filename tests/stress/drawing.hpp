// A map in exact numbers, to be compared with another under a law: other names of polygons, a mirrored window, polygons
// that count as one.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/oracle/exact_map.hpp"

namespace sightline::stress {

/// The lesser end first. `outside` lies beyond the window.
struct DrawnEdge {
  oracle::Point a, b;
  PolygonId left, right;
  EdgeKind kind;
  PolygonId owner;
  bool operator==(const DrawnEdge&) const = default;
};
struct DrawnFace {
  PolygonId polygon;
  std::vector<PolygonId> coincident;  // ascending
  mpq_class area;                     // part of the window
};

/// Whatever a map says: its edges, which divide the window into faces, and what is seen in them.
struct Drawing {
  std::vector<DrawnEdge> edges;
  std::vector<DrawnFace> faces;
  std::map<oracle::Point, PointId> seen_vertices;  // where a scene vertex is seen: which
};

/// Throws std::runtime_error where a vertex of the map is nowhere.
Drawing drawing(const Scene& scene, const VisibilityMap& map);

using Naming = std::function<std::uint32_t(std::uint32_t)>;
/// Names polygons anew; `none` and `outside` stay. Two may get one name: see united.
Drawing renamed(Drawing drawing, const Naming& polygon);
/// Names scene vertices anew; those that become `none` are forgotten.
Drawing marked(Drawing drawing, const Naming& vertex);
/// s becomes 1 - s, t becomes 1 - t, or s becomes t.
Drawing mirrored(Drawing drawing, bool s, bool t);
/// Whatever bears one name counts as one: edges within it go, and those that now run on straight are joined; each
/// polygon has one face, with all that is coincident with it. An intersection counts as a crease, since the side of a
/// part may lie in it.
Drawing united(Drawing drawing);

/// What differs, a line each; empty: nothing.
std::string difference(const Drawing& expected, const Drawing& given);

}  // namespace sightline::stress
