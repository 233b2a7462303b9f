// Visibility maps in exact numbers, in a form that depends on the drawing alone: the oracle's own, and a given map's.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/oracle/view.hpp"
#include "visibility_map/map.hpp"

namespace sightline::oracle {

struct ExactFace {
  PolygonId polygon;  // none: nothing is hit
  std::vector<PolygonId> coincident;
  std::vector<std::vector<Point>> loops;  // corners only, each from its least point on, ascending
  auto operator<=>(const ExactFace&) const = default;
};
struct ExactEdge {
  Point ends[2];          // the lesser one first
  PolygonId left, right;  // the polygons beside it; on the window's border `outside`
  EdgeKind kind;
  PolygonId owner;
};
inline constexpr PolygonId outside = none - 1;

struct ExactMap {
  std::vector<std::string> faces, edges;        // each in words, sorted
  std::map<std::string, PointId> scene_vertex;  // by place in words: the scene vertex seen at a vertex of the map
  std::vector<std::string> faults;              // what a given map has wrong in itself
  bool kind_changes_inside = false;             // the kind changes in the middle of an edge, where no segment ends
};

/// By brute force: the arrangement of everything that may be a border, a ray for each of its faces, equal ones united.
ExactMap oracle_map(const Scene& scene, const Camera& camera);
/// A map of the kernel: its vertices computed again from the names of their lines.
ExactMap exact_map(const Scene& scene, const VisibilityMap& map);

/// Where the vertices of a map are, computed again from the lines that they are named by: normals of the lines and rays
/// through the eye, and places in the window. Fewer of them than the map has where one is nowhere in the window's
/// plane.
struct ExactPlaces {
  std::vector<Vec> lines, rays;
  std::vector<Point> points;
};
ExactPlaces exact_places(const Scene& scene, const VisibilityMap& map);

/// In words, for comparison and for messages.
std::string words(const Point& p);
std::string words(const ExactEdge& e);
std::string words(PolygonId polygon, const std::vector<PolygonId>& coincident, std::vector<std::vector<Point>> loops);

/// What differs, one line each; empty: the same drawing.
std::vector<std::string> differences(const ExactMap& oracle, const ExactMap& given);

}  // namespace sightline::oracle
