// Maps made by hand: what tests draw from.
#pragma once

#include "visibility_map/map.hpp"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <initializer_list>
#include <map>
#include <utility>

namespace sightline {

/// A camera at the origin that looks along y: a point (x, y, z) is seen at s = x/y + 1/2, t = z/y + 1/2.
inline Camera plain_camera() { return {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}; }

inline PolygonSoup soup(std::vector<glm::dvec3> vertices, std::initializer_list<std::vector<std::uint32_t>> polygons) {
  PolygonSoup result;
  result.source = "sketch.obj";
  result.vertices = std::move(vertices);
  for (const auto& polygon : polygons) {
    result.corners.insert(result.corners.end(), polygon.begin(), polygon.end());
    result.first.push_back(static_cast<std::uint32_t>(result.corners.size()));
  }
  return result;
}

/// Builds a map from faces given as loops of vertices; edges are made where two loops run along each other.
class Sketch {
 public:
  Sketch() {
    result.camera = plain_camera();
    for (std::uint32_t side = 0; side < 4; ++side) result.lines.push_back({MapLine::window, {side}});
  }

  std::uint32_t line(PointId a, PointId b) {
    const MapLine named{MapLine::edge, {std::min(a, b), std::max(a, b)}};
    for (std::uint32_t l = 0; l < result.lines.size(); ++l) {
      if (result.lines[l] == named) return l;
    }
    result.lines.push_back(named);
    return static_cast<std::uint32_t>(result.lines.size()) - 1;
  }
  std::uint32_t vertex(const glm::dvec2& st, std::uint32_t line0, std::uint32_t line1, PointId point = none) {
    result.vertices.push_back({st, glm::normalize(glm::dvec3(st.x - 0.5, 1, st.y - 0.5)), {line0, line1}, point});
    return static_cast<std::uint32_t>(result.vertices.size()) - 1;
  }
  /// Names the line, kind and owner of the edge between two vertices, once both of its sides are known.
  void edge(std::uint32_t a, std::uint32_t b, std::uint32_t line, EdgeKind kind, PolygonId owner = none) {
    index_[{a, b}] = static_cast<std::int32_t>(result.edges.size());
    result.edges.push_back({{a, b}, line, none, none, kind, owner});
  }
  /// A face by its loops' vertices, along edges already named.
  void face(PolygonId polygon, const std::vector<std::vector<std::uint32_t>>& loops, double area, double solid_angle,
            std::vector<PolygonId> coincident = {}) {
    const auto f = static_cast<std::uint32_t>(result.faces.size());
    result.faces.push_back({polygon, static_cast<std::uint32_t>(result.coincident.size()),
                            static_cast<std::uint32_t>(coincident.size()),
                            static_cast<std::uint32_t>(result.first_edge.size()) - 1,
                            static_cast<std::uint32_t>(loops.size()), area, solid_angle});
    result.coincident.insert(result.coincident.end(), coincident.begin(), coincident.end());
    for (const auto& loop : loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::uint32_t a = loop[k], b = loop[(k + 1) % loop.size()];
        if (const auto found = index_.find({a, b}); found != index_.end()) {
          result.edges[static_cast<std::size_t>(found->second)].left = f;
          result.loop_edges.push_back(found->second);
        } else {
          const std::int32_t e = index_.at({b, a});
          result.edges[static_cast<std::size_t>(e)].right = f;
          result.loop_edges.push_back(-e - 1);
        }
      }
      result.first_edge.push_back(static_cast<std::uint32_t>(result.loop_edges.size()));
    }
  }

  VisibilityMap result;

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int32_t> index_;
};

/// A small square (polygon 1, a quarter of the window) before a wall that fills the window (polygon 0).
struct SquareBeforeWall {
  static PolygonSoup polygons() {
    return soup({{-2, 2, -2},
                 {2, 2, -2},
                 {2, 2, 2},
                 {-2, 2, 2},
                 {-0.25, 1, -0.25},
                 {0.25, 1, -0.25},
                 {0.25, 1, 0.25},
                 {-0.25, 1, 0.25}},
                {{0, 1, 2, 3}, {4, 5, 6, 7}});
  }
  static VisibilityMap map() {
    Sketch sketch;
    const std::uint32_t bottom = sketch.line(4, 5), right = sketch.line(5, 6), top = sketch.line(6, 7),
                        left = sketch.line(4, 7);
    using W = std::uint32_t;
    const W corner[4] = {sketch.vertex({0, 0}, 0, 2), sketch.vertex({1, 0}, 1, 2), sketch.vertex({1, 1}, 1, 3),
                         sketch.vertex({0, 1}, 0, 3)};
    const W square[4] = {sketch.vertex({0.25, 0.25}, bottom, left, 4), sketch.vertex({0.75, 0.25}, bottom, right, 5),
                         sketch.vertex({0.75, 0.75}, right, top, 6), sketch.vertex({0.25, 0.75}, top, left, 7)};
    const W border[4] = {2, 1, 3, 0}, sides[4] = {bottom, right, top, left};
    for (W k = 0; k < 4; ++k) sketch.edge(corner[k], corner[(k + 1) % 4], border[k], EdgeKind::window);
    for (W k = 0; k < 4; ++k) sketch.edge(square[k], square[(k + 1) % 4], sides[k], EdgeKind::silhouette, 1);
    sketch.face(0, {{0, 1, 2, 3}, {4, 7, 6, 5}}, 0.75, 0.55);
    sketch.face(1, {{4, 5, 6, 7}}, 0.25, 0.235, {});
    return sketch.result;
  }
};

}  // namespace sightline
