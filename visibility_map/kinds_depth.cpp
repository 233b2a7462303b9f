// Which of the two planes beside a stretch of a line is nearer.
#include "visibility_map/kinds_depth.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

/// n.eye - d. |n_i| <= 1, |d| <= 2, the eye at most S = s.scale and within 2uS (u = 2^-53): data 3 (2 + 1) uS + u,
/// products 3 uS, sums (2 + 3 + 5) uS: below 32 uS. At most 5 S.
double at_eye(const State& s, PlaneId p) {
  const ApproxPlane& a = s.scene->planes().approx(p);
  return a.n[0] * s.eye.x + a.n[1] * s.eye.y + a.n[2] * s.eye.z - a.d;
}

double along(const State& s, PlaneId p, const glm::dvec3& r) {
  const ApproxPlane& a = s.scene->planes().approx(p);
  return a.n[0] * r.x + a.n[1] * r.y + a.n[2] * r.z;
}

/// Plane p is hit by the ray r at t with 1/t = -n_p.r / P(eye); p is nearer where its 1/t is larger, that is where
/// D = P(eye) n_q.r - Q(eye) n_p.r has the sign of P(eye) Q(eye).
/// Rays have components at most 2, within 9u: n.r is within 3 (9 + 2) u (data) + (6 + 10) u (rounding) < 64u, at most
/// 6. D is within 2 (5S 64u + 6 32uS + 30uS) + 60uS < 1024 uS.
Sign filter_nearer(double at_p, double at_q, double along_p, double along_q, double scale) {
  const double eye_bound = 0x1p-48 * scale, bound = 0x1p-43 * scale;
  if (!(std::abs(at_p) > eye_bound && std::abs(at_q) > eye_bound)) return uncertain;
  const double d = at_p * along_q - at_q * along_p;
  if (!(std::abs(d) > bound)) return uncertain;
  return (d > 0) == (at_p * at_q > 0) ? 1 : -1;
}

/// Parallel planes seen along one ray lie on the same side of the eye: q is nearer if it lies on the eye's side of p.
Sign nearer_of_parallel(State& s, PlaneId p, const Shown& q) {
  for (const Surface& piece : s.scene->surfaces(q.polygon)) {
    if (piece.plane != q.plane) continue;
    const PointId on_q = s.scene->edges(piece)[0].a;
    return point_side(s.scene->planes(), on_q, p) == s.table->eye_side(p) ? -1 : 1;
  }
  throw std::logic_error("stitch: a fragment's surface is not its polygon's");
}

bool has_corner(const Scene& scene, const Shown& shown, PointId p) {
  if (scene.planar(shown.polygon)) {
    for (const PointId corner : scene.corners(shown.polygon)) {
      if (corner == p) return true;
    }
    return false;
  }
  for (const Surface& piece : scene.surfaces(shown.polygon)) {
    if (piece.plane != shown.plane) continue;
    for (const SurfaceEdge& edge : scene.edges(piece)) {
      if (edge.a == p || edge.b == p) return true;
    }
  }
  return false;
}

}  // namespace

Sign side_of(const State& s, PointId p, const Shown& shown) {
  if (has_corner(*s.scene, shown, p)) {
    ++tally().identity;
    return 0;
  }
  return point_side(s.scene->planes(), p, shown.plane);
}

Depths filter_depths(const State& s, const Stretch& stretch, PlaneId p, PlaneId q) {
  const double at_p = at_eye(s, p), at_q = at_eye(s, q);
  const glm::dvec3 &a = s.corners[stretch.from].approx, &b = s.corners[stretch.to].approx;
  return {filter_nearer(at_p, at_q, along(s, p, a), along(s, q, a), s.scale),
          filter_nearer(at_p, at_q, along(s, p, b), along(s, q, b), s.scale)};
}

Depths carried_depths(State& s, const std::vector<Carrier>& carriers, const Shown& q) {
  for (const Carrier& c : carriers) {
    const Sign a = side_of(s, c.a, q), b = side_of(s, c.b, q);
    if (a == 0 && b == 0) return {0, 0};
    if (!c.covers() || a * b < 0) continue;
    const Sign nearer = (a != 0 ? a : b) == s.table->eye_side(q.plane) ? 1 : -1;
    return {nearer, nearer};
  }
  return {uncertain, uncertain};
}

Depths exact_depths(State& s, const Stretch& stretch, const Shown& p, const Shown& q) {
  const SightlineRef equal = s.table->of_planes(p.plane, q.plane);
  if (equal.id == none) {
    const Sign nearer = nearer_of_parallel(s, p.plane, q);
    return {nearer, nearer};
  }
  // D above is the product with the normal P(eye) n_q - Q(eye) n_p of `equal`; a corner is N x n_u.
  const Sign eyes = s.table->eye_side(p.plane) * s.table->eye_side(q.plane);
  const auto at = [&](CornerId c) {
    return eyes * s.table->order(equal, {stretch.line, 1}, s.corners[c].across(stretch.line));
  };
  return {at(stretch.from), at(stretch.to), equal};
}

}  // namespace sightline::stitching
