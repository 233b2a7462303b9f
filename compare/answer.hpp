// What a method says of one view, in a form that all methods share.
#pragma once

#include "scene/scene.hpp"
#include "visibility_map/map.hpp"

#include <glm/vec2.hpp>
#include <variant>
#include <vector>

namespace sightline::comparison {

/// A straight-line drawing of the window [0,1]^2: faces with the polygon that each shows (`none`: nothing is hit),
/// edges with the faces to their left and right (`none` outside the window).
struct Drawing {
  struct Edge {
    std::uint32_t from, to, left, right;
  };
  std::vector<glm::dvec2> corners;
  std::vector<Edge> edges;
  std::vector<PolygonId> polygons;  // of each face
};

/// One polygon (or `none`) a pixel. Pixel (x, y), at items[y * size + x], is the square of side 1 / size from
/// (x, y) / size; rows go upwards.
struct Pixels {
  std::uint32_t size = 0;
  std::vector<PolygonId> items;
};

struct Answer {
  std::vector<PolygonId> reported;  // as visible: ascending, nothing twice
  std::variant<Drawing, Pixels> shown;
};

/// The same of a map.
void draw(const VisibilityMap& map, Drawing& drawing);
/// Sorts the polygons, leaves out doubles and `none`.
void tidy(std::vector<PolygonId>& polygons);

}  // namespace sightline::comparison
