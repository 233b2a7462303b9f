// Loops in their places, areas and solid angles.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace sightline::stitching {
namespace {

/// Twice the area that the edge adds to the face on its left: the cross product of its ends, good to 2^-100, so that
/// tiny faces need no origin of their own.
Twofold twice_area(const MapVertex& a, const MapVertex& b) {
  return two_product(a.st.x, b.st.y) - two_product(a.st.y, b.st.x);
}

/// The signed solid angle of the triangle of unit rays r, a, b (Van Oosterom and Strackee 1983): in (-2 pi, 2 pi), up
/// to multiples of 4 pi. det(r, a, b - a) keeps short edges accurate. ra and rb are the products of r with a and b.
double solid_angle(const glm::dvec3& r, const glm::dvec3& a, const glm::dvec3& b, double ra, double rb) {
  const double det = glm::dot(r, glm::cross(a, b - a));
  return 2 * std::atan2(det, 1 + ra + glm::dot(a, b) + rb);
}

/// The ray from which triangles are spanned: any, but vertices opposite to it cost accuracy. On the sphere the best of
/// a few fixed ones.
glm::dvec3 apex(const State& s, const VisibilityMap& map) {
  if (s.camera) return glm::normalize(s.frame[0]);
  glm::dvec3 best{1, 0, 0};
  double farthest = -1;
  for (int k = 0; k < 16; ++k) {
    const double z = (2 * k + 1) / 16.0 - 1, angle = 2.4 * k, radius = std::sqrt(1 - z * z);
    const glm::dvec3 r{radius * std::cos(angle), radius * std::sin(angle), z};
    double nearest = 2;
    for (const MapVertex& v : map.vertices) nearest = std::min(nearest, 1 + glm::dot(r, v.direction));
    if (nearest > farthest) {
      farthest = nearest;
      best = r;
    }
  }
  return best;
}

std::int32_t reference(std::uint32_t half) {
  const auto e = static_cast<std::int32_t>(half / 2);
  return half % 2 == 0 ? e : -e - 1;
}

State::Measure measure_loop(const State& s, std::uint32_t start) {
  State::Measure m{{}, 0};
  std::uint32_t h = start;
  do {
    const State::Measure& edge = s.edge_measure[h / 2];
    const bool forwards = h % 2 == 0;
    m.area = m.area + (forwards ? edge.area : -edge.area);
    m.angle += forwards ? edge.angle : -edge.angle;
    h = s.next[h];
  } while (h != start);
  return m;
}

/// Brings the outer loop of a face to the front; the others stay in order of their lowest half-edges. Areas of loops
/// are within 2^-50 per edge of the exact ones (places rounded to 2^-54, edges at most 2 long); the one that is larger
/// is the outer one.
void outer_first(State& s, const VisibilityMap& map, std::span<LoopDraft> loops) {
  if (loops.size() < 2) return;
  const double bound = 0x1p-50 * static_cast<double>(map.edges.size() + 1);
  auto outer = std::find_if(loops.begin(), loops.end(), [&](const LoopDraft& loop) { return loop.area.high > bound; });
  if (outer == loops.end()) {
    outer = std::find_if(loops.begin(), loops.end(),
                         [&](const LoopDraft& loop) { return !runs_clockwise(s, map, loop.start); });
  }
  if (outer == loops.end()) throw std::logic_error("stitch: a face without an outer loop");
  std::rotate(loops.begin(), outer, outer + 1);
}

}  // namespace

void measure(State& s, VisibilityMap& map) {
  const glm::dvec3 r = apex(s, map);
  s.along_apex.resize(map.vertices.size());
  for (std::size_t v = 0; v < map.vertices.size(); ++v) s.along_apex[v] = glm::dot(r, map.vertices[v].direction);
  s.edge_measure.resize(map.edges.size());
  for (std::size_t k = 0; k < map.edges.size(); ++k) {
    const auto [from, to] = map.edges[k].vertex;
    const MapVertex &a = map.vertices[from], &b = map.vertices[to];
    // Counter-clockwise seen from the eye is clockwise seen from outside the sphere.
    s.edge_measure[k] = {twice_area(a, b), -s.handedness * solid_angle(r, a.direction, b.direction, s.along_apex[from],
                                                                       s.along_apex[to])};
  }
  // Loops by face.
  std::uint32_t first = 0;
  for (MapFace& face : map.faces) {
    face.first_loop = first;
    first += face.loop_count;
    face.loop_count = 0;
  }
  s.face_loops.resize(s.loops.size());
  for (LoopDraft& loop : s.loops) {
    const State::Measure m = measure_loop(s, loop.start);
    loop.area = m.area;
    loop.angle = m.angle;
    MapFace& face = map.faces[loop.face];
    s.face_loops[face.first_loop + face.loop_count++] = loop;
  }
  map.first_edge.assign(1, 0);
  map.loop_edges.clear();
  for (MapFace& face : map.faces) {
    const std::span<LoopDraft> loops = std::span(s.face_loops).subspan(face.first_loop, face.loop_count);
    if (s.camera) outer_first(s, map, loops);
    Twofold area;
    double angle = 0;
    for (const LoopDraft& loop : loops) {
      area = area + loop.area;
      angle += loop.angle;
      std::uint32_t h = loop.start;
      do {
        map.loop_edges.push_back(reference(h));
        h = s.next[h];
      } while (h != loop.start);
      map.first_edge.push_back(static_cast<std::uint32_t>(map.loop_edges.size()));
    }
    face.area = s.camera ? area.high / 2 : 0;
    if (!s.camera) {
      constexpr double whole = 4 * std::numbers::pi;
      angle -= whole * std::floor(angle / whole + 1e-12);
      if (loops.empty()) angle = whole;
    }
    face.solid_angle = std::max(angle, 0.0);
  }
}

}  // namespace sightline::stitching
