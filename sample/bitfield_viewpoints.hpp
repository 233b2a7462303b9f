// From where samples are taken: cameras on a sphere around the scene, each with all of it in its window. (Meruvia and
// Strothotte, section 3.1.)
#pragma once

#include "scene/read.hpp"

#include <vector>

namespace sightline {

inline constexpr unsigned least_viewpoints = 4, most_viewpoints = 16384;

/// The middle of the bounding box of all polygons that have an area, rounded to 21 bits of the scene's size; the origin
/// for a scene without. All sphere cameras look at it, and directions are counted from it.
glm::dvec3 viewing_centre(const Scene& scene);

/// `count` cameras around viewing_centre(), a window of aspect 1 and `fov_degrees` high each, the whole scene within
/// it. 6: along the axes, both ways; 14: and towards the corners of a cube; any other number: along a spiral on which
/// every camera has the same share of the sphere. Eyes are rounded to 21 bits of the scene's size, so that they are
/// short. Throws std::invalid_argument for a count below least_viewpoints or above most_viewpoints, an angle that is
/// not between 1 and 150, or a scene too small or too large for doubles.
std::vector<CameraLine> sphere_cameras(const Scene& scene, unsigned count, double fov_degrees = 45);

}  // namespace sightline
