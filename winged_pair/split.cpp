#include "winged_pair/split.hpp"

#include <cassert>

#include "exact/tally.hpp"

namespace sightline {

void Splitter::join_clock(PairId before, PairId after) {
  c_.pairs[before].clock[1] = after;
  c_.pairs[after].clock[0] = before;
}

void Splitter::join_spin(PairId before, PairId after) {
  c_.pairs[before].spin[1] = after;
  c_.pairs[after].spin[0] = before;
}

void Splitter::make_room() {
  const auto grown = [](auto& states, std::size_t size) {
    if (states.size() < size) states.resize(size + size / 2 + 16, 0);
  };
  grown(vertex_state_, c_.vertices.size());
  grown(face_state_, c_.faces.size());
}

/// The bound is vertex_side's for what can lie in a complex: coordinates are at most 1.25, |d| at most 3, so the data's
/// part is 3.75 u + 3 error + 3 u, rounding 3.75 u for products and (2.5 + 3.75 + 6.75) u for sums, u = 2^-53.
Sign Splitter::side(const ImplicitVertex& at, PlaneId plane, const ApproxPlane& q) const {
  const double value = q.n[0] * at.approx.x + q.n[1] * at.approx.y + q.n[2] * at.approx.z - q.d;
  const double bound = 32 * 0x1p-53 + 3.25 * at.error;
  if (value > bound || value < -bound) {
    ++tally().filter;
    return value > 0 ? 1 : -1;
  }
  return vertex_side(c_.planes, at, plane);
}

VertexId Splitter::split_edge(EdgeId e, PlaneId plane) {
  const auto v = static_cast<VertexId>(c_.vertices.size());
  const auto rest = static_cast<EdgeId>(c_.edges.size());
  c_.vertices.push_back({make_vertex(c_.planes, c_.edges[e].plane[0], c_.edges[e].plane[1], plane), e});
  c_.edges.push_back(c_.edges[e]);
  const VertexId end = c_.edges[e].vertex[1];
  c_.edges[e].vertex[1] = v;
  c_.edges[rest].vertex[0] = v;
  if (c_.vertices[end].edge == e) c_.vertices[end].edge = rest;

  ring_.clear();
  for_pairs_of_edge(c_, e, [&](PairId p) { ring_.push_back(p); });
  const auto first = static_cast<PairId>(c_.pairs.size());
  for (const PairId p : ring_) {
    const auto q = static_cast<PairId>(c_.pairs.size());
    c_.pairs.push_back(c_.pairs[p]);
    c_.pairs[q].edge = rest;
    if (c_.pairs[p].direction == 0) {  // counter-clockwise: p, q, next
      join_clock(q, c_.pairs[p].clock[1]);
      join_clock(p, q);
    } else {  // previous, q, p
      join_clock(c_.pairs[p].clock[0], q);
      join_clock(q, p);
    }
  }
  const auto size = static_cast<PairId>(ring_.size());
  for (PairId k = 0; k < size; ++k) join_spin(first + k, first + (k + 1) % size);
  c_.edges[rest].pair = first;

  make_room();
  set_sign(v, 0);
  return v;
}

// The loop has vertices on both sides, and stands in a vertex wherever it meets the plane: convex, so in just two.
FaceId Splitter::split_face(FaceId f, PlaneId plane, EdgeId* between) {
  PairId to_front = none, to_back = none;  // the pairs that leave the plane for its front, for its back
  for_pairs_of_face(c_, f, [&](PairId p) {
    if (sign(pair_tail(c_, p)) != 0) return;
    const Sign head = sign(pair_head(c_, p));
    if (head > 0) to_front = p;
    if (head < 0) to_back = p;
  });
  assert(to_front != none && to_back != none);
  const VertexId u = pair_tail(c_, to_front), w = pair_tail(c_, to_back);
  const PairId last_back = c_.pairs[to_front].clock[0], last_front = c_.pairs[to_back].clock[0];

  const auto front = static_cast<FaceId>(c_.faces.size());
  const auto e = static_cast<EdgeId>(c_.edges.size());
  const auto q = static_cast<PairId>(c_.pairs.size());
  // The face behind, on the left of u -> w, has the plane's back on its left: u -> w is n_face x n_plane.
  c_.edges.push_back({{u, w}, q, {c_.faces[f].plane, plane}, none, none});
  c_.pairs.push_back({f, e, {none, none}, {q + 1, q + 1}, 0});
  c_.pairs.push_back({front, e, {none, none}, {q, q}, 1});
  c_.faces.push_back(c_.faces[f]);
  c_.faces[f].pair = q;
  c_.faces[front].pair = q + 1;
  for (PairId p = to_front;; p = c_.pairs[p].clock[1]) {
    c_.pairs[p].face = front;
    if (p == last_front) break;
  }
  join_clock(last_back, q);
  join_clock(q, to_back);
  join_clock(last_front, q + 1);
  join_clock(q + 1, to_front);
  *between = e;
  return front;
}

// The new face of the cell: its rim are all edges of the cell that lie on the plane, one face of the cell behind the
// plane and one in front at each.
FaceId Splitter::cap(CellId back, CellId front, PlaneId plane) {
  const auto f = static_cast<FaceId>(c_.faces.size());
  const auto first = static_cast<PairId>(c_.pairs.size());
  if (rim_at_.size() < c_.vertices.size()) rim_at_.resize(c_.vertices.size() + c_.vertices.size() / 2);
  for (const auto& [before, from_behind] : rim_) {
    const auto r = static_cast<PairId>(c_.pairs.size());
    const PairId after = c_.pairs[before].spin[1];
    // Direction 0: the front cell comes next. So it is if the face that we come from lies behind.
    c_.pairs.push_back({f, c_.pairs[before].edge, {none, none}, {none, none}, from_behind ? 0u : 1u});
    join_spin(before, r);
    join_spin(r, after);
    rim_at_[pair_tail(c_, r)] = r;
  }
  c_.faces.push_back({{back, front}, first, plane, 0});
  for (PairId r = first; r < c_.pairs.size(); ++r) join_clock(r, rim_at_[pair_head(c_, r)]);
  return f;
}

// Goes over the cell once: its faces, in the order of a breadth-first walk, and their sides of the plane; the edges
// that cross it, and those that lie on it. False if the cell lies on one side.
bool Splitter::walk(CellId cell, PlaneId plane) {
  ++now_;
  make_room();
  faces_.clear();
  crossing_.clear();
  rim_.clear();
  const ApproxPlane q = c_.planes.approx(plane);
  const auto reach = [&](FaceId f) {
    if (face_state_[f] >> 2 == now_) return;
    face_state_[f] = now_ << 2;
    faces_.push_back(f);
  };
  reach(c_.cells[cell].face);
  std::uint32_t all = 0;
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    const FaceId f = faces_[k];
    const std::uint32_t at_front = c_.faces[f].cell[1] == cell ? 1 : 0;
    std::uint32_t found = 0;
    for_pairs_of_face(c_, f, [&](PairId p) {
      const Pair& pair = c_.pairs[p];
      const bool cell_follows = pair.direction != at_front;  // around the edge, counter-clockwise after the pair
      const PairId across = pair.spin[cell_follows ? 1 : 0];
      const FaceId next = c_.pairs[across].face;
      reach(next);
      if (across < p) return;  // each edge once, for both faces
      const Edge& e = c_.edges[pair.edge];
      const Sign a = classify(e.vertex[0], plane, q), b = classify(e.vertex[1], plane, q);
      const std::uint32_t sides = (a < 0 || b < 0 ? 1u : 0u) | (a > 0 || b > 0 ? 2u : 0u);
      found |= sides;
      face_state_[next] |= sides;
      if (sides == 3) crossing_.push_back(pair.edge);
      if (sides == 0) rim_.push_back({cell_follows ? p : across, false});
    });
    face_state_[f] |= found;
    all |= found;
  }
  for (auto& [before, from_behind] : rim_) from_behind = (face_state_[c_.pairs[before].face] & 1) != 0;
  return all == 3;
}

Splitter::CellCut Splitter::cut_cell(CellId cell, PlaneId plane) {
  if (!walk(cell, plane)) return {};
  for (const EdgeId e : crossing_) split_edge(e, plane);
  const auto front = static_cast<CellId>(c_.cells.size());
  c_.cells.push_back({none});
  for (FaceId& f : faces_) {
    if ((face_state_[f] & 3) == 3) {
      EdgeId e;
      const FaceId part = split_face(f, plane, &e);
      const PairId behind = c_.edges[e].pair;  // the pair of the part behind, of direction 0; the other comes next
      const bool cell_follows = c_.faces[f].cell[1] == cell;
      rim_.push_back({cell_follows ? behind : c_.pairs[behind].spin[1], cell_follows});
      f = part;
    } else if ((face_state_[f] & 2) == 0) {
      continue;
    }
    for (CellId& side : c_.faces[f].cell) {
      if (side == cell) side = front;
    }
  }
  const FaceId f = cap(cell, front, plane);
  c_.cells[cell].face = f;
  c_.cells[front].face = f;
  return {front, f};
}

Splitter::FaceSide Splitter::classify_face(FaceId f, PlaneId plane) {
  make_room();
  bool behind = false, before = false;
  int on = 0;
  const ApproxPlane q = c_.planes.approx(plane);
  for_pairs_of_face(c_, f, [&](PairId p) {
    const VertexId v = pair_tail(c_, p);
    const Sign s = side(c_.vertices[v].place, plane, q);
    set_sign(v, s);
    behind |= s < 0;
    before |= s > 0;
    on += s == 0 ? 1 : 0;
  });
  const Side side = behind && before ? Side::crossed : before ? Side::front : Side::behind;
  return {side, side != Side::crossed && on > 1};
}

FaceId Splitter::cut_face(FaceId f, PlaneId plane, EdgeId* between) {
  crossing_.clear();
  for_pairs_of_face(c_, f, [&](PairId p) {
    if (sign(pair_tail(c_, p)) * sign(pair_head(c_, p)) < 0) crossing_.push_back(c_.pairs[p].edge);
  });
  for (const EdgeId e : crossing_) split_edge(e, plane);
  return split_face(f, plane, between);
}

}  // namespace sightline
