// Corners: the rays in which the fragments' lines meet.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Components of normals are at most 1 and within u = 2^-53, so a component of the product is within 4u (inputs) + 2u
/// (rounded products) + 2u (rounded difference) + O(u^2) < 9u. Where the product is short, that says little about the
/// ray's direction, and it is computed exactly instead.
glm::dvec3 approximate(const SightlineTable& table, SightlineId low, SightlineId high) {
  const glm::dvec3 r = glm::cross(table.approx(low), table.approx(high));
  return largest(r) >= 0x1p-10 ? r : table.corner(low, high);
}

void create(State& s, const FragmentCorner& corner) {
  s.corners.push_back({corner, approximate(*s.table, corner.low, corner.high) * static_cast<double>(corner.sign)});
}

}  // namespace

CornerId add_corner(State& s, SightlineId line, SightlineRef u) {
  s.rays.add();
  s.degree.push_back(2);
  create(s, FragmentCorner::of(u, {line, 1}));
  return static_cast<CornerId>(s.corners.size() - 1);
}

void take_corners(State& s) {
  const Fragments& f = *s.fragments;
  s.corners.clear();
  if (f.rays.size() == f.corners.size()) {
    for (std::size_t k = 0; k < f.corners.size(); ++k) s.corners.push_back({f.corners[k], f.rays[k]});
  } else {
    for (const FragmentCorner& corner : f.corners) create(s, corner);
  }
  s.rays.reset(s.corners.size());
  for (const auto& [a, b] : f.same) s.rays.unite(a, b);
}

}  // namespace sightline::stitching
