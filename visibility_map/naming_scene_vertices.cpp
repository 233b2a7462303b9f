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

/// Where the ray of a corner meets a plane, in unit coordinates, with a radius that the true place is within.
struct Place {
  glm::dvec3 at;
  double radius;
};

/// The unit ray of a vertex, each component within `error`.
struct UnitRay {
  glm::dvec3 at;
  double error;
};

/// From where the vertex is seen, which is rounded once from exact numbers, and so good even where its lines are all
/// but parallel. With u = 2^-53, s and t within u/2, and K the lengths of the camera's three vectors in all: forward +
/// (s - 1/2) right + (t - 1/2) up is within 5 u K, and made unit within that over its length, which is that of its
/// largest component or more, and 3 u. On the sphere the direction itself is rounded from exact numbers, within 6 u.
UnitRay unit_ray(const State& s, const VertexDraft& vertex, double size) {
  if (!s.camera) return {vertex.direction, 0x1p-50};
  const auto& [forward, right, up] = s.frame;
  const glm::dvec3 ray = forward + (vertex.st.x - 0.5) * right + (vertex.st.y - 0.5) * up;
  const double largest = std::max({std::abs(ray.x), std::abs(ray.y), std::abs(ray.z)});
  return {vertex.direction, 0x1p-50 * (1 + size / largest)};
}

/// The plane's numbers carry 2^-53 each and the eye 2^-52 of its size: its value at the eye is within 2^-49 of the
/// eye's scale, its value along the ray within twice the ray's error. The place is eye + t ray with t = value / along;
/// first-order errors are doubled, and doubled again, to cover the others. A divisor of no certain sign makes the
/// radius infinite.
Place seen_place(const State& s, const UnitRay& ray, PlaneId plane) {
  const ApproxPlane& p = s.scene->planes().approx(plane);
  const glm::dvec3 n{p.n[0], p.n[1], p.n[2]};
  const double along = glm::dot(n, ray.at), along_error = 2 * ray.error + 0x1p-50;
  const double t = (p.d - glm::dot(n, s.eye)) / along;
  if (!(2 * along_error < std::abs(along))) return {s.eye, INFINITY};
  const double t_error = (0x1p-49 * s.scale + std::abs(t) * along_error) / std::abs(along);
  return {s.eye + t * ray.at, 4 * (t_error + std::abs(t) * ray.error + 0x1p-50 * (s.scale + std::abs(t)))};
}

/// The lowest scene vertex that is seen in the corner and lies in the plane, which is that of a surface seen beside it:
/// on one ray there is one point of the plane. Keeps `best` if there is none lower.
void look_for_vertex(State& s, const Corner& at, const UnitRay& ray, PlaneId plane, PointId& best) {
  const Place place = seen_place(s, ray, plane);
  s.scene->places().near(place.at, place.radius, [&](PointId v) {
    if (v >= best) return;
    if (s.table->side({at.low, 1}, v) != 0 || s.table->side({at.high, 1}, v) != 0) return;
    if (point_side(s.scene->planes(), v, plane) == 0) best = v;
  });
}

/// A point that both lines of the corner were made of: it is seen in the corner, or opposite to it.
PointId common_point(const SightlineTable& table, const Corner& at) {
  const auto [p, q] = table.points(at.low);
  if (p == none) return none;
  return table.holds(at.high, p) ? p : table.holds(at.high, q) ? q : none;
}

/// Does the point lie in the plane in which the polygon is seen, as a corner of it?
bool is_corner_of(const Scene& scene, PolygonId polygon, PointId v) {
  if (!scene.planar(polygon)) return false;
  for (const PointId corner : scene.corners(polygon)) {
    if (scene.lowest_twin(corner) == v) return true;
  }
  return false;
}

}  // namespace

void name_scene_vertices(State& s, VisibilityMap& map) {
  list_coincident(s, map);
  const double size = s.camera ? glm::length(s.frame[0]) + glm::length(s.frame[1]) + glm::length(s.frame[2]) : 0;
  for (std::uint32_t v = 0; v < map.vertices.size(); ++v) {
    const Corner& at = s.corners[s.vertices[v].corner];
    const UnitRay ray = unit_ray(s, s.vertices[v], size);
    // Points on the vertex's ray, by identity, and those found: a plane that holds one holds no other, for on one ray
    // there is one point of the plane; equal points are looked for by the lowest of them.
    PointId known = common_point(*s.table, at), best = none;
    if (known != none) known = s.scene->lowest_twin(known);
    // Planes that have been looked at; it does no harm to look twice.
    PlaneId looked_at[8];
    std::uint32_t count = 0;
    const auto is_new = [&](PlaneId plane) {
      if (plane == none) return false;
      for (std::uint32_t k = 0; k < count; ++k) {
        if (looked_at[k] == plane) return false;
      }
      if (count < 8) looked_at[count++] = plane;
      return true;
    };
    const auto look = [&](std::uint32_t fragment, PlaneId plane) {
      if (known != none && is_corner_of(*s.scene, s.polygon_of[fragment], known)) {
        best = std::min(best, known);
        return;
      }
      look_for_vertex(s, at, ray, plane, best);
      if (known == none) known = best;
    };
    for (std::uint32_t k = s.out_start[v], end = s.out_start[v + 1]; k < end; ++k) {
      // What is seen beside the half-edge, on either hand.
      const std::uint32_t h = s.outgoing[k];
      const std::uint32_t left = s.halves[h].left, right = s.halves[h ^ 1u].left_at_head;
      const PlaneId p = left == none ? none : s.plane_of[left], q = right == none ? none : s.plane_of[right];
      const bool new_left = is_new(p), new_right = is_new(q);
      const EdgeKind kind = map.edges[h / 2].kind;
      if (kind == EdgeKind::crease || kind == EdgeKind::seam || kind == EdgeKind::intersection) {
        // The planes are equally far all along the edge: in the vertex they have one point.
        if (new_left && (new_right || p == q)) look(left, p);
        continue;
      }
      if (new_left) look(left, p);
      if (new_right) look(right, q);
    }
    map.vertices[v].scene_vertex = best;
  }
}

}  // namespace sightline::stitching
