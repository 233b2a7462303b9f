// The scene of the `.field` and `.bitfield` files in tests/corpus/fuzz.
#pragma once

#include "scene/scene.hpp"

namespace sightline::fuzz {

/// Two squares, one behind the other, and a triangle below both.
inline Scene sampled_scene() {
  PolygonSoup soup;
  soup.source = "sampled.obj";
  soup.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 0, 2},   {0, 0, 2}, {1, 1, 1}, {3, 1, 1},
                   {3, 1, 3}, {1, 1, 3}, {-1, -1, 0}, {1, 3, 0}, {1, 3, -1}};
  soup.corners = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  soup.first = {0, 4, 8, 11};
  return make_scene(std::move(soup));
}

}  // namespace sightline::fuzz
