// What is shown by a renderer without error that is given only some of the polygons.
#pragma once

#include "compare/answer.hpp"

#include <span>

namespace sightline::comparison {

/// The exact map of these polygons alone, as a drawing with the scene's own indices: what it differs by from the whole
/// scene's map is the error of the set, and of nothing else. `polygons`: ascending, nothing twice.
void draw_subset(const Scene& scene, std::span<const PolygonId> polygons, const Camera& camera, Drawing& drawing);

}  // namespace sightline::comparison
