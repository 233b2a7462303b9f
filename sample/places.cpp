#include "sample/places.hpp"

#include "exact/rounding.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

/// Where the lines of two sides of one piece meet.
glm::dvec3 crossing(const PointTable& points, const SurfaceEdge& e, const SurfaceEdge& f) {
  const glm::dvec3 &p = points.approx(e.a), &q = points.approx(f.a);
  const glm::dvec3 along = points.approx(e.b) - p, other = points.approx(f.b) - q;
  const glm::dvec3 normal = glm::cross(along, other);
  return p + glm::dot(glm::cross(q - p, other), normal) / glm::dot(normal, normal) * along;
}

}  // namespace

Places places_of(const Scene& scene) {
  Places out;
  const PointTable& points = scene.points();
  for (const Surface& s : scene.surfaces()) {
    const auto edges = scene.edges(s);
    const auto begin = static_cast<std::ptrdiff_t>(out.corners.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const SurfaceEdge& e = edges[k];
      out.corners.push_back(e.corner != none ? points.approx(e.corner)
                                             : crossing(points, e, edges[(k + 1) % edges.size()]));
    }
    if (s.flipped) std::reverse(out.corners.begin() + begin, out.corners.end());
    out.first.push_back(static_cast<std::uint32_t>(out.corners.size()));
    out.polygons.push_back(s.polygon);
  }
  return out;
}

glm::dvec3 place_of_eye(const Scene& scene, const glm::dvec3& eye) {
  const GridPoint p = scene.grid().point(eye);
  glm::dvec3 at;
  for (int k = 0; k < 3; ++k) {
    at[k] = nearest_double(p.c[static_cast<std::size_t>(k)], -scene.grid().unit_bits() - p.shift);
  }
  return at;
}

}  // namespace sightline
