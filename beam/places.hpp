// Points in space by what they are: what lies on what by identity, without arithmetic. Internal to beam/.
#pragma once

#include <algorithm>

#include "bsp/tree.hpp"

namespace sightline {

/// A point of the scene (a), or where its edge a-b, a < b, meets a cutting plane. Equal names are one point; two names
/// may be one point all the same.
struct PlaceName {
  PointId a = none, b = none;
  PlaneId cut = none;
  bool known() const { return a != none; }
  bool operator==(const PlaceName&) const = default;
};

/// The name of a piece's corner k; unknown where two cuts meet in it.
inline PlaceName place_name(const TreePiece& piece, std::uint32_t k) {
  if (piece.corner[k].point != none) return {piece.corner[k].point, none, none};
  const TreeEdge &before = piece.edge[k == 0 ? piece.count - 1 : k - 1], &after = piece.edge[k];
  if ((before.a == none) == (after.a == none)) return {};
  const TreeEdge& edge = before.a != none ? before : after;
  return {std::min(edge.a, edge.b), std::max(edge.a, edge.b), before.a != none ? after.cut : before.cut};
}

/// What a line of the view was made of: an edge of the scene between two points, first < second; or the cut of a
/// surface by a plane, which may begin and end in points of the scene.
struct LineName {
  PointId first = none, second = none;
  SurfaceId surface = none;
  PlaneId cut = none;
  bool known() const { return first != none || cut != none; }
};

/// The name of the line along side k of a piece.
inline LineName line_name(const TreePiece& piece, std::uint32_t k) {
  const TreeEdge& e = piece.edge[k];
  if (e.a != none) return {std::min(e.a, e.b), std::max(e.a, e.b), none, none};
  return {piece.corner[k].point, piece.corner[k + 1 == piece.count ? 0 : k + 1].point, piece.surface, e.cut};
}

/// Has the surface an edge between these points of the scene?
inline bool has_edge(const Scene& scene, SurfaceId surface, PointId a, PointId b) {
  for (const SurfaceEdge& e : scene.edges(scene.surfaces()[surface])) {
    const PointId p = scene.lowest_twin(e.a), q = scene.lowest_twin(e.b);
    if ((p == a && q == b) || (p == b && q == a)) return true;
  }
  return false;
}

/// True: the line holds the place, or the point opposite to it. False: nothing is known.
inline bool holds(const Scene& scene, const LineName& line, const PlaceName& p) {
  if (!p.known()) return false;
  if (p.cut == none) return p.a == line.first || p.a == line.second;
  if (line.cut == none) return p.a == line.first && p.b == line.second;
  return p.cut == line.cut && has_edge(scene, line.surface, p.a, p.b);
}

/// A place that both lines hold, if one is known.
inline PlaceName common_place(const Scene& scene, const LineName& l, const LineName& m) {
  if (l.first != none && (l.first == m.first || l.first == m.second)) return {l.first, none, none};
  if (l.second != none && (l.second == m.first || l.second == m.second)) return {l.second, none, none};
  if (l.cut == none && m.cut == none) return {};
  if (l.cut == none || m.cut == none) {
    const LineName &edge = l.cut == none ? l : m, &cut = l.cut == none ? m : l;
    if (edge.first == none || !has_edge(scene, cut.surface, edge.first, edge.second)) return {};
    return {edge.first, edge.second, cut.cut};
  }
  if (l.cut != m.cut) return {};
  for (const SurfaceEdge& e : scene.edges(scene.surfaces()[l.surface])) {
    const PointId p = scene.lowest_twin(e.a), q = scene.lowest_twin(e.b);
    if (has_edge(scene, m.surface, p, q)) return {std::min(p, q), std::max(p, q), l.cut};
  }
  return {};
}

}  // namespace sightline
