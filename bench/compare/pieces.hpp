// What the peers are fed with: the scene's convex pieces by corners, and these in the window of a camera.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sightline::peers {

/// Convex planar polygons, flat. Piece k has corners[first[k] .. first[k+1]), vertices of the scene.
struct Pieces {
  std::vector<std::uint32_t> first{0};
  std::vector<PointId> corners;
  std::vector<PolygonId> polygon;
  std::uint32_t left_out = 0;  // polygons that cross themselves

  std::uint32_t size() const { return static_cast<std::uint32_t>(polygon.size()); }
  std::span<const PointId> of(std::uint32_t k) const {
    return std::span(corners).subspan(first[k], first[k + 1] - first[k]);
  }
};
Pieces pieces_of(const Scene& scene);

/// Pieces clipped by the view's four sides and mapped projectively, in doubles: (s, t, 1 / depth), so that planes stay
/// planes and the nearest has the largest third coordinate. Depth is in units of |forward|.
struct Projected {
  std::vector<std::uint32_t> first{0};
  std::vector<glm::dvec3> corners;
  std::vector<PolygonId> polygon;
  double nearest = 0;  // the largest third coordinate

  std::uint32_t size() const { return static_cast<std::uint32_t>(polygon.size()); }
  std::span<const glm::dvec3> of(std::uint32_t k) const {
    return std::span(corners).subspan(first[k], first[k + 1] - first[k]);
  }
};
/// Reuses `out`. Pieces seen edge-on (as far as doubles tell) are left out.
void project(const Scene& scene, const Pieces& pieces, const Camera& camera, Projected& out);

}  // namespace sightline::peers
