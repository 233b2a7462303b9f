#include "bench/compare/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "exact/predicates.hpp"
#include "scene/triangulate.hpp"

namespace sightline::peers {

namespace {

void add(Pieces& out, PolygonId polygon, std::span<const PointId> corners) {
  out.corners.insert(out.corners.end(), corners.begin(), corners.end());
  out.first.push_back(static_cast<std::uint32_t>(out.corners.size()));
  out.polygon.push_back(polygon);
}

/// Triangles of a polygon's own corners; none where the polygon crosses itself.
std::vector<Triangle> triangles_of(const Scene& scene, PolygonId polygon) {
  std::vector<Triangle> out = triangulate(scene.points(), scene.corners(polygon));
  for (int axis = 0; axis < 3; ++axis) {
    bool left = false, right = false;
    for (const Triangle& t : out) {
      const Sign turn = orientation(scene.points(), t[0], t[1], t[2], axis);
      left |= turn > 0;
      right |= turn < 0;
    }
    if (left && right) return {};
  }
  return out;
}

}  // namespace

Pieces pieces_of(const Scene& scene) {
  Pieces out;
  std::vector<PointId> loop;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    const auto surfaces = scene.surfaces(p);
    const auto at_vertices = [&](const Surface& s) {
      return std::ranges::none_of(scene.edges(s), [](const SurfaceEdge& e) { return e.corner == none; });
    };
    if (std::ranges::all_of(surfaces, at_vertices)) {
      for (const Surface& s : surfaces) {
        loop.clear();
        for (const SurfaceEdge& e : scene.edges(s)) loop.push_back(e.corner);
        add(out, p, loop);
      }
      continue;
    }
    const std::vector<Triangle> triangles = triangles_of(scene, p);
    for (const Triangle& t : triangles) add(out, p, t);
    if (triangles.empty()) ++out.left_out;
  }
  return out;
}

namespace {

/// How far inside of a side of the view a point in camera coordinates (depth, right, up) is.
double inside(const glm::dvec3& p, int side) {
  switch (side) {
    case 0:
      return p.x / 2 + p.y;
    case 1:
      return p.x / 2 - p.y;
    case 2:
      return p.x / 2 + p.z;
    default:
      return p.x / 2 - p.z;
  }
}

void clip(std::vector<glm::dvec3>& loop, std::vector<glm::dvec3>& spare, int side) {
  spare.clear();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const glm::dvec3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
    const double a = inside(p, side), b = inside(q, side);
    if (a >= 0) spare.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) spare.push_back(p + (q - p) * (a / (a - b)));
  }
  loop.swap(spare);
}

}  // namespace

void project(const Scene& scene, const Pieces& pieces, const Camera& camera, Projected& out) {
  out.first.assign(1, 0);
  out.corners.clear();
  out.polygon.clear();
  out.nearest = 0;
  const glm::dvec3 f = camera.forward, r = camera.right, u = camera.up;
  const double volume = glm::dot(f, glm::cross(r, u));
  const glm::dvec3 depth = glm::cross(r, u) / volume, right = glm::cross(u, f) / volume, up = glm::cross(f, r) / volume;
  const std::vector<glm::dvec3>& vertices = scene.soup().vertices;
  std::vector<glm::dvec3> loop, spare;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    loop.clear();
    unsigned outside = 15;  // sides that every corner is beyond
    for (const PointId v : pieces.of(k)) {
      const glm::dvec3 from = vertices[v] - camera.eye;
      loop.emplace_back(glm::dot(depth, from), glm::dot(right, from), glm::dot(up, from));
      for (int side = 0; side < 4; ++side) {
        if (inside(loop.back(), side) > 0) outside &= ~(1U << side);
      }
    }
    if (outside != 0) continue;
    for (int side = 0; side < 4 && !loop.empty(); ++side) clip(loop, spare, side);
    if (loop.size() < 3 || std::ranges::any_of(loop, [](const glm::dvec3& p) { return !(p.x > 0); })) continue;
    double area = 0;
    for (glm::dvec3& p : loop) p = {p.y / p.x + 0.5, p.z / p.x + 0.5, 1 / p.x};
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const glm::dvec3 a = loop[i] - loop[0], b = loop[i + 1] - loop[0];
      area += a.x * b.y - a.y * b.x;
    }
    if (!(std::abs(area) > 1e-14)) continue;
    for (const glm::dvec3& p : loop) out.nearest = std::max(out.nearest, p.z);
    out.corners.insert(out.corners.end(), loop.begin(), loop.end());
    out.first.push_back(static_cast<std::uint32_t>(out.corners.size()));
    out.polygon.push_back(pieces.polygon[k]);
  }
}

}  // namespace sightline::peers
