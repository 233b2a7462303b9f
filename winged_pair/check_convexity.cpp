// Fourth stage: faces and cells are convex, and turn the right way.
#include "winged_pair/check_stages.hpp"
#include "winged_pair/traverse.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::check_detail {
namespace {

/// Sign of component `axis` of (b-a) x (c-a).
Sign filter_turn(const ImplicitVertex& a, const ImplicitVertex& b, const ImplicitVertex& c, int axis) {
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const double e = std::max({a.error, b.error, c.error});
  const double bx = b.approx[x] - a.approx[x], by = b.approx[y] - a.approx[y];
  const double cx = c.approx[x] - a.approx[x], cy = c.approx[y] - a.approx[y];
  const double turn = bx * cy - by * cx;
  // Unit coordinates are at most 1 in magnitude. Each difference is at most 2 and off by 2e + 2^-52; each product so by
  // 4 (2e + 2^-52) + (2e + 2^-52)^2 and, rounded, 2^-51 more; the last difference, below 8, adds 2^-50. Together less
  // than 17 e + 2^-47 for e < 2^-10.
  return turn > 32 * e + 0x1p-46 ? 1 : turn < -32 * e - 0x1p-46 ? -1 : uncertain;
}

Sign exact_turn(const PlaneTable& planes, const ImplicitVertex& a, const ImplicitVertex& b, const ImplicitVertex& c,
                int axis) {
  const auto x = static_cast<std::size_t>((axis + 1) % 3), y = static_cast<std::size_t>((axis + 2) % 3);
  const ExactVertex p = exact_vertex(planes, a.plane), q = exact_vertex(planes, b.plane),
                    r = exact_vertex(planes, c.plane);
  // The determinant of the rows (x, y, w), whose w are positive.
  const Integer turn = p.c[x] * (q.c[y] * r.w - r.c[y] * q.w) - p.c[y] * (q.c[x] * r.w - r.c[x] * q.w) +
                       p.w * (q.c[x] * r.c[y] - r.c[x] * q.c[y]);
  return sgn(turn);
}

/// Sign of the loop's turn about the face's canonical normal: +1 counter-clockwise seen from its front.
Sign loop_turn(const Complex& c, const Face& face, std::span<const PairId> loop) {
  const VertexId tail = pair_tail(c, loop[0]), head = pair_head(c, loop[0]);
  const PlaneId wall = wall_of(c.edges[c.pairs[loop[0]].edge], face.plane);
  const ApproxPlane& plane = c.planes.approx(face.plane);
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(plane.n[k]) > std::abs(plane.n[axis])) axis = k;
  }
  const Sign up = sgn(c.planes.integer(face.plane, axis));
  double largest = -1;
  VertexId apex = none;
  for (const PairId p : loop) {
    const VertexId v = pair_tail(c, p);
    if (vertex_side(c.planes, c.vertices[v].place, wall) == 0) continue;
    const glm::dvec3 d = c.vertices[v].place.approx - c.vertices[tail].place.approx;
    const double distance = d.x * d.x + d.y * d.y + d.z * d.z;
    if (distance > largest) largest = distance, apex = v;
  }
  if (apex == none) return 0;
  const ImplicitVertex &a = c.vertices[tail].place, &b = c.vertices[head].place, &d = c.vertices[apex].place;
  const Sign quick = filter_turn(a, b, d, axis);
  return up * (quick != uncertain ? quick : exact_turn(c.planes, a, b, d, axis));
}

/// All vertices on the plane, all on one side of every edge, counter-clockwise. With no two vertices alike (proved
/// before) that is a convex polygon, passed once.
void check_face(const Complex& c, FaceId f, std::span<const PairId> loop, Faults& faults) {
  const Face& face = c.faces[f];
  for (const PairId p : loop) {
    const VertexId v = pair_tail(c, p);
    if (vertex_side(c.planes, c.vertices[v].place, face.plane) != 0) {
      faults.add("face ", f, ": vertex ", v, " does not lie on its plane");
      return;
    }
  }
  for (const PairId p : loop) {
    const PlaneId wall = wall_of(c.edges[c.pairs[p].edge], face.plane);
    bool below = false, above = false;
    for (const PairId q : loop) {
      const Sign side = vertex_side(c.planes, c.vertices[pair_tail(c, q)].place, wall);
      below |= side < 0;
      above |= side > 0;
    }
    if (below == above) {
      faults.add("face ", f, ": not convex at edge ", c.pairs[p].edge);
      return;
    }
  }
  if (loop_turn(c, face, loop) != 1) faults.add("face ", f, ": its loop runs clockwise, seen from its front");
}

/// The direction in which the face of a pair leaves its edge, against the plane of another pair of the ring: +1 if
/// it turns counter-clockwise from that by less than half a turn, 0 if they point the same way or opposite ways.
Sign turn_between(const Complex& c, const Loops& loops, PairId from, PairId to) {
  const PlaneId plane = c.faces[c.pairs[from].face].plane;
  if (plane == c.faces[c.pairs[to].face].plane) return 0;
  const Sign side = side_of_face(c, loops.of(c.pairs[to].face), plane);
  return c.pairs[from].direction == 0 ? side : -side;
}

/// Counter-clockwise, every face of the ring lies beyond the one before, within one turn.
void check_ring(const Complex& c, EdgeId e, const Loops& loops, Faults& faults) {
  const PairId start = c.edges[e].pair;
  PairId before = start;
  int half = 0;  // where `before` lies from the start: 0 first half turn (or the start itself), 1 opposite, 2 second
  for (PairId p = c.pairs[start].spin[1]; p != start; p = c.pairs[p].spin[1]) {
    const Sign turn = turn_between(c, loops, start, p);
    const bool same = turn == 0 && c.pairs[p].direction == c.pairs[start].direction;
    const int here = turn > 0 ? 0 : turn == 0 ? 1 : 2;
    const bool beyond =
        here > half || (here == half && here != 1 && (before == start || turn_between(c, loops, before, p) > 0));
    if (same || !beyond) {
      faults.add("edge ", e, ": faces ", c.pairs[before].face, " and ", c.pairs[p].face,
                 " are not in counter-clockwise order around it");
      return;
    }
    before = p;
    half = here;
  }
}

/// The cell lies on the inner side of the planes of all its faces, and not in any of them.
void check_cell(const Complex& c, CellId k, const CellLists& lists, Faults& faults) {
  std::vector<std::pair<PlaneId, std::uint32_t>> planes;
  for (const CellLists::Side& s : lists.faces_of(k)) planes.emplace_back(c.faces[s.face].plane, s.side);
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  for (const auto& [plane, side] : planes) {
    const Sign inner = side == 0 ? -1 : 1;
    bool solid = false;
    for (const VertexId v : lists.vertices_of(k)) {
      const Sign s = vertex_side(c.planes, c.vertices[v].place, plane);
      solid |= s == inner;
      if (s != -inner) continue;
      faults.add("cell ", k, ": not convex: vertex ", v, " lies beyond plane ", plane, " of one of its faces");
      return;
    }
    if (!solid) {
      faults.add("cell ", k, ": has no volume: it lies in plane ", plane);
      return;
    }
  }
}

}  // namespace

void check_convexity(const Complex& c, Faults& faults) {
  const Loops loops = make_loops(c);
  for (FaceId f = 0; f < c.faces.size() && !faults.full(); ++f) check_face(c, f, loops.of(f), faults);
  if (!faults.empty()) return;
  for (EdgeId e = 0; e < c.edges.size() && !faults.full(); ++e) check_ring(c, e, loops, faults);
  const CellLists lists = make_cell_lists(c);
  for (CellId k = 0; k < c.cells.size() && !faults.full(); ++k) check_cell(c, k, lists, faults);
}

}  // namespace sightline::check_detail
