// Scenes and complexes that several tests use.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bsp/build.hpp"
#include "winged_pair/check.hpp"

namespace sightline::testing {

/// Polygons given by their corners, each with vertices of its own.
inline PolygonSoup soup_of(const std::vector<std::vector<glm::dvec3>>& polygons) {
  PolygonSoup soup;
  soup.source = "sample.obj";
  for (const auto& polygon : polygons) {
    for (const glm::dvec3& x : polygon) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(x);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

/// No surface, but points from (0,0,0) to (4,4,4): one triangle without area.
inline Scene empty_scene() { return make_scene(soup_of({{{0, 0, 0}, {2, 2, 2}, {4, 4, 4}}})); }

/// Two rectangles through each other, a third that overlaps the first in its plane, and a slanted triangle.
inline Scene crossing_scene() {
  return make_scene(soup_of({{{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}},
                             {{2, 1, 0}, {2, 3, 0}, {2, 3, 4}, {2, 1, 4}},
                             {{3, 1, 2}, {6, 1, 2}, {6, 3, 2}, {3, 3, 2}},
                             {{0, 0, 0}, {1, 3, 1}, {3, 1, 3}}}));
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

}  // namespace sightline::testing
