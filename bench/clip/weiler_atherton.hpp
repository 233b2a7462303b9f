// The baseline of Yu's tables: Weiler and Atherton's hidden surface removal, applied view after view.
#pragma once

#include <span>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sightline::bench {

/// In doubles, with a tolerance, as it was meant; so it is also given the quicker arithmetic.
struct WaPiece {
  PolygonId polygon;
  std::vector<glm::dvec3> corner;      // world coordinates
  std::vector<std::uint32_t> cameras;  // that see it
};

/// Each view takes all pieces of the view before: those that face the camera are clipped to its window, sorted by the
/// depth of their nearest corner, and from the front on each is used to clip all others: what lies within the pyramid
/// over it, and behind it, is hidden and goes no further in this view; what lies without stays in the list. Nothing is
/// put together again. Pieces below `threshold` in area are not cut; they count as seen. After `limit` seconds of
/// processor time it gives up: `views` is how many it has finished, and the pieces are those that it had come to then.
struct WaResult {
  std::vector<WaPiece> pieces;
  std::uint32_t views = 0;
};
WaResult weiler_atherton(const Scene& scene, std::span<const Camera> cameras, double threshold, double limit);

}  // namespace sightline::bench
