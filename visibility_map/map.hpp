// The visibility map: a planar subdivision of the window into maximal regions that each see one polygon.
#pragma once

#include "scene/camera.hpp"
#include "scene/scene.hpp"

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace sightline {

/// Support of edges and vertices, named by the scene alone.
struct MapLine {
  enum Kind : std::uint8_t { window, edge, planes } kind;
  std::uint32_t v[6];  // window: v[0] = Window::Side; edge: scene vertices a < b; planes: three vertices of each plane
  bool operator==(const MapLine&) const = default;
};
struct MapVertex {
  glm::dvec2 st;          // nearest doubles; for a sphere map unused (0,0)
  glm::dvec3 direction;   // unit vector of the ray, rounded
  std::uint32_t line[2];  // two different sightlines that meet in it
  PointId scene_vertex;   // or none
};
enum class EdgeKind : std::uint8_t { silhouette, crease, seam, intersection, window };
struct MapEdge {
  std::uint32_t vertex[2];  // runs from vertex[0] to vertex[1]
  std::uint32_t line;
  std::uint32_t left, right;  // faces; none only outside the window
  EdgeKind kind;
  PolygonId owner;  // silhouette: the nearer polygon; otherwise none
};
struct MapFace {
  PolygonId polygon;  // none: nothing is hit
  std::uint32_t first_coincident, coincident_count;
  std::uint32_t first_loop, loop_count;
  double area;         // part of the window; 0 for a sphere map
  double solid_angle;  // steradians
};

/// In loops, e >= 0 is edge e forwards and -e-1 edge e backwards; the face lies on the left. Loop 0 of a face is its
/// outer boundary, counter-clockwise, the others are holes (on the sphere no loop is the outer one).
struct VisibilityMap {
  Camera camera;
  bool sphere = false;
  std::vector<MapLine> lines;
  std::vector<MapVertex> vertices;
  std::vector<MapEdge> edges;
  std::vector<MapFace> faces;
  std::vector<PolygonId> coincident;         // faces' lists, one after the other
  std::vector<std::uint32_t> first_edge{0};  // loop k: loop_edges[first_edge[k] .. first_edge[k+1])
  std::vector<std::int32_t> loop_edges;

  std::span<const PolygonId> coincident_of(const MapFace& f) const {
    return std::span(coincident).subspan(f.first_coincident, f.coincident_count);
  }
  std::span<const std::int32_t> loop(std::uint32_t k) const {
    return std::span(loop_edges).subspan(first_edge[k], first_edge[k + 1] - first_edge[k]);
  }
};

}  // namespace sightline
