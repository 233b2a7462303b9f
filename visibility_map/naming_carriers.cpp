// Which edges of a polygon carry an edge of the map.
#include "visibility_map/stitch_state.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

/// Where a point of the line's plane is seen, going round the line from the stretch's start: even places are rays (the
/// start, the end, and the rays opposite to them), odd ones the open arcs between.
enum Place : int { at_start, inside, at_end, after, behind_start, behind, behind_end, before };

/// u.(p - eye) > 0 exactly for the half turn that follows N x u.
Place place(State& s, SightlineRef from, SightlineRef to, PointId p) {
  static constexpr Place places[3][3] = {
      {before, behind_end, behind}, {at_start, at_start, behind_start}, {inside, at_end, after}};
  return places[s.table->side(from, p) + 1][s.table->side(to, p) + 1];
}

/// The line is known to hold the points; the segment's arc is the shorter way round.
void add_carrier(State& s, SightlineRef from, SightlineRef to, PointId a, PointId b, bool b_after_a,
                 std::vector<Carrier>& out) {
  const PointId first = b_after_a ? a : b, last = b_after_a ? b : a;
  const int p = place(s, from, to, first), q = place(s, from, to, last);
  // Going from p on to q, is the inside passed?
  if (p == q && p != inside) return;
  if (((inside - p) & 7) > ((q - p) & 7)) return;
  out.push_back({std::min(a, b), std::max(a, b), p == inside ? first : none, q == inside ? last : none});
}

}  // namespace

void find_carriers(State& s, const Stretch& stretch, const Shown& shown, bool diagonals, std::vector<Carrier>& out) {
  const Scene& scene = *s.scene;
  const SightlineRef from = s.corners[stretch.from].across(stretch.line);
  const SightlineRef to = s.corners[stretch.to].across(stretch.line);
  const glm::dvec3& n = s.table->approx(stretch.line);
  // With u = 2^-53 and S = s.scale: a point is within u/2, the eye within 2uS, their difference (at most 2S) within
  // 5uS; the product with n is within 3 (5 + 2) uS (data) + (3 * 2 + 4 + 6) uS (rounding) = 37 uS.
  const double bound = 0x1p-47 * s.scale;
  // An eye beyond what doubles hold makes everything near.
  const auto near = [&](PointId p) { return !(std::abs(glm::dot(n, scene.points().approx(p) - s.eye)) > bound); };
  const auto try_edge = [&](PointId a, PointId b) {
    const SightlineRef ref = s.table->of_points(a, b);
    if (ref.id != stretch.line) return;
    // The normal (a - eye) x (b - eye): b comes after a where it is opposite to N.
    add_carrier(s, from, to, a, b, ref.sign < 0, out);
  };
  if (diagonals) {
    for (const Surface& piece : scene.surfaces(shown.polygon)) {
      if (piece.plane != shown.plane) continue;
      for (const SurfaceEdge& edge : scene.edges(piece)) {
        if (near(edge.a) && near(edge.b)) try_edge(edge.a, edge.b);
      }
    }
    return;
  }
  const std::span<const std::uint32_t> corners = scene.corners(shown.polygon);
  const auto in_plane = [&](PointId p) {
    return scene.planar(shown.polygon) || point_side(scene.planes(), p, shown.plane) == 0;
  };
  PointId last = corners.back();
  bool last_near = near(last);
  for (const PointId corner : corners) {
    const bool corner_near = near(corner);
    if (last_near && corner_near && in_plane(last) && in_plane(corner)) try_edge(last, corner);
    last = corner;
    last_near = corner_near;
  }
}

NameKey best_name(const std::vector<Carrier>& carriers) {
  NameKey covering = no_name, touching = no_name;
  for (const Carrier& c : carriers) {
    const NameKey key = edge_key(c.a, c.b);
    touching = std::min(touching, key);
    if (c.covers()) covering = std::min(covering, key);
  }
  return covering != no_name ? covering : touching;
}

}  // namespace sightline::stitching
