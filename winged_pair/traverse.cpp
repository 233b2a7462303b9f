#include "winged_pair/traverse.hpp"

#include <algorithm>

namespace sightline {

void Marks::grow(std::size_t size) {
  if (stamp.size() < size) stamp.resize(size + size / 2 + 16, 0);
}

void Marks::begin(std::size_t size) {
  grow(size);
  if (++now == 0) {  // the counter came round: forget all old stamps
    std::fill(stamp.begin(), stamp.end(), 0u);
    now = 1;
  }
}

void faces_of_cell(const Complex& c, CellId cell, Marks& face_marks, std::vector<FaceId>& out) {
  face_marks.begin(c.faces.size());
  out.clear();
  out.push_back(c.cells[cell].face);
  face_marks.first(out[0]);
  for (std::size_t k = 0; k < out.size(); ++k) {
    for_pairs_of_face(c, out[k], [&](PairId p) {
      const FaceId next = c.pairs[pair_across(c, p, cell)].face;
      if (face_marks.first(next)) out.push_back(next);
    });
  }
}

void edges_of_vertex(const Complex& c, VertexId v, Marks& edge_marks, std::vector<EdgeId>& out) {
  edge_marks.begin(c.edges.size());
  out.clear();
  out.push_back(c.vertices[v].edge);
  edge_marks.first(out[0]);
  for (std::size_t k = 0; k < out.size(); ++k) {
    for_pairs_of_edge(c, out[k], [&](PairId p) {
      // The face's other edge at v: the next pair where this one ends in v, else the one before.
      const PairId q = c.pairs[p].clock[pair_head(c, p) == v ? 1 : 0];
      if (edge_marks.first(c.pairs[q].edge)) out.push_back(c.pairs[q].edge);
    });
  }
}

void cells_of_edge(const Complex& c, EdgeId e, std::vector<CellId>& out) {
  out.clear();
  for_pairs_of_edge(c, e, [&](PairId p) { out.push_back(cell_after(c, p)); });
}

}  // namespace sightline
