// Some polygons of a scene as a scene of its own.
#pragma once

#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace sightline {

/// Polygon k of `scene` is polygon original[k] of the whole. Vertices keep their indices, and everything that is
/// decided about a polygon alone (its pieces, where a snap puts it) is as in the whole. original is ascending, so that
/// of polygons in one place the same one owns it.
struct SubScene {
  Scene scene;
  std::vector<PolygonId> original;
};

/// `polygons`: ascending, nothing twice, all of the scene.
SubScene sub_scene(const Scene& scene, std::span<const PolygonId> polygons);

}  // namespace sightline
