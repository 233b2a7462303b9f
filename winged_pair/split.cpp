#include "winged_pair/split.hpp"

#include <cassert>

namespace sightline {

void Splitter::join_clock(PairId before, PairId after) {
  c_.pairs[before].clock[1] = after;
  c_.pairs[after].clock[0] = before;
}

void Splitter::join_spin(PairId before, PairId after) {
  c_.pairs[before].spin[1] = after;
  c_.pairs[after].spin[0] = before;
}

void Splitter::classify(VertexId v, PlaneId plane) {
  if (vertex_marks_.first(v)) sign_[v] = static_cast<std::int8_t>(vertex_side(c_.planes, c_.vertices[v].place, plane));
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

  vertex_marks_.grow(c_.vertices.size());
  if (sign_.size() < vertex_marks_.stamp.size()) sign_.resize(vertex_marks_.stamp.size());
  vertex_marks_.first(v);
  sign_[v] = 0;
  return v;
}

// The loop has vertices on both sides, and stands in a vertex wherever it meets the plane: convex, so in just two.
FaceId Splitter::split_face(FaceId f, PlaneId plane, EdgeId* between) {
  PairId to_front = none, to_back = none;  // the pairs that leave the plane for its front, for its back
  for_pairs_of_face(c_, f, [&](PairId p) {
    if (sign_[pair_tail(c_, p)] != 0) return;
    const Sign head = sign_[pair_head(c_, p)];
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
  rim_.clear();
  if (rim_at_.size() < c_.vertices.size()) rim_at_.resize(c_.vertices.size() + c_.vertices.size() / 2);
  for (const EdgeId e : edges_) {
    if (sign_[c_.edges[e].vertex[0]] != 0 || sign_[c_.edges[e].vertex[1]] != 0) continue;
    PairId before = none;  // counter-clockwise around the edge the cell comes after it
    for_pairs_of_edge(c_, e, [&](PairId p) {
      if (cell_after(c_, p) == back) before = p;
    });
    const PairId after = c_.pairs[before].spin[1];
    const auto r = static_cast<PairId>(c_.pairs.size());
    // Direction 0: the front cell comes next. So it is if the face that we come from lies behind.
    bool from_behind = false;
    for (PairId p = c_.pairs[before].clock[1]; p != before; p = c_.pairs[p].clock[1]) {
      const Sign s = sign_[pair_head(c_, p)];
      if (s != 0) {
        from_behind = s < 0;
        break;
      }
    }
    c_.pairs.push_back({f, e, {none, none}, {none, none}, from_behind ? 0u : 1u});
    join_spin(before, r);
    join_spin(r, after);
    rim_.push_back(r);
  }
  c_.faces.push_back({{back, front}, rim_[0], plane, 0});
  for (const PairId r : rim_) rim_at_[pair_tail(c_, r)] = r;
  for (const PairId r : rim_) join_clock(r, rim_at_[pair_head(c_, r)]);
  return f;
}

Splitter::CellCut Splitter::cut_cell(CellId cell, PlaneId plane) {
  faces_of_cell(c_, cell, face_marks_, faces_);
  vertex_marks_.begin(c_.vertices.size());
  if (sign_.size() < vertex_marks_.stamp.size()) sign_.resize(vertex_marks_.stamp.size());
  edge_marks_.begin(c_.edges.size());
  edges_.clear();
  bool any_back = false, any_front = false;
  for (const FaceId f : faces_) {
    for_pairs_of_face(c_, f, [&](PairId p) {
      const VertexId v = pair_tail(c_, p);
      classify(v, plane);
      any_back |= sign_[v] < 0;
      any_front |= sign_[v] > 0;
      if (edge_marks_.first(c_.pairs[p].edge)) edges_.push_back(c_.pairs[p].edge);
    });
  }
  if (!any_back || !any_front) return {};

  for (std::size_t k = 0, n = edges_.size(); k < n; ++k) {
    const Edge& e = c_.edges[edges_[k]];
    if (sign_[e.vertex[0]] * sign_[e.vertex[1]] < 0) split_edge(edges_[k], plane);
  }
  const auto front = static_cast<CellId>(c_.cells.size());
  c_.cells.push_back({none});
  for (std::size_t k = 0, n = faces_.size(); k < n; ++k) {
    bool behind = false, before = false;
    for_pairs_of_face(c_, faces_[k], [&](PairId p) {
      behind |= sign_[pair_tail(c_, p)] < 0;
      before |= sign_[pair_tail(c_, p)] > 0;
    });
    if (behind && before) {
      EdgeId e;
      faces_.push_back(split_face(faces_[k], plane, &e));
      edges_.push_back(e);
    }
  }
  // The rim is found while every face of the cell still names it; then the front ones pass to the new cell.
  const FaceId f = cap(cell, front, plane);
  for (const FaceId g : faces_) {
    bool before = false;
    for_pairs_of_face(c_, g, [&](PairId p) { before |= sign_[pair_tail(c_, p)] > 0; });
    if (!before) continue;
    for (CellId& side : c_.faces[g].cell) {
      if (side == cell) side = front;
    }
  }
  c_.cells[cell].face = f;
  c_.cells[front].face = f;
  return {front, f};
}

Splitter::Side Splitter::classify_face(FaceId f, PlaneId plane) {
  vertex_marks_.begin(c_.vertices.size());
  if (sign_.size() < vertex_marks_.stamp.size()) sign_.resize(vertex_marks_.stamp.size());
  bool behind = false, before = false;
  for_pairs_of_face(c_, f, [&](PairId p) {
    const VertexId v = pair_tail(c_, p);
    classify(v, plane);
    behind |= sign_[v] < 0;
    before |= sign_[v] > 0;
  });
  return behind && before ? Side::crossed : before ? Side::front : Side::behind;
}

FaceId Splitter::cut_face(FaceId f, PlaneId plane, EdgeId* between) {
  edges_.clear();
  for_pairs_of_face(c_, f, [&](PairId p) {
    if (sign_[pair_tail(c_, p)] * sign_[pair_head(c_, p)] < 0) edges_.push_back(c_.pairs[p].edge);
  });
  for (const EdgeId e : edges_) split_edge(e, plane);
  return split_face(f, plane, between);
}

}  // namespace sightline
