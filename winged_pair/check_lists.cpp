// Lists that several stages of check() walk through.
#include "winged_pair/check_stages.hpp"
#include "winged_pair/traverse.hpp"

namespace sightline::check_detail {

Loops make_loops(const Complex& c) {
  Loops loops;
  loops.first.reserve(c.faces.size() + 1);
  loops.pairs.reserve(c.pairs.size());
  for (FaceId f = 0; f < c.faces.size(); ++f) {
    loops.first.push_back(static_cast<std::uint32_t>(loops.pairs.size()));
    for_pairs_of_face(c, f, [&](PairId p) { loops.pairs.push_back(p); });
  }
  loops.first.push_back(static_cast<std::uint32_t>(loops.pairs.size()));
  return loops;
}

CellLists make_cell_lists(const Complex& c) {
  const std::size_t outside = c.cells.size();
  const auto slot = [&](CellId cell) { return cell == none ? outside : cell; };
  CellLists lists;
  lists.first_face.assign(outside + 2, 0);
  for (const Face& face : c.faces) {
    for (const CellId cell : face.cell) ++lists.first_face[slot(cell) + 1];
  }
  for (std::size_t k = 0; k <= outside; ++k) lists.first_face[k + 1] += lists.first_face[k];
  lists.faces.resize(2 * c.faces.size());
  std::vector<std::uint32_t> next(lists.first_face.begin(), lists.first_face.end() - 1);
  for (FaceId f = 0; f < c.faces.size(); ++f) {
    for (std::uint32_t side = 0; side < 2; ++side) lists.faces[next[slot(c.faces[f].cell[side])]++] = {f, side};
  }

  std::vector<std::size_t> seen(c.vertices.size(), outside + 1);
  for (std::size_t cell = 0; cell <= outside; ++cell) {
    lists.first_vertex.push_back(static_cast<std::uint32_t>(lists.vertices.size()));
    for (const CellLists::Side& side : lists.faces_of(cell)) {
      for_pairs_of_face(c, side.face, [&](PairId p) {
        const VertexId v = pair_tail(c, p);
        if (seen[v] == cell) return;
        seen[v] = cell;
        lists.vertices.push_back(v);
      });
    }
  }
  lists.first_vertex.push_back(static_cast<std::uint32_t>(lists.vertices.size()));
  return lists;
}

Sign side_of_face(const Complex& c, std::span<const PairId> loop, PlaneId wall) {
  for (const PairId p : loop) {
    const Sign side = vertex_side(c.planes, c.vertices[pair_tail(c, p)].place, wall);
    if (side != 0) return side;
  }
  return 0;
}

ExactVertex exact_vertex(const PlaneTable& planes, const PlaneId (&plane)[3]) {
  std::array<std::array<Integer, 4>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) m[i][static_cast<std::size_t>(k)] = planes.integer(plane[i], k);
  }
  const auto det = [&m](std::size_t a, std::size_t b, std::size_t d) {
    return Integer(m[0][a] * (m[1][b] * m[2][d] - m[1][d] * m[2][b]) -
                   m[0][b] * (m[1][a] * m[2][d] - m[1][d] * m[2][a]) +
                   m[0][d] * (m[1][a] * m[2][b] - m[1][b] * m[2][a]));
  };
  ExactVertex v{{det(3, 1, 2), det(0, 3, 2), det(0, 1, 3)}, det(0, 1, 2)};
  if (v.w < 0) {
    v.w = -v.w;
    for (Integer& x : v.c) x = -x;
  }
  return v;
}

Sign compare(const ExactVertex& a, const ExactVertex& b, int axis) {
  const auto k = static_cast<std::size_t>(axis);
  const int s = cmp(Integer(a.c[k] * b.w), Integer(b.c[k] * a.w));
  return s < 0 ? -1 : s > 0 ? 1 : 0;
}

}  // namespace sightline::check_detail
