// Pictures of a scene from its exact visibility map, without aliasing: photographs for tests, novel views.
#pragma once

#include <functional>

#include "photos/image.hpp"
#include "visibility_map/map.hpp"

namespace sightline {

/// The part of a face that lies in one pixel.
struct FacePart {
  std::uint32_t face;
  int i, j;           // the pixel
  double area;        // 0 to 1
  glm::dvec2 centre;  // of gravity, in pixels
};
/// Visits the parts of all faces, face by face and row by row, in a picture of that size; areas of a pixel's parts add
/// up to 1, to rounding. The corners of the map are taken as its `st`.
void visit_parts(const VisibilityMap& map, int width, int height, const std::function<void(const FacePart&)>& visit);

/// The colour, 0 to 255 a channel, of a polygon at a point of it.
using Shade = std::function<glm::dvec3(PolygonId polygon, const glm::dvec3& point)>;

/// The scene as the map's camera sees it. A pixel is the mixture, by area, of all that the map shows in it, however
/// small: a part of a polygon counts with the colour at its centre of gravity, a pixel that one polygon fills with the
/// mean of 3 x 3 points. Errors: std::invalid_argument for a sphere map or sides out of range.
Image render(const VisibilityMap& map, const Scene& scene, int width, int height, const Shade& shade,
             std::array<std::uint8_t, 3> sky = {200, 215, 230});

}  // namespace sightline
