// Names: plane pairs, and second lines for vertices that two collinear edges share.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>

namespace sightline::stitching {
namespace {

bool collinear(const PointTable& points, PointId a, PointId b, PointId c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation(points, a, b, c, axis) != 0) return false;
  }
  return true;
}

/// The first three corners (in the polygon's own order) that lie in the plane and span it.
void name_plane(const State& s, const Shown& shown, std::uint32_t* out) {
  const Scene& scene = *s.scene;
  const std::span<const std::uint32_t> corners = scene.corners(shown.polygon);
  const auto in_plane = [&](PointId p) { return scene.planar(shown.polygon) || side_of(s, p, shown) == 0; };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!in_plane(corners[i])) continue;
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      if (!in_plane(corners[j]) || scene.points().equal(corners[i], corners[j])) continue;
      for (std::size_t k = j + 1; k < corners.size(); ++k) {
        if (!in_plane(corners[k]) || collinear(scene.points(), corners[i], corners[j], corners[k])) continue;
        out[0] = corners[i];
        out[1] = corners[j];
        out[2] = corners[k];
        return;
      }
    }
  }
  throw std::logic_error("stitch: a fragment's plane is not its polygon's");
}

bool line_less(const MapLine& a, const MapLine& b) {
  return std::lexicographical_compare(std::begin(a.v), std::end(a.v), std::begin(b.v), std::end(b.v));
}

Shown shown_by(const State& s, std::uint32_t fragment) {
  return fragment == none ? Shown{} : Shown{s.polygon_of[fragment], s.plane_of[fragment]};
}

}  // namespace

bool plane_name_less(const State& s, NameKey a, NameKey b) {
  if (a == no_name || b == no_name) return a < b;
  return line_less(s.plane_names[a ^ plane_key], s.plane_names[b ^ plane_key]);
}

NameKey planes_name(State& s, Shown a, Shown b) {
  MapLine line{MapLine::planes, {}};
  name_plane(s, a, line.v);
  name_plane(s, b, line.v + 3);
  const bool swap = b.polygon != a.polygon ? b.polygon < a.polygon
                                           : std::lexicographical_compare(line.v + 3, line.v + 6, line.v, line.v + 3);
  if (swap) std::swap_ranges(line.v, line.v + 3, line.v + 3);
  s.plane_names.push_back(line);
  return plane_key | (s.plane_names.size() - 1);
}

Mark find_mark(State& s, const Part& a, const Part& b) {
  const Scene& scene = *s.scene;
  const SightlineId line = a.line;
  const CornerId corner = a.to;
  const SightlineRef u = s.corners[corner].across(line);
  Mark mark{s.rays.find(corner), none, no_name};
  const auto offer = [&](SightlineRef ref, NameKey name) {
    if (ref.id == none || ref.id == line || !name_less(s, name, mark.name)) return;
    if (ref.id != u.id && s.table->order({line, 1}, u, ref) != 0) return;
    mark.line = ref.id;
    mark.name = name;
  };
  const Shown beside[4] = {shown_by(s, a.left), shown_by(s, a.right), shown_by(s, b.left), shown_by(s, b.right)};
  // An edge or a diagonal of a polygon beside it, seen through the vertex.
  for (const Shown& shown : beside) {
    if (shown.polygon == none) continue;
    const auto corners = scene.corners(shown.polygon);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const PointId p = corners[k], q = corners[k + 1 == corners.size() ? 0 : k + 1];
      offer(s.table->of_points(p, q), edge_key(p, q));
    }
    for (const Surface& piece : scene.surfaces(shown.polygon)) {
      for (const SurfaceEdge& e : scene.edges(piece)) offer(s.table->of_points(e.a, e.b), edge_key(e.a, e.b));
    }
  }
  if (mark.name != no_name) return mark;
  // The line in which two of the planes beside it meet.
  for (const Shown& p : beside) {
    for (const Shown& q : beside) {
      if (p.plane == none || q.plane == none || p.plane == q.plane) continue;
      const SightlineRef ref = s.table->of_planes(p.plane, q.plane);
      if (ref.id != none && ref.id != line && (ref.id == u.id || s.table->order({line, 1}, u, ref) == 0)) {
        offer(ref, planes_name(s, p, q));
      }
    }
  }
  if (mark.name != no_name) return mark;
  // Any two corners of a polygon beside it.
  for (const Shown& shown : beside) {
    if (shown.polygon == none) continue;
    for (const PointId p : scene.corners(shown.polygon)) {
      for (const PointId q : scene.corners(shown.polygon)) {
        if (p < q) offer(s.table->of_points(p, q), edge_key(p, q));
      }
    }
  }
  if (mark.name == no_name) throw std::logic_error("stitch: nothing marks a vertex between collinear edges");
  return mark;
}

void join_parts(State& s) {
  s.edges.clear();
  s.marks.clear();
  for (std::uint32_t k = 0; k < s.parts.size(); ++k) {
    const Part& part = s.parts[k];
    if (!s.edges.empty()) {
      Edge& edge = s.edges.back();
      const Part& last = s.parts[edge.last];
      const std::uint32_t root = s.rays.find(part.from);
      if (last.line == part.line && s.rays.find(last.to) == root && s.degree[root] == 2) {
        const Stretch stretch{part.line, s.parts[edge.first].from, last.to};
        if (last.kind == part.kind && last.owner == part.owner && (s.camera || !half_turn(s, stretch, part.to))) {
          edge.last = k;
          if (name_less(s, part.name, edge.name)) edge.name = part.name;
          continue;
        }
        s.marks.push_back(find_mark(s, last, part));
      }
    }
    s.edges.push_back({k, k, part.name});
  }
}

}  // namespace sightline::stitching
