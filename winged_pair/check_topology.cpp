// Second stage: the records form a 3-manifold with a sphere as its border, whatever their geometry.
#include "winged_pair/check_stages.hpp"
#include "winged_pair/traverse.hpp"

#include <numeric>

namespace sightline::check_detail {
namespace {

/// Disjoint sets, to count connected parts.
class Parts {
 public:
  explicit Parts(std::size_t size) : parent_(size), count_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }
  void unite(std::size_t a, std::size_t b) {
    const std::uint32_t i = root(static_cast<std::uint32_t>(a)), j = root(static_cast<std::uint32_t>(b));
    if (i == j) return;
    parent_[std::max(i, j)] = std::min(i, j);
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  std::uint32_t root(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  std::vector<std::uint32_t> parent_;
  std::size_t count_;
};

void check_pairs(const Complex& c, Faults& faults) {
  for (PairId p = 0; p < c.pairs.size() && !faults.full(); ++p) {
    const Pair& pair = c.pairs[p];
    for (int k = 0; k < 2; ++k) {
      if (c.pairs[pair.clock[k]].clock[1 - k] != p) faults.add("pair ", p, ": clock[", k, "] does not lead back");
      if (c.pairs[pair.spin[k]].spin[1 - k] != p) faults.add("pair ", p, ": spin[", k, "] does not lead back");
    }
    const Pair& next = c.pairs[pair.clock[1]];
    if (next.face != pair.face) faults.add("pair ", p, ": clock leads from face ", pair.face, " to ", next.face);
    if (pair_head(c, p) != pair_tail(c, pair.clock[1])) {
      faults.add("pair ", p, ": ends in vertex ", pair_head(c, p), ", the next one of face ", pair.face,
                 " begins in vertex ", pair_tail(c, pair.clock[1]));
    }
    const Pair& turned = c.pairs[pair.spin[1]];
    if (turned.edge != pair.edge) faults.add("pair ", p, ": spin leads from edge ", pair.edge, " to ", turned.edge);
    if (cell_after(c, p) != c.faces[turned.face].cell[turned.direction]) {
      faults.add("pair ", p, ": the cells of faces ", pair.face, " and ", turned.face, " differ between them at edge ",
                 pair.edge);
    }
  }
}

/// Every pair belongs to the one loop of its face and to the one ring of its edge. The cycles are finite: clock and
/// spin have been proved to be permutations that keep face and edge.
void check_cycles(const Complex& c, Faults& faults) {
  std::vector<std::uint32_t> of_face(c.faces.size()), of_edge(c.edges.size());
  for (const Pair& pair : c.pairs) {
    ++of_face[pair.face];
    ++of_edge[pair.edge];
  }
  std::vector<std::uint32_t> stamp(c.vertices.size(), none);
  for (FaceId f = 0; f < c.faces.size() && !faults.full(); ++f) {
    std::uint32_t count = 0;
    for_pairs_of_face(c, f, [&](PairId p) {
      ++count;
      const VertexId v = pair_tail(c, p);
      if (stamp[v] == f) faults.add("face ", f, ": passes vertex ", v, " twice");
      stamp[v] = f;
    });
    if (count < 3) faults.add("face ", f, ": only ", count, " edges");
    if (count != of_face[f]) faults.add("face ", f, ": its loop has ", count, " of its ", of_face[f], " pairs");
  }
  for (EdgeId e = 0; e < c.edges.size() && !faults.full(); ++e) {
    std::uint32_t count = 0, outside = 0;
    for_pairs_of_edge(c, e, [&](PairId p) {
      ++count;
      if (cell_after(c, p) == none) ++outside;
    });
    if (count < 2) faults.add("edge ", e, ": only one face around it");
    if (count != of_edge[e]) faults.add("edge ", e, ": its ring has ", count, " of its ", of_edge[e], " pairs");
    if (outside > 1) faults.add("edge ", e, ": the outside touches it in ", outside, " sectors");
  }
}

/// Boundaries of cells and links of vertices are in one piece.
void check_connected(const Complex& c, Faults& faults) {
  Parts sides(2 * c.faces.size()), ends(2 * c.edges.size());
  for (PairId p = 0; p < c.pairs.size(); ++p) {
    const Pair& pair = c.pairs[p];
    const Pair& turned = c.pairs[pair.spin[1]];
    sides.unite(2 * std::size_t{pair.face} + 1 - pair.direction, 2 * std::size_t{turned.face} + turned.direction);
    const Pair& next = c.pairs[pair.clock[1]];
    ends.unite(2 * std::size_t{pair.edge} + 1 - pair.direction, 2 * std::size_t{next.edge} + next.direction);
  }
  if (sides.count() != c.cells.size() + 1) {
    faults.add("the cells' boundaries and the outer one are ", sides.count(), " pieces for ", c.cells.size(), " cells");
  }
  if (ends.count() != c.vertices.size()) {
    faults.add("the edges meet in ", ends.count(), " places for ", c.vertices.size(), " vertices");
  }
}

void check_euler(const Complex& c, Faults& faults) {
  const CellLists lists = make_cell_lists(c);
  std::vector<std::int64_t> cell_edges(c.cells.size() + 1), link(c.vertices.size());
  for (PairId p = 0; p < c.pairs.size(); ++p) {
    const CellId cell = cell_after(c, p);
    ++cell_edges[cell == none ? c.cells.size() : cell];
    --link[pair_tail(c, p)];  // each face that has the vertex, once
  }
  for (const Edge& edge : c.edges) {
    for (const VertexId v : edge.vertex) ++link[v];
  }
  for (std::size_t k = 0; k <= c.cells.size() && !faults.full(); ++k) {
    const auto vertices = lists.vertices_of(k);
    for (const VertexId v : vertices) ++link[v];
    const std::int64_t euler = static_cast<std::int64_t>(vertices.size()) - cell_edges[k] +
                               static_cast<std::int64_t>(lists.faces_of(k).size());
    if (euler == 2) continue;
    if (k == c.cells.size()) {
      faults.add("outer boundary: Euler number ", euler, ", not 2");
    } else {
      faults.add("cell ", k, ": Euler number ", euler, ", not 2");
    }
  }
  for (VertexId v = 0; v < c.vertices.size() && !faults.full(); ++v) {
    if (link[v] != 2) faults.add("vertex ", v, ": Euler number of its link ", link[v], ", not 2");
  }
  const std::int64_t whole = static_cast<std::int64_t>(c.vertices.size()) - static_cast<std::int64_t>(c.edges.size()) +
                             static_cast<std::int64_t>(c.faces.size()) - static_cast<std::int64_t>(c.cells.size());
  if (whole != 1) faults.add("Euler number of the whole ", whole, ", not 1");
}

}  // namespace

void check_loops(const Complex& c, Faults& faults) {
  check_pairs(c, faults);
  if (faults.empty()) check_cycles(c, faults);
}

void check_topology(const Complex& c, Faults& faults) {
  check_loops(c, faults);
  if (faults.empty()) check_connected(c, faults);
  if (faults.empty()) check_euler(c, faults);
}

}  // namespace sightline::check_detail
