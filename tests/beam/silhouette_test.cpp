// The paper's way to silhouettes, by `spin`, against the map's: an edge where two opaque faces meet is a silhouette
// just when one of them is turned away from the eye.
#include <gtest/gtest.h>

#include <map>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "exact/sightline_table.hpp"
#include "models/model.hpp"
#include "winged_pair/traverse.hpp"

namespace sightline {
namespace {

enum class Outline { silhouette, crease, mixed };

// Classifies by the faces around a complex edge; mixed where there are not just two opaque ones in two planes.
Outline by_spin(const Scene& scene, const Complex& c, EdgeId e, SightlineTable& table) {
  std::vector<PairId> opaque;
  for_pairs_of_edge(c, e, [&](PairId p) {
    if (c.faces[c.pairs[p].face].label != 0) opaque.push_back(p);
  });
  if (opaque.size() != 2) return Outline::mixed;
  int towards = 0;
  PlaneId plane[2];
  for (int k = 0; k < 2; ++k) {
    const Face& f = c.faces[c.pairs[opaque[static_cast<std::size_t>(k)]].face];
    plane[k] = f.plane;
    const auto on = c.surfaces_on(f);
    if (on.size() != 1) return Outline::mixed;
    const Sign eye = table.eye_side(f.plane);
    if (eye == 0) return Outline::mixed;
    towards += scene.surfaces()[on[0]].flipped == (eye < 0);
  }
  if (plane[0] == plane[1] || towards == 0) return Outline::mixed;
  return towards == 1 ? Outline::silhouette : Outline::crease;
}

TEST(Silhouettes, BySpinAgreeWithTheMap) {
  const Model model = make_model("city");
  const Scene scene = make_scene(model.soup);
  const Complex complex = build(scene);
  std::map<std::pair<PointId, PointId>, std::vector<EdgeId>> on_line;
  for (EdgeId e = 0; e < complex.edges.size(); ++e) {
    const Edge& edge = complex.edges[e];
    if (edge.a != none) on_line[std::minmax(edge.a, edge.b)].push_back(e);
  }
  Tracer tracer(scene, complex);
  SightlineTable table(complex.planes);
  VisibilityMap map;
  std::size_t compared = 0, silhouettes = 0;
  for (std::size_t k = 0; k < model.cameras.size(); k += 9) {
    const CameraLine& line = model.cameras[k];
    tracer.trace(make_camera(line.eye, line.forward, line.up, line.vertical_fov_degrees, line.aspect), map);
    table.reset(complex.planes, scene.grid().point(line.eye));
    for (const MapEdge& edge : map.edges) {
      const MapLine& name = map.lines[edge.line];
      if (name.kind != MapLine::edge || (edge.kind != EdgeKind::silhouette && edge.kind != EdgeKind::crease)) continue;
      const auto found = on_line.find(std::minmax(name.v[0], name.v[1]));
      if (found == on_line.end()) continue;
      Outline all = by_spin(scene, complex, found->second[0], table);
      for (const EdgeId e : found->second) {
        if (by_spin(scene, complex, e, table) != all) all = Outline::mixed;
      }
      if (all == Outline::mixed) continue;
      ++compared;
      silhouettes += all == Outline::silhouette;
      EXPECT_EQ(edge.kind == EdgeKind::silhouette, all == Outline::silhouette) << "camera " << k;
    }
  }
  EXPECT_GT(compared, 100u);
  EXPECT_GT(silhouettes, 20u);
}

}  // namespace
}  // namespace sightline
