// Half-edges around vertices, loops, faces.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {

/// A half-edge with left normal n leaves the ray r in direction r x n. h leaves counter-clockwise of g when
/// n_g.(r x n_h) = r.(n_h x n_g) > 0.
Sign turn(State& s, const State::Half& g, const State::Half& h) {
  if (g.line.id == h.line.id) return 0;
  const Corner& tail = s.corners[g.tail];
  const glm::dvec3 ng = s.table->approx(g.line.id) * static_cast<double>(g.line.sign);
  const glm::dvec3 nh = s.table->approx(h.line.id) * static_cast<double>(h.line.sign);
  // r: at most 2, within 9u (u = 2^-53); n at most 1, within u, their product at most 2, within 8u: data 3 (16 + 18) u,
  // rounding 12u + 20u: below 2^-45.
  const double value = glm::dot(tail.approx, glm::cross(nh, ng));
  if (std::abs(value) > 0x1p-45) return value > 0 ? 1 : -1;
  // r = n_g x w, and n_h = a n_g + b w up to positive factors, so n_h x n_g = -b r. The sign of b follows from any k
  // outside the plane of n_g and w: det(n_g, n_h, k) = b det(n_g, w, k). The other end of g gives one.
  SightlineRef w = tail.across(g.line.id);
  w.sign *= g.line.sign;
  const SightlineRef k = s.corners[g.head].across(g.line.id);
  if (h.line.id == w.id) return -h.line.sign * w.sign;
  return -s.table->order(g.line, h.line, k) * s.table->order(g.line, w, k);
}

namespace {

/// Does b leave their vertex counter-clockwise of a, as seen in (s,t), by less than half a turn: 1; do they leave in
/// opposite directions: 0? On a window by the directions that are seen: coordinates are at most 1 and within 2^-54, the
/// directions' within 3 2^-54, their products within 7 2^-54, and the difference of two products within 16 2^-54.
Sign leaves_left(State& s, const State::Leaving& a, const State::Leaving& b) {
  const double value = a.s * b.t - a.t * b.s;
  if (std::abs(value) > 0x1p-49) return value > 0 ? 1 : -1;
  return s.handedness * turn(s, s.halves[a.half_edge], s.halves[b.half_edge]);
}

/// Sorts the half-edges that leave a vertex counter-clockwise, the first staying in front.
void sort_around(State& s, const VisibilityMap& map, std::span<std::uint32_t> outgoing) {
  auto& leaving = s.leaving;
  leaving.clear();
  for (const std::uint32_t h : outgoing) {
    State::Leaving now{0, 0, h, 0};
    if (s.camera) {
      const MapEdge& e = map.edges[h / 2];
      const glm::dvec2 &tail = map.vertices[e.vertex[h % 2]].st, &head = map.vertices[e.vertex[1 - h % 2]].st;
      now.s = head.x - tail.x;
      now.t = head.y - tail.y;
    }
    // 0: less than half a turn from the first; 1: half a turn; 2: more.
    if (!leaving.empty()) now.half = 1 - leaves_left(s, leaving[0], now);
    leaving.push_back(now);
  }
  const auto before = [&](const State::Leaving& a, const State::Leaving& b) {
    return a.half != b.half ? a.half < b.half : leaves_left(s, a, b) > 0;
  };
  if (leaving.size() == 3) {
    if (before(leaving[2], leaving[1])) std::swap(leaving[1], leaving[2]);
  } else {
    std::sort(leaving.begin() + 1, leaving.end(), [&](const State::Leaving& a, const State::Leaving& b) {
      return a.half_edge != b.half_edge && before(a, b);
    });
  }
  for (std::size_t k = 1; k < leaving.size(); ++k) outgoing[k] = leaving[k].half_edge;
}

/// s.outgoing: the half-edges that leave each vertex, counter-clockwise in (s,t).
void sort_around_vertices(State& s, const VisibilityMap& map) {
  const std::size_t n = map.vertices.size();
  s.out_start.assign(n + 1, 0);
  for (const MapEdge& e : map.edges) {
    ++s.out_start[e.vertex[0]];
    ++s.out_start[e.vertex[1]];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& start : s.out_start) {
    sum += start;
    start = sum;
  }
  s.outgoing.resize(s.halves.size());
  for (auto e = static_cast<std::uint32_t>(map.edges.size()); e-- > 0;) {
    s.outgoing[--s.out_start[map.edges[e].vertex[1]]] = 2 * e + 1;
    s.outgoing[--s.out_start[map.edges[e].vertex[0]]] = 2 * e;
  }
  for (std::size_t v = 0; v < n; ++v) {
    const std::uint32_t first = s.out_start[v], count = s.out_start[v + 1] - first;
    if (count >= 3) sort_around(s, map, std::span(s.outgoing).subspan(first, count));
  }
  // Arriving with the face on the left, a loop goes on with the next half-edge clockwise of the one it came by.
  s.next.resize(s.halves.size());
  for (std::size_t v = 0; v < n; ++v) {
    const std::uint32_t first = s.out_start[v], end = s.out_start[v + 1];
    std::uint32_t before = s.outgoing[end - 1];
    for (std::uint32_t k = first; k < end; ++k) {
      const std::uint32_t h = s.outgoing[k];
      s.next[h ^ 1u] = before;
      before = h;
    }
  }
}

}  // namespace

/// At its lowest vertex (by exact place) all its edges leave to one side,
/// within half a turn; the loop is a hole if the sector of its face between two of them is the one that looks outwards.
bool runs_clockwise(State& s, const VisibilityMap& map, std::uint32_t start) {
  const auto tail = [&](std::uint32_t h) { return map.edges[h / 2].vertex[h % 2]; };
  std::uint32_t lowest = tail(start);
  for (std::uint32_t h = s.next[start]; h != start; h = s.next[h]) {
    const std::uint32_t v = tail(h);
    if (v != lowest && compare_places(s, s.vertices[v].corner, s.vertices[lowest].corner) < 0) lowest = v;
  }
  std::uint32_t h = start;
  do {
    const std::uint32_t out = s.next[h];
    if (tail(out) == lowest && s.handedness * turn(s, s.halves[h ^ 1u], s.halves[out]) > 0) return true;
    h = out;
  } while (h != start);
  return false;
}

void trace_loops(State& s, VisibilityMap& map) {
  sort_around_vertices(s, map);
  s.face_of.assign(s.faces.parent.size(), none);
  s.traced.assign(s.halves.size(), 0);
  s.loops.clear();
  map.faces.clear();
  const auto face_of = [&](std::uint32_t fragment) -> std::uint32_t {
    if (fragment == none) return none;
    std::uint32_t& face = s.face_of[s.faces.find(fragment)];
    if (face == none) {
      face = static_cast<std::uint32_t>(map.faces.size());
      map.faces.push_back({s.polygon_of[fragment], 0, 0, 0, 0, 0, 0});
    }
    return face;
  };
  // Half-edges in order: every loop is met at its lowest one, faces by their lowest loop.
  for (std::uint32_t start = 0; start < s.halves.size(); ++start) {
    if (s.traced[start] || s.halves[start].left == none) continue;
    const std::uint32_t face = face_of(s.halves[start].left);
    s.loops.push_back({start, face});
    ++map.faces[face].loop_count;
    std::uint32_t h = start;
    do {
      if (s.traced[h]) throw std::logic_error("stitch: loops cross");
      s.traced[h] = 1;
      h = s.next[h];
    } while (h != start);
  }
  for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
    map.edges[e].left = face_of(s.halves[2 * e].left);
    map.edges[e].right = face_of(s.halves[2 * e + 1].left);
  }
  if (s.edges.empty() && !s.polygon_of.empty()) face_of(0);
}

}  // namespace sightline::stitching
