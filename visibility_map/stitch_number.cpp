// Canonical order: vertices by place, edges by their vertices, lines by name. See docs/map.md.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>

namespace sightline::stitching {
namespace {

void collect_vertices(State& s) {
  s.vertices.clear();
  s.vertex_of.assign(s.corners.size(), none);
  s.edge_ends.resize(s.edges.size());
  const Part* const parts = s.parts.data();
  std::uint32_t* const vertex_of = s.vertex_of.data();
  for (std::size_t k = 0; k < s.edges.size(); ++k) {
    const Part &first = parts[s.edges[k].first], &last = parts[s.edges[k].last];
    const bool border = first.kind == EdgeKind::window;
    const auto vertex = [&](CornerId corner) {
      const std::uint32_t root = s.rays.find(corner);
      std::uint32_t& v = vertex_of[root];
      if (v == none) {
        v = static_cast<std::uint32_t>(s.vertices.size());
        s.vertices.push_back({root, corner, {}, {}});
      } else if (border) {
        s.vertices[v].corner = corner;
      }
      return v;
    };
    const std::uint32_t from = vertex(first.from);
    s.edge_ends[k] = {from, vertex(last.to)};
  }
}

/// Places are compared as doubles first: a canonical order, and exact where it matters, since rounding is monotone.
void order_vertices(State& s) {
  place_vertices(s);
  s.vertex_order.resize(s.vertices.size());
  for (std::uint32_t k = 0; k < s.vertices.size(); ++k) {
    s.vertex_order[k] = {s.camera ? s.vertices[k].st.x : s.vertices[k].direction.x, k};
  }
  const auto below = [&](const VertexDraft& a, const VertexDraft& b) {
    if (s.camera && a.st.y != b.st.y) return a.st.y < b.st.y;
    if (!s.camera && a.direction.y != b.direction.y) return a.direction.y < b.direction.y;
    if (!s.camera && a.direction.z != b.direction.z) return a.direction.z < b.direction.z;
    return a.root != b.root && compare_places(s, a.corner, b.corner) < 0;
  };
  std::sort(s.vertex_order.begin(), s.vertex_order.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : below(s.vertices[a.second], s.vertices[b.second]);
  });
  s.placed.resize(s.vertices.size());
  s.rank_of.resize(s.vertices.size());
  for (std::uint32_t k = 0; k < s.vertices.size(); ++k) {
    const std::uint32_t draft = s.vertex_order[k].second;
    s.placed[k] = s.vertices[draft];
    s.rank_of[draft] = k;
    s.vertex_of[s.placed[k].root] = k;
  }
  s.vertices.swap(s.placed);
  for (auto& [from, to] : s.edge_ends) {
    from = s.rank_of[from];
    to = s.rank_of[to];
  }
}

MapLine line_of(const State& s, NameKey name) {
  if (name & plane_key) return s.plane_names[name ^ plane_key];
  if (name < 4) return {MapLine::window, {static_cast<std::uint32_t>(name)}};
  return {MapLine::edge,
          {static_cast<std::uint32_t>((name - 4) >> 31), static_cast<std::uint32_t>((name - 4) & 0x7fffffff)}};
}

/// Lines of the map, and which of them every edge and every mark has.
void order_names(State& s, VisibilityMap& map) {
  s.names.clear();
  std::uint32_t user = 0;
  for (const Edge& edge : s.edges) s.names.push_back({edge.name, user++});
  for (const Mark& mark : s.marks) s.names.push_back({mark.name, user++});
  std::sort(s.names.begin(), s.names.end(),
            [&](const auto& a, const auto& b) { return name_less(s, a.first, b.first); });
  s.line_of_user.resize(s.names.size());
  map.lines.clear();
  for (std::size_t k = 0; k < s.names.size(); ++k) {
    if (k == 0 || name_less(s, s.names[k - 1].first, s.names[k].first)) {
      map.lines.push_back(line_of(s, s.names[k].first));
    }
    s.line_of_user[s.names[k].second] = static_cast<std::uint32_t>(map.lines.size() - 1);
  }
}

void add_edge(State& s, VisibilityMap& map, std::uint32_t lower, const State::Place& place) {
  const Edge& edge = s.edges[place.edge];
  const Part &first = s.parts[edge.first], &last = s.parts[edge.last];
  const bool mirrored = s.handedness < 0;
  const auto left = [&](const Part& part) { return mirrored ? part.right : part.left; };
  const auto right = [&](const Part& part) { return mirrored ? part.left : part.right; };
  State::Half* const half = s.halves.data() + 2 * map.edges.size();
  half[place.up ? 0 : 1] = {{first.line, 1}, first.from, last.to, left(first), left(last)};
  half[place.up ? 1 : 0] = {{first.line, -1}, last.to, first.from, right(last), right(first)};
  map.edges.push_back({{lower, place.higher}, place.line, none, none, first.kind, first.owner});
}

/// By the lower vertex, which is counted, then by the higher one and the line.
void order_edges(State& s, VisibilityMap& map) {
  const std::size_t n = s.vertices.size();
  s.place_start.assign(n + 1, 0);
  for (const auto& [from, to] : s.edge_ends) ++s.place_start[std::min(from, to)];
  std::uint32_t sum = 0;
  for (std::uint32_t& start : s.place_start) {
    sum += start;
    start = sum;
  }
  s.edge_places.resize(s.edges.size());
  for (std::uint32_t k = 0; k < s.edges.size(); ++k) {
    const auto [from, to] = s.edge_ends[k];
    s.edge_places[--s.place_start[std::min(from, to)]] = {std::max(from, to), s.line_of_user[k], k, from < to};
  }
  map.edges.clear();
  map.edges.reserve(s.edges.size());
  s.halves.resize(2 * s.edges.size());
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::span places =
        std::span(s.edge_places).subspan(s.place_start[v], s.place_start[v + 1] - s.place_start[v]);
    if (places.size() > 1) {
      std::sort(places.begin(), places.end(), [](const State::Place& a, const State::Place& b) {
        return a.higher != b.higher ? a.higher < b.higher : a.line < b.line;
      });
    }
    for (const State::Place& place : places) add_edge(s, map, v, place);
  }
}

/// The two lowest names among the edges that end in a vertex, on different lines.
void name_vertices(State& s, VisibilityMap& map) {
  map.vertices.clear();
  for (const VertexDraft& v : s.vertices) map.vertices.push_back({v.st, v.direction, {none, none}, none});
  s.vertex_line.assign(s.vertices.size(), none);
  for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
    for (const std::uint32_t v : map.edges[e].vertex) {
      if (map.edges[e].line >= map.vertices[v].line[0]) continue;
      map.vertices[v].line[0] = map.edges[e].line;
      s.vertex_line[v] = s.halves[2 * e].line.id;
    }
  }
  for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
    for (const std::uint32_t v : map.edges[e].vertex) {
      if (s.halves[2 * e].line.id == s.vertex_line[v]) continue;
      map.vertices[v].line[1] = std::min(map.vertices[v].line[1], map.edges[e].line);
    }
  }
  for (std::size_t k = 0; k < s.marks.size(); ++k) {
    map.vertices[s.vertex_of[s.marks[k].root]].line[1] = s.line_of_user[s.edges.size() + k];
  }
}

}  // namespace

void number(State& s, VisibilityMap& map) {
  collect_vertices(s);
  order_vertices(s);
  order_names(s, map);
  order_edges(s, map);
  name_vertices(s, map);
}

}  // namespace sightline::stitching
