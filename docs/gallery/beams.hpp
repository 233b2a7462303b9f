// Beams made visible: where they cross the faces of the winged-pair.
#pragma once

#include "visibility_map/map.hpp"
#include "winged_pair/complex.hpp"

namespace sightline::gallery {

/// The outlines, in the window, of every beam of engine `cells` at every face that it meets, as closed polylines.
std::vector<std::vector<glm::dvec2>> beam_outlines(const Scene& scene, const Complex& complex, const Camera& camera);

}  // namespace sightline::gallery
