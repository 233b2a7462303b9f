// The scene in doubles, as methods without exact arithmetic are fed with it.
#pragma once

#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace sightline {

/// The convex pieces of all polygons, flat: piece k has the corners [first[k], first[k+1]), counter-clockwise seen from
/// the side on which its polygon's own vertices run so. In unit coordinates (see Grid), each within 2^-53; where edges
/// of a polygon cross, what doubles make of the crossing.
struct Places {
  std::vector<std::uint32_t> first{0};
  std::vector<glm::dvec3> corners;
  std::vector<PolygonId> polygons;
  std::size_t size() const { return polygons.size(); }
  std::size_t bytes() const {
    return first.size() * sizeof(std::uint32_t) + corners.size() * sizeof(glm::dvec3) +
           polygons.size() * sizeof(PolygonId);
  }
  std::span<const glm::dvec3> of(std::size_t k) const {
    return std::span(corners).subspan(first[k], first[k + 1] - first[k]);
  }
};
Places places_of(const Scene& scene);
/// An eye in unit coordinates, moved by the scene's snap if it has one.
glm::dvec3 place_of_eye(const Scene& scene, const glm::dvec3& eye);

}  // namespace sightline
