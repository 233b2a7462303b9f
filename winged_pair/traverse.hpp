// The paper's traversals, each in time linear in what it visits.
#pragma once

#include "winged_pair/complex.hpp"

namespace sightline {

inline CellId cell_across(const Complex& c, FaceId f, CellId from) {
  return c.faces[f].cell[0] == from ? c.faces[f].cell[1] : c.faces[f].cell[0];
}
/// The vertex at which the pair's edge starts / ends when its face is walked counter-clockwise (seen from its front).
inline VertexId pair_tail(const Complex& c, PairId p) { return c.edges[c.pairs[p].edge].vertex[c.pairs[p].direction]; }
inline VertexId pair_head(const Complex& c, PairId p) {
  return c.edges[c.pairs[p].edge].vertex[1 - c.pairs[p].direction];
}
/// The cell between a pair and its spin[1].
inline CellId cell_after(const Complex& c, PairId p) { return c.faces[c.pairs[p].face].cell[1 - c.pairs[p].direction]; }
/// The pair of the other face of `cell` at the same edge: across the edge on the cell's boundary.
inline PairId pair_across(const Complex& c, PairId p, CellId cell) {
  return cell_after(c, p) == cell ? c.pairs[p].spin[1] : c.pairs[p].spin[0];
}

/// Calls visit(pair) for the pairs of a face, counter-clockwise seen from its front.
template <class Visit>
void for_pairs_of_face(const Complex& c, FaceId f, Visit&& visit) {
  const PairId start = c.faces[f].pair;
  PairId p = start;
  do {
    const PairId next = c.pairs[p].clock[1];
    visit(p);
    p = next;
  } while (p != start);
}
/// Calls visit(pair) for the pairs of an edge, counter-clockwise around it.
template <class Visit>
void for_pairs_of_edge(const Complex& c, EdgeId e, Visit&& visit) {
  const PairId start = c.edges[e].pair;
  PairId p = start;
  do {
    const PairId next = c.pairs[p].spin[1];
    visit(p);
    p = next;
  } while (p != start);
}

/// Scratch of the traversals that have to remember where they were; reuse it.
struct Marks {
  std::vector<std::uint32_t> stamp;
  std::uint32_t now = 0;
  void begin(std::size_t size);  // forget all, make room
  void grow(std::size_t size);   // make room, forget nothing
  bool first(std::uint32_t k) { return stamp[k] != now ? (stamp[k] = now, true) : false; }
};
/// The faces of a cell, in the order of a breadth-first walk from cell.face.
void faces_of_cell(const Complex& c, CellId cell, Marks& face_marks, std::vector<FaceId>& out);
/// The edges that end in a vertex.
void edges_of_vertex(const Complex& c, VertexId v, Marks& edge_marks, std::vector<EdgeId>& out);
/// The cells on a face's two sides are face.cell; the cells around an edge, counter-clockwise (`none` is the outside).
void cells_of_edge(const Complex& c, EdgeId e, std::vector<CellId>& out);

}  // namespace sightline
