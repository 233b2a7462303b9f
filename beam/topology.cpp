#include "beam/topology.hpp"

namespace sightline {

Topology::Topology(const Complex& c) {
  first_side.reserve(c.faces.size() + 1);
  sides.reserve(c.pairs.size());
  for (FaceId f = 0; f < c.faces.size(); ++f) {
    first_side.push_back(static_cast<std::uint32_t>(sides.size()));
    for_pairs_of_face(c, f, [&](PairId p) { sides.push_back({c.pairs[p].edge, c.pairs[p].direction}); });
    if (c.faces[f].cell[0] == none || c.faces[f].cell[1] == none) outer.push_back(f);
  }
  first_side.push_back(static_cast<std::uint32_t>(sides.size()));

  first_face.assign(c.cells.size() + 1, 0);
  for (const Face& f : c.faces) {
    for (const CellId cell : f.cell) {
      if (cell != none) ++first_face[cell + 1];
    }
  }
  for (std::size_t k = 1; k < first_face.size(); ++k) first_face[k] += first_face[k - 1];
  faces.resize(first_face.back());
  std::vector<std::uint32_t> next(first_face.begin(), first_face.end() - 1);
  for (FaceId f = 0; f < c.faces.size(); ++f) {
    for (const CellId cell : c.faces[f].cell) {
      if (cell != none) faces[next[cell]++] = f;
    }
  }
}

}  // namespace sightline
