// Canonical order: vertices by place, edges by their vertices, lines by name. See docs/map.md.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>

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
  for (std::uint32_t k = 0; k < s.vertices.size(); ++k) {
    s.placed[k] = s.vertices[s.vertex_order[k].second];
    s.vertex_of[s.placed[k].root] = k;
  }
  s.vertices.swap(s.placed);
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

void add_edge(State& s, VisibilityMap& map, std::uint32_t k) {
  const Edge& edge = s.edges[k];
  const Part &first = s.parts[edge.first], &last = s.parts[edge.last];
  const std::uint32_t from = s.vertex_of[s.rays.find(first.from)], to = s.vertex_of[s.rays.find(last.to)];
  const bool mirrored = s.handedness < 0;
  const auto left = [&](const Part& part) { return mirrored ? part.right : part.left; };
  const auto right = [&](const Part& part) { return mirrored ? part.left : part.right; };
  const std::size_t e = map.edges.size();
  const std::size_t along = from < to ? 0 : 1;  // the half-edge in the line's positive direction
  s.halves[2 * e + along] = {{first.line, 1}, first.from, last.to, left(first), left(last)};
  s.halves[2 * e + 1 - along] = {{first.line, -1}, last.to, first.from, right(last), right(first)};
  map.edges.push_back(
      {{std::min(from, to), std::max(from, to)}, s.line_of_user[k], none, none, first.kind, first.owner});
}

void order_edges(State& s, VisibilityMap& map) {
  s.edge_order.resize(s.edges.size());
  for (std::uint32_t k = 0; k < s.edges.size(); ++k) {
    const std::uint32_t a = s.vertex_of[s.rays.find(s.parts[s.edges[k].first].from)];
    const std::uint32_t b = s.vertex_of[s.rays.find(s.parts[s.edges[k].last].to)];
    s.edge_order[k] = {std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), k};
  }
  std::sort(s.edge_order.begin(), s.edge_order.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : s.line_of_user[a.second] < s.line_of_user[b.second];
  });
  map.edges.clear();
  s.halves.resize(2 * s.edges.size());
  for (const auto& [ends, k] : s.edge_order) add_edge(s, map, k);
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
