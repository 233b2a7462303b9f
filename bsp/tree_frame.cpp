#include "bsp/tree_frame.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {
namespace {

constexpr std::size_t looked_at = 256;  // surfaces
constexpr double alike = 1 - 0x1p-40;   // the least cosine of two normals of one direction
constexpr double upright = 0x1p-20;     // the most of two at right angles
constexpr double enough = 0.5;          // of what is looked at has to lie along the directions

struct Normal {
  glm::dvec3 unit;
  double area;
};

double area_of(const Scene& scene, const Surface& surface) {
  const PointTable& points = scene.points();
  const auto edges = scene.edges(surface);
  glm::dvec3 sum{0};
  for (const SurfaceEdge& e : edges) {
    const glm::dvec3 from = points.approx(edges[0].a);
    sum += glm::cross(points.approx(e.a) - from, points.approx(e.b) - from);
  }
  return glm::length(sum) / 2;
}

/// The normal with the largest area alike, among those at right angles to `first` where that is given.
const Normal* largest(const std::vector<Normal>& normals, const Normal* first) {
  const auto fits = [&](const Normal& n) { return !first || std::abs(glm::dot(n.unit, first->unit)) < upright; };
  const Normal* best = nullptr;
  double most = 0;
  for (const Normal& n : normals) {
    if (!fits(n)) continue;
    double area = 0;
    for (const Normal& other : normals) {
      if (std::abs(glm::dot(n.unit, other.unit)) > alike) area += other.area;
    }
    if (area > most) {
      most = area;
      best = &n;
    }
  }
  return best;
}

}  // namespace

TreeFrame::TreeFrame(const Scene& scene) {
  std::vector<Normal> normals;
  const auto surfaces = scene.surfaces();
  for (std::size_t k = 0; k < surfaces.size(); k += surfaces.size() / looked_at + 1) {
    const ApproxPlane& p = scene.planes().approx(surfaces[k].plane);
    normals.push_back({glm::normalize(glm::dvec3{p.n[0], p.n[1], p.n[2]}), area_of(scene, surfaces[k])});
  }
  const Normal* const first = largest(normals, nullptr);
  const Normal* const second = first ? largest(normals, first) : nullptr;
  if (!second) return;
  const glm::dvec3 u = first->unit, v = glm::normalize(second->unit - u * glm::dot(second->unit, u));
  const glm::dvec3 found[3] = {u, v, glm::normalize(glm::cross(u, v))};
  double along = 0, along_axes = 0, all = 0;
  for (const Normal& n : normals) {
    const auto lies = [&n](const glm::dvec3& d) { return std::abs(glm::dot(n.unit, d)) > alike; };
    all += n.area;
    if (std::any_of(std::begin(found), std::end(found), lies)) along += n.area;
    if (std::any_of(std::begin(direction_), std::end(direction_), lies)) along_axes += n.area;
  }
  turned_ = along > enough * all && along > along_axes;
  if (turned_) std::copy(std::begin(found), std::end(found), direction_);
}

}  // namespace sightline
