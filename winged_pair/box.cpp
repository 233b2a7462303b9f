#include <algorithm>

#include "winged_pair/split.hpp"

namespace sightline {

Complex make_box(const Scene& scene, const Integer lower[3], const Integer upper[3]) {
  Complex c;
  c.planes = scene.planes();
  const auto& plane = c.box_plane;
  for (int k = 0; k < 3; ++k) {
    c.box[0][k] = lower[k];
    c.box[1][k] = upper[k];
    c.box_plane[k][0] = c.planes.add_axis(k, lower[k]).id;
    c.box_plane[k][1] = c.planes.add_axis(k, upper[k]).id;
  }
  for (unsigned v = 0; v < 8; ++v) {  // vertex v lies at the upper end of axis k where bit k of v is set
    c.vertices.push_back({make_vertex(c.planes, plane[0][v & 1], plane[1][v >> 1 & 1], plane[2][v >> 2 & 1]), none});
  }
  // Edge 4k + j runs along axis k; its direction is n[0] x n[1] of its planes (axes k+1, k+2): upwards.
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned i = (k + 1) % 3, j = (k + 2) % 3;
    for (unsigned at = 0; at < 4; ++at) {
      const unsigned low = (at & 1) << i | (at >> 1) << j;
      c.edges.push_back({{low, low | 1u << k}, none, {plane[i][at & 1], plane[j][at >> 1]}, none, none});
      c.vertices[low].edge = c.vertices[low | 1u << k].edge = static_cast<EdgeId>(c.edges.size() - 1);
    }
  }
  const auto edge_between = [&](unsigned u, unsigned v) {
    for (EdgeId e = 0; e < 12; ++e) {
      const auto& ends = c.edges[e].vertex;
      if ((ends[0] == u && ends[1] == v) || (ends[0] == v && ends[1] == u)) return e;
    }
    return none;
  };
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned i = (k + 1) % 3, j = (k + 2) % 3;
    for (unsigned high = 0; high < 2; ++high) {
      const FaceId f = static_cast<FaceId>(c.faces.size());
      const PairId first = static_cast<PairId>(c.pairs.size());
      // Canonical normals point up the axis, so the loop i, i+j, j runs counter-clockwise seen from the front.
      const unsigned base = high << k;
      const unsigned loop[4] = {base, base | 1u << i, base | 1u << i | 1u << j, base | 1u << j};
      for (unsigned s = 0; s < 4; ++s) {
        const EdgeId e = edge_between(loop[s], loop[(s + 1) % 4]);
        const std::uint32_t direction = c.edges[e].vertex[0] == loop[s] ? 0 : 1;
        c.pairs.push_back({f, e, {first + (s + 3) % 4, first + (s + 1) % 4}, {none, none}, direction});
        c.edges[e].pair = first + s;
      }
      c.faces.push_back({{high ? 0u : none, high ? none : 0u}, first, plane[k][high], 0});
    }
  }
  // Two faces meet in each edge: each is the other's neighbour both ways round.
  for (PairId p = 0; p < c.pairs.size(); ++p) {
    for (PairId q = 0; q < c.pairs.size(); ++q) {
      if (p != q && c.pairs[p].edge == c.pairs[q].edge) c.pairs[p].spin[0] = c.pairs[p].spin[1] = q;
    }
  }
  c.cells.push_back({0});
  return c;
}

LabelId Labels::with(LabelId base, SurfaceId added) {
  if (base == 0) {  // most of all
    if (alone_.size() <= added) alone_.resize(std::size_t{added} + 1, none);
    if (alone_[added] == none) {
      complex_->label_surfaces.push_back(added);
      alone_[added] = close();
    }
    return alone_[added];
  }
  const auto key = static_cast<std::uint64_t>(base) << 32 | added;
  if (const auto found = next_.find(key); found != next_.end()) return found->second;
  const auto& first = complex_->label_first;
  auto& surfaces = complex_->label_surfaces;
  std::vector<SurfaceId> set(surfaces.begin() + first[base], surfaces.begin() + first[base + 1]);
  const auto at = std::lower_bound(set.begin(), set.end(), added);
  if (at != set.end() && *at == added) return next_[key] = base;
  set.insert(at, added);
  surfaces.insert(surfaces.end(), set.begin(), set.end());
  return next_[key] = close();
}

LabelId Labels::close() {
  complex_->label_first.push_back(static_cast<std::uint32_t>(complex_->label_surfaces.size()));
  return static_cast<LabelId>(complex_->label_first.size() - 2);
}

}  // namespace sightline
