// Canonical order: vertices by place, edges by their vertices, lines by name. See docs/map.md.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <numeric>

namespace sightline::stitching {
namespace {

void collect_vertices(State& s) {
  s.vertices.clear();
  s.vertex_of.assign(s.corners.size(), none);
  for (const Edge& edge : s.edges) {
    const bool border = s.parts[edge.first].kind == EdgeKind::window;
    for (const CornerId corner : {s.parts[edge.first].from, s.parts[edge.last].to}) {
      const std::uint32_t root = s.rays.find(corner);
      if (s.vertex_of[root] == none) {
        s.vertex_of[root] = static_cast<std::uint32_t>(s.vertices.size());
        s.vertices.push_back({root, corner, {}, {}});
      } else if (border) {
        s.vertices[s.vertex_of[root]].corner = corner;
      }
    }
  }
}

/// Places are compared as doubles first: a canonical order, and exact where it matters, since rounding is monotone.
void order_vertices(State& s) {
  for (VertexDraft& vertex : s.vertices) place_vertex(s, vertex);
  std::sort(s.vertices.begin(), s.vertices.end(), [&](const VertexDraft& a, const VertexDraft& b) {
    if (s.camera) {
      if (a.st.x != b.st.x) return a.st.x < b.st.x;
      if (a.st.y != b.st.y) return a.st.y < b.st.y;
    } else {
      for (int k = 0; k < 3; ++k) {
        if (a.direction[k] != b.direction[k]) return a.direction[k] < b.direction[k];
      }
    }
    return a.root != b.root && compare_places(s, a.corner, b.corner) < 0;
  });
  for (std::uint32_t k = 0; k < s.vertices.size(); ++k) s.vertex_of[s.vertices[k].root] = k;
}

MapLine line_of(const State& s, NameKey name) {
  if (name & plane_key) return s.plane_names[name ^ plane_key];
  if (name < 4) return {MapLine::window, {static_cast<std::uint32_t>(name)}};
  return {MapLine::edge,
          {static_cast<std::uint32_t>((name - 4) >> 31), static_cast<std::uint32_t>((name - 4) & 0x7fffffff)}};
}

void order_names(State& s, VisibilityMap& map) {
  const auto less = [&](NameKey a, NameKey b) { return name_less(s, a, b); };
  s.names.clear();
  for (const Edge& edge : s.edges) s.names.push_back(edge.name);
  for (const Mark& mark : s.marks) s.names.push_back(mark.name);
  std::sort(s.names.begin(), s.names.end(), less);
  s.names.erase(std::unique(s.names.begin(), s.names.end(), [&](NameKey a, NameKey b) { return !less(a, b); }),
                s.names.end());
  map.lines.clear();
  for (const NameKey name : s.names) map.lines.push_back(line_of(s, name));
}

std::uint32_t place_of(const State& s, NameKey name) {
  const auto at =
      std::lower_bound(s.names.begin(), s.names.end(), name, [&](NameKey a, NameKey b) { return name_less(s, a, b); });
  return static_cast<std::uint32_t>(at - s.names.begin());
}

void add_edge(State& s, VisibilityMap& map, const Edge& edge) {
  const Part &first = s.parts[edge.first], &last = s.parts[edge.last];
  const std::uint32_t from = s.vertex_of[s.rays.find(first.from)], to = s.vertex_of[s.rays.find(last.to)];
  const bool along = from < to;  // the line's positive direction
  const bool mirrored = s.handedness < 0;
  const auto left = [&](const Part& part) { return mirrored ? part.right : part.left; };
  const auto right = [&](const Part& part) { return mirrored ? part.left : part.right; };
  const State::Half forwards{{first.line, 1}, first.from, last.to, left(first), left(last)};
  const State::Half backwards{{first.line, -1}, last.to, first.from, right(last), right(first)};
  s.halves.push_back(along ? forwards : backwards);
  s.halves.push_back(along ? backwards : forwards);
  map.edges.push_back(
      {{std::min(from, to), std::max(from, to)}, place_of(s, edge.name), none, none, first.kind, first.owner});
}

void order_edges(State& s, VisibilityMap& map) {
  s.order.resize(s.edges.size());
  std::iota(s.order.begin(), s.order.end(), 0u);
  s.edge_ends.resize(s.edges.size());
  for (std::size_t k = 0; k < s.edges.size(); ++k) {
    const std::uint32_t a = s.vertex_of[s.rays.find(s.parts[s.edges[k].first].from)];
    const std::uint32_t b = s.vertex_of[s.rays.find(s.parts[s.edges[k].last].to)];
    s.edge_ends[k] = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
  std::sort(s.order.begin(), s.order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (s.edge_ends[a] != s.edge_ends[b]) return s.edge_ends[a] < s.edge_ends[b];
    return name_less(s, s.edges[a].name, s.edges[b].name);
  });
  map.edges.clear();
  s.halves.clear();
  for (const std::uint32_t k : s.order) add_edge(s, map, s.edges[k]);
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
  for (const Mark& mark : s.marks) map.vertices[s.vertex_of[mark.root]].line[1] = place_of(s, mark.name);
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
