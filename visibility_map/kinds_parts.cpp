// Elementary intervals -> parts: every stretch of the map's edges with its kind, its owner and its name.
#include "visibility_map/kinds_depth.hpp"

#include <algorithm>

namespace sightline::stitching {
namespace {

/// Intervals of one line without a vertex of the map between them, the same two planes beside them all.
struct Run {
  Stretch stretch;
  std::uint32_t left, right;  // fragments at its start
  Shown p, q;                 // what they show
};

void add_part(State& s, const Run& run, EdgeKind kind, PolygonId owner, NameKey name) {
  s.parts.push_back({run.stretch.line, run.stretch.from, run.stretch.to, run.left, run.right, kind, owner, name});
}

void add_border(State& s, const Run& run) {
  NameKey side = 0;
  while (s.border[side].id != run.stretch.line) ++side;
  add_part(s, run, EdgeKind::window, none, side);
}

/// The name of a line where a tracer did not go on: nothing seen beside it needs to have an edge there.
NameKey origin_name(State& s, SightlineId line) {
  const auto lowest = [&](PlaneId plane) {
    Shown shown;
    for (const Surface& surface : s.scene->surfaces()) {
      if (surface.plane == plane && surface.polygon < shown.polygon) shown = {surface.polygon, plane};
    }
    return shown;
  };
  for (const Fragments::Origin& origin : s.fragments->origins) {
    if (origin.line != line) continue;
    return origin.edge ? edge_key(origin.of[0], origin.of[1])
                       : planes_name(s, lowest(origin.of[0]), lowest(origin.of[1]));
  }
  throw std::logic_error("stitch: a silhouette on no edge of its polygon");
}

/// The best name among carriers, else among the diagonals of the polygons (up to two), else that of their planes.
NameKey name_or_diagonal(State& s, const Run& run, std::vector<Carrier>& carriers, const Shown& a, const Shown& b) {
  NameKey name = best_name(carriers);
  if (name != no_name) return name;
  carriers.clear();
  for (const Shown* shown : {&a, &b}) {
    if (shown->polygon != none) find_carriers(s, run.stretch, *shown, true, carriers);
  }
  name = best_name(carriers);
  if (name != no_name) return name;
  if (a.polygon == none || b.polygon == none) return origin_name(s, run.stretch.line);
  return planes_name(s, a, b);
}

/// The owner is nearer and ends here, or it would be seen on the other side too: a part of its outline carries all of
/// the run, unless a tracer did not go on there. Where it lies in one plane, only edges of the file are that: if but
/// one of them may be it, it is.
void add_silhouette(State& s, const Run& run, bool left_owns) {
  const Shown& owner = left_owns ? run.p : run.q;
  if (s.scene->planar(owner.polygon) && s.fragments->origins.empty()) {
    const NearEdges edges = near_edges(s, run.stretch.line, owner.polygon);
    if (edges.count == 1) return add_part(s, run, EdgeKind::silhouette, owner.polygon, edge_key(edges.a, edges.b));
  }
  s.carriers.clear();
  find_carriers(s, run.stretch, owner, false, s.carriers);
  add_part(s, run, EdgeKind::silhouette, owner.polygon, name_or_diagonal(s, run, s.carriers, owner, {}));
}

/// The depth order changes within the run: two silhouettes, with a vertex where both planes meet the line.
void add_crossing(State& s, const Run& run, const Depths& depths) {
  const SightlineId line = run.stretch.line;
  // The ray N x (sign * n_equal) comes after the start.
  const Sign sign = s.table->order({line, 1}, depths.equal, s.corners[run.stretch.from].across(line));
  const CornerId middle = add_corner(s, line, {depths.equal.id, depths.equal.sign * sign});
  Run first = run, second = run;
  first.stretch.to = second.stretch.from = middle;
  add_silhouette(s, first, depths.from > 0);
  add_silhouette(s, second, depths.to > 0);
}

/// A line other than the run's through the scene point v, to mark the place of v on it.
SightlineRef line_through(State& s, const Run& run, PointId v) {
  for (const Shown* shown : {&run.p, &run.q}) {
    for (const PointId w : s.scene->corners(shown->polygon)) {
      const SightlineRef ref = s.table->of_points(v, w);
      if (ref.id != none && ref.id != run.stretch.line) return ref;
    }
  }
  throw std::logic_error("stitch: a polygon seen along its plane");
}

/// The planes meet along the run: crease where an edge of the file is, intersection elsewhere.
void add_meeting(State& s, const Run& run, const std::vector<Carrier>& carriers) {
  const SightlineId line = run.stretch.line;
  const auto covers = [](const Carrier& c) { return c.covers(); };
  if (std::any_of(carriers.begin(), carriers.end(), covers)) {
    add_part(s, run, EdgeKind::crease, none, best_name(carriers));
    return;
  }
  s.other_carriers.clear();
  if (carriers.empty()) {
    add_part(s, run, EdgeKind::intersection, none, name_or_diagonal(s, run, s.other_carriers, run.p, run.q));
    return;
  }
  // The edges' ends within the run, in order.
  auto& stops = s.stops;
  stops.assign(1, {none, run.stretch.from});
  for (const Carrier& c : carriers) {
    for (const PointId v : {c.start, c.end}) {
      if (v == none) continue;
      const SightlineRef ref = line_through(s, run, v);
      const Sign sign = s.table->order({line, 1}, ref, s.corners[run.stretch.from].across(line));
      stops.push_back({v, add_corner(s, line, {ref.id, ref.sign * sign})});
    }
  }
  const auto after = [&](CornerId a, CornerId b) {
    return s.table->order({line, 1}, s.corners[b].across(line), s.corners[a].across(line));
  };
  std::sort(stops.begin() + 1, stops.end(),
            [&](const State::Stop& a, const State::Stop& b) { return after(a.corner, b.corner) > 0; });
  stops.push_back({none, run.stretch.to});
  const auto rank = [&](PointId v, std::size_t otherwise) {
    for (std::size_t k = 1; v != none && k + 1 < stops.size(); ++k) {
      if (stops[k].point == v) return k;
    }
    return otherwise;
  };
  for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
    const bool inner = k > 0 && k + 2 < stops.size();
    if (inner && after(stops[k].corner, stops[k + 1].corner) == 0) {
      s.rays.unite(stops[k].corner, stops[k + 1].corner);
      continue;
    }
    Run part = run;
    part.stretch.from = stops[k].corner;
    part.stretch.to = stops[k + 1].corner;
    s.other_carriers.clear();
    for (const Carrier& c : carriers) {
      if (rank(c.start, 0) <= k && k < rank(c.end, stops.size() - 1)) {
        s.other_carriers.push_back({c.a, c.b, none, none});
      }
    }
    if (s.other_carriers.empty()) {
      add_part(s, part, EdgeKind::intersection, none, name_or_diagonal(s, part, s.other_carriers, run.p, run.q));
    } else {
      add_part(s, part, EdgeKind::crease, none, best_name(s.other_carriers));
    }
  }
}

void classify(State& s, const Run& run) {
  if (run.left == none || run.right == none) return add_border(s, run);
  if (run.p.plane == none || run.q.plane == none) return add_silhouette(s, run, run.p.plane != none);
  if (run.p.plane != run.q.plane) {
    const Depths depths = filter_depths(s, run.stretch, run.p.plane, run.q.plane);
    if (depths.certain() && depths.from == depths.to) return add_silhouette(s, run, depths.from > 0);
  }
  s.carriers.clear();
  find_carriers(s, run.stretch, run.p, false, s.carriers);
  Depths depths{0, 0};
  if (run.p.plane != run.q.plane) {
    depths = carried_depths(s, s.carriers, run.q);
    if (!depths.certain()) {
      s.other_carriers.clear();
      find_carriers(s, run.stretch, run.q, false, s.other_carriers);
      depths = carried_depths(s, s.other_carriers, run.p);
      if (depths.certain()) depths = {-depths.from, -depths.to};
    }
    if (!depths.certain()) depths = exact_depths(s, run.stretch, run.p, run.q);
  }
  if (depths.from * depths.to < 0) return add_crossing(s, run, depths);
  if (depths.from != 0 || depths.to != 0) return add_silhouette(s, run, depths.from + depths.to > 0);
  find_carriers(s, run.stretch, run.q, false, s.carriers);
  if (run.p.plane != run.q.plane) return add_meeting(s, run, s.carriers);
  s.other_carriers = s.carriers;
  add_part(s, run, EdgeKind::seam, none, name_or_diagonal(s, run, s.other_carriers, run.p, run.q));
}

Shown shown_by(const State& s, std::uint32_t fragment) {
  return fragment == none ? Shown{} : Shown{s.polygon_of[fragment], s.plane_of[fragment]};
}

}  // namespace

bool half_turn(State& s, const Stretch& stretch, CornerId to) {
  return s.table->order({stretch.line, 1}, s.corners[to].across(stretch.line),
                        s.corners[stretch.from].across(stretch.line)) <= 0;
}

void find_kinds(State& s) {
  s.parts.clear();
  s.plane_names.clear();
  for (std::size_t k = 0; k < s.intervals.size();) {
    const Interval& first = s.intervals[k];
    Run run{
        {first.line, first.from, first.to}, first.left, first.right, shown_by(s, first.left), shown_by(s, first.right)};
    for (++k; k < s.intervals.size(); ++k) {
      const Interval& next = s.intervals[k];
      const std::uint32_t root = s.rays.find(run.stretch.to);
      if (next.line != run.stretch.line || s.rays.find(next.from) != root || s.degree[root] != 2) break;
      if (shown_by(s, next.left).plane != run.p.plane || shown_by(s, next.right).plane != run.q.plane) break;
      if (!s.camera && half_turn(s, run.stretch, next.to)) break;
      run.stretch.to = next.to;
    }
    classify(s, run);
  }
}

}  // namespace sightline::stitching
