// A model's polygons in whole 1/64, and exact rays among them.
#pragma once

#include "models/model.hpp"

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace sightline::models_test {

using Vector = glm::vec<3, std::int64_t>;
__extension__ using Wide = __int128;

inline Vector whole(const glm::dvec3& v) {
  const glm::dvec3 scaled = v * 64.0;
  const Vector result(static_cast<std::int64_t>(scaled.x), static_cast<std::int64_t>(scaled.y),
                      static_cast<std::int64_t>(scaled.z));
  if (glm::dvec3(result) != scaled) throw std::domain_error("not a multiple of 1/64");
  return result;
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Exact for coordinates below 2^22: normals stay below 2^47.
inline Wide dot(const Vector& a, const Vector& b) { return Wide(a.x) * b.x + Wide(a.y) * b.y + Wide(a.z) * b.z; }

/// A polygon with the normal that Newell's sum gives: of its whole area, whether it is convex or not.
struct Polygon {
  std::vector<Vector> corners;
  Vector normal{0};
};

inline std::vector<Polygon> whole_polygons(const PolygonSoup& soup) {
  std::vector<Polygon> polygons(soup.first.size() - 1);
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    Polygon& polygon = polygons[k];
    for (std::uint32_t i = soup.first[k]; i < soup.first[k + 1]; ++i) {
      polygon.corners.push_back(whole(soup.vertices[soup.corners[i]]));
    }
    for (std::size_t i = 2; i < polygon.corners.size(); ++i) {
      polygon.normal += cross(polygon.corners[i - 1] - polygon.corners[0], polygon.corners[i] - polygon.corners[0]);
    }
  }
  return polygons;
}

/// Where a ray meets a polygon: at origin + (along / of) direction, of > 0.
struct Hit {
  bool any = false, from_front = false;
  Wide along = 0, of = 1;
};

/// The hit of the whole line, in front of the origin or behind. Along the line (u, v) does not change, so that it is a
/// point in a plane; points on an edge count to one side of it. A line in the polygon's plane does not meet it.
inline Hit hit(const Polygon& polygon, const Vector& origin, const Vector& direction) {
  const Wide slope = dot(polygon.normal, direction);
  if (slope == 0) return {};
  const int k = direction.z != 0 ? 2 : direction.y != 0 ? 1 : 0;
  const auto sheared = [&](const Vector& p, int axis) {
    return Wide(p[axis] - origin[axis]) * direction[k] - Wide(p[k] - origin[k]) * direction[axis];
  };
  bool inside = false;
  const std::size_t n = polygon.corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector &a = polygon.corners[i], &b = polygon.corners[(i + 1) % n];
    const Wide au = sheared(a, (k + 1) % 3), av = sheared(a, (k + 2) % 3);
    const Wide bu = sheared(b, (k + 1) % 3), bv = sheared(b, (k + 2) % 3);
    if ((av > 0) == (bv > 0)) continue;
    const Wide side = au * bv - bu * av;
    if (bv > av ? side > 0 : side < 0) inside = !inside;
  }
  if (!inside) return {};
  const Wide distance = dot(polygon.normal, polygon.corners[0] - origin);
  return {true, slope<0, slope> 0 ? distance : -distance, slope > 0 ? slope : -slope};
}

}  // namespace sightline::models_test
