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

/// Are points so near the line that they may lie on it?
struct NearLine {
  glm::dvec3 n;
  double at_eye, bound;
  /// With u = 2^-53 and S = s.scale: a point (at most 1/2) is within u/2, the eye within uS and n within u, so that
  /// data carry 3 u + 6 uS, and products, sums and the difference 4 u + 8 uS + 5 uS: below 37 uS. An eye beyond what
  /// doubles hold makes everything near.
  NearLine(const State& s, SightlineId line)
      : n(s.table->approx(line)), at_eye(glm::dot(n, s.eye)), bound(0x1p-47 * s.scale) {}
  bool operator()(const glm::dvec3& p) const { return !(std::abs(glm::dot(n, p) - at_eye) > bound); }
};

}  // namespace

NearEdges near_edges(const State& s, SightlineId line, PolygonId polygon) {
  const NearLine near(s, line);
  const PointTable& points = s.scene->points();
  const std::span<const std::uint32_t> corners = s.scene->corners(polygon);
  NearEdges found{0, none, none};
  PointId last = corners.back();
  bool last_near = near(points.approx(last));
  for (const PointId corner : corners) {
    const bool corner_near = near(points.approx(corner));
    if (last_near && corner_near) {
      ++found.count;
      found.a = std::min(last, corner);
      found.b = std::max(last, corner);
    }
    last = corner;
    last_near = corner_near;
  }
  return found;
}

bool on_line(State& s, SightlineId line, PointId a, PointId b) {
  if (s.table->holds(line, a) && s.table->holds(line, b)) return a != b;
  return s.table->of_points(a, b).id == line;
}

static void place_carriers(State& s, const Stretch& stretch, const Shown& shown, bool diagonals,
                           std::vector<Carrier>& out) {
  const Scene& scene = *s.scene;
  const SightlineId line = stretch.line;
  const SightlineRef from = s.corners[stretch.from].across(line), to = s.corners[stretch.to].across(line);
  const NearLine near_line(s, line);
  const auto near = [&](PointId p) { return near_line(scene.points().approx(p)); };
  const auto try_edge = [&](PointId a, PointId b) {
    // The normal (a - eye) x (b - eye): b comes after a where it is opposite to N.
    bool b_after_a = a == s.table->points(line)[1];
    if (!on_line(s, line, a, b)) return;
    if (!s.table->holds(line, a) || !s.table->holds(line, b)) b_after_a = s.table->of_points(a, b).sign < 0;
    add_carrier(s, from, to, a, b, b_after_a, out);
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
  const auto in_plane = [&](PointId p) { return scene.planar(shown.polygon) || side_of(s, p, shown) == 0; };
  PointId last = corners.back();
  bool last_near = near(last);
  for (const PointId corner : corners) {
    const bool corner_near = near(corner);
    if (last_near && corner_near && in_plane(last) && in_plane(corner)) try_edge(last, corner);
    last = corner;
    last_near = corner_near;
  }
}

void find_carriers(State& s, const Stretch& stretch, const Shown& shown, bool diagonals, std::vector<Carrier>& out) {
  if (!diagonals && s.scene->planar(shown.polygon) && s.scene->surfaces(shown.polygon).size() == 1) {
    // Convex: what is seen of it beside the stretch reaches the line in the edges that lie there, so that a single one
    // carries all of it.
    const NearEdges edges = near_edges(s, stretch.line, shown.polygon);
    if (edges.count == 1 && on_line(s, stretch.line, edges.a, edges.b)) {
      out.push_back({edges.a, edges.b, none, none});
    }
    if (edges.count <= 1) return;
  }
  place_carriers(s, stretch, shown, diagonals, out);
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
