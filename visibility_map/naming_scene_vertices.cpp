// The scene vertices seen in vertices of the map, and what coincides with the faces.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

void list_coincident(State& s, VisibilityMap& map) {
  s.coincident.clear();
  for (std::uint32_t k = 0; k < s.fragments->fragments.size(); ++k) {
    const Fragment& f = s.fragments->fragments[k];
    for (std::uint32_t i = 1; i < f.seen_count; ++i) {
      const PolygonId p = s.scene->surfaces()[s.fragments->seen[f.first_seen + i]].polygon;
      if (p != s.polygon_of[k]) s.coincident.push_back({s.face_of[s.faces.find(k)], p});
    }
  }
  std::sort(s.coincident.begin(), s.coincident.end());
  s.coincident.erase(std::unique(s.coincident.begin(), s.coincident.end()), s.coincident.end());
  map.coincident.clear();
  std::size_t k = 0;
  for (std::uint32_t f = 0; f < map.faces.size(); ++f) {
    map.faces[f].first_coincident = static_cast<std::uint32_t>(map.coincident.size());
    for (; k < s.coincident.size() && s.coincident[k].first == f; ++k) map.coincident.push_back(s.coincident[k].second);
    map.faces[f].coincident_count = static_cast<std::uint32_t>(map.coincident.size()) - map.faces[f].first_coincident;
  }
}

/// The lowest scene vertex in the place of a corner of polygon p that is seen in the vertex and lies in the plane,
/// which is that of the surface seen beside it: on one ray there is one point of the plane. Keeps `best` if there is
/// none lower.
void look_for_corner(State& s, const Corner& at, PolygonId p, PlaneId plane, PointId& best) {
  const Scene& scene = *s.scene;
  const glm::dvec3 &a = s.table->approx(at.low), &b = s.table->approx(at.high);
  const double bound = 0x1p-47 * s.scale;  // as in find_carriers
  for (const PointId corner : scene.corners(p)) {
    const glm::dvec3 w = scene.points().approx(corner) - s.eye;
    if (std::abs(glm::dot(a, w)) > bound || std::abs(glm::dot(b, w)) > bound) continue;
    const PointId twin = scene.lowest_twin(corner);
    if (twin >= best) continue;
    if (s.table->side({at.low, 1}, corner) != 0 || s.table->side({at.high, 1}, corner) != 0) continue;
    if (point_side(scene.planes(), corner, plane) == 0) best = twin;
  }
}

}  // namespace

void name_scene_vertices(State& s, VisibilityMap& map) {
  list_coincident(s, map);
  for (std::uint32_t v = 0; v < map.vertices.size(); ++v) {
    PointId best = none;
    PolygonId last = none;
    for (std::uint32_t k = s.out_start[v]; k < s.out_start[v + 1]; ++k) {
      // What is seen in the sector between this half-edge and the next, right beside each of them.
      const State::Half& out = s.halves[s.outgoing[k]];
      const State::Half& in = s.halves[s.outgoing[k] ^ 1u];
      for (const std::uint32_t fragment : {out.left, in.left_at_head}) {
        if (fragment == none || s.plane_of[fragment] == none) continue;
        const PolygonId p = s.polygon_of[fragment];
        if (p == last && s.scene->planar(p)) continue;
        last = p;
        const Corner& at = s.corners[s.vertices[v].corner];
        look_for_corner(s, at, p, s.plane_of[fragment], best);
        const MapFace& face = map.faces[s.face_of[s.faces.find(fragment)]];
        for (const PolygonId q : map.coincident_of(face)) look_for_corner(s, at, q, s.plane_of[fragment], best);
      }
    }
    map.vertices[v].scene_vertex = best;
  }
}

}  // namespace sightline::stitching
