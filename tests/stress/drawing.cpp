#include "tests/stress/drawing.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace sightline::stress {
namespace {

using oracle::Point;

bool less(const DrawnEdge& e, const DrawnEdge& f) {
  return e.a < f.a || (e.a == f.a && (e.b < f.b || (e.b == f.b && e.left < f.left)));
}
std::string words(const DrawnEdge& e) {
  return oracle::words(oracle::ExactEdge{{e.a, e.b}, e.left, e.right, e.kind, e.owner});
}
std::string words(const DrawnFace& f) {
  std::string out = "face of " + (f.polygon == none ? std::string("nothing") : std::to_string(f.polygon)) + ", area " +
                    f.area.get_str() + ", with";
  for (const PolygonId p : f.coincident) out += " " + std::to_string(p);
  return out;
}

void order_ends(DrawnEdge& e) {
  if (e.a < e.b) return;
  std::swap(e.a, e.b);
  std::swap(e.left, e.right);
}

bool straight(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
}

/// Joins edges that are all that meets in a point and run on there as the same thing.
std::vector<DrawnEdge> joined(const std::vector<DrawnEdge>& edges) {
  std::map<Point, std::vector<std::size_t>> at;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    at[edges[k].a].push_back(k);
    at[edges[k].b].push_back(k);
  }
  std::vector<DrawnEdge> out = edges;
  std::vector<char> gone(edges.size());
  for (const auto& [place, meeting] : at) {  // ascending: an edge grows at its greater end
    if (meeting.size() != 2) continue;
    std::size_t low = meeting[0], high = meeting[1];
    if (!(out[low].b == place)) std::swap(low, high);
    DrawnEdge &e = out[low], &f = out[high];
    if (!(e.b == place && f.a == place)) continue;
    if (e.left != f.left || e.right != f.right || e.kind != f.kind || e.owner != f.owner) continue;
    if (!straight(e.a, place, f.b)) continue;
    f.a = e.a;
    gone[low] = 1;
  }
  std::vector<DrawnEdge> kept;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (!gone[k]) kept.push_back(out[k]);
  }
  return kept;
}

}  // namespace

Drawing drawing(const Scene& scene, const VisibilityMap& map) {
  const oracle::ExactPlaces places = oracle::exact_places(scene, map);
  if (places.points.size() < map.vertices.size()) throw std::runtime_error("a vertex of the map is nowhere");
  Drawing out;
  const auto polygon = [&](std::uint32_t face) { return face == none ? oracle::outside : map.faces[face].polygon; };
  for (const MapEdge& e : map.edges) {
    out.edges.push_back(
        {places.points[e.vertex[0]], places.points[e.vertex[1]], polygon(e.left), polygon(e.right), e.kind, e.owner});
    order_ends(out.edges.back());
  }
  for (const MapFace& f : map.faces) {
    mpq_class twice = 0;
    for (std::uint32_t l = f.first_loop; l < f.first_loop + f.loop_count; ++l) {
      for (const std::int32_t entry : map.loop(l)) {
        const MapEdge& e = map.edges[static_cast<std::size_t>(entry >= 0 ? entry : -(entry + 1))];
        const Point &a = places.points[e.vertex[entry >= 0 ? 0 : 1]], &b = places.points[e.vertex[entry >= 0 ? 1 : 0]];
        twice += a.x * b.y - a.y * b.x;
      }
    }
    const auto others = map.coincident_of(f);
    out.faces.push_back({f.polygon, {others.begin(), others.end()}, twice / 2});
  }
  for (std::size_t k = 0; k < map.vertices.size(); ++k) {
    if (map.vertices[k].scene_vertex != none) out.seen_vertices[places.points[k]] = map.vertices[k].scene_vertex;
  }
  return out;
}

Drawing renamed(Drawing drawing, const Naming& polygon) {
  const auto name = [&](PolygonId p) { return p == none || p == oracle::outside ? p : polygon(p); };
  for (DrawnEdge& e : drawing.edges) {
    e.left = name(e.left);
    e.right = name(e.right);
    e.owner = name(e.owner);
  }
  for (DrawnFace& f : drawing.faces) {
    f.polygon = name(f.polygon);
    for (PolygonId& p : f.coincident) p = name(p);
    std::ranges::sort(f.coincident);
  }
  return drawing;
}

Drawing marked(Drawing drawing, const Naming& vertex) {
  for (auto at = drawing.seen_vertices.begin(); at != drawing.seen_vertices.end();) {
    at->second = vertex(at->second);
    at = at->second == none ? drawing.seen_vertices.erase(at) : std::next(at);
  }
  return drawing;
}

Drawing mirrored(Drawing drawing, bool s, bool t) {
  const auto image = [&](Point p) {
    if (s) p.x = 1 - p.x;
    if (t) p.y = 1 - p.y;
    return p;
  };
  for (DrawnEdge& e : drawing.edges) {
    e.a = image(e.a);
    e.b = image(e.b);
    if (s != t) std::swap(e.left, e.right);
    order_ends(e);
  }
  std::map<Point, PointId> moved;
  for (const auto& [place, vertex] : drawing.seen_vertices) moved[image(place)] = vertex;
  drawing.seen_vertices = std::move(moved);
  return drawing;
}

Drawing united(Drawing drawing) {
  std::erase_if(drawing.edges, [](const DrawnEdge& e) { return e.left == e.right; });
  for (DrawnEdge& e : drawing.edges) {
    if (e.kind == EdgeKind::intersection) e.kind = EdgeKind::crease;
  }
  drawing.edges = joined(drawing.edges);
  std::map<PolygonId, DrawnFace> faces;
  for (const DrawnFace& f : drawing.faces) {
    DrawnFace& whole = faces.try_emplace(f.polygon, DrawnFace{f.polygon, {}, 0}).first->second;
    whole.area += f.area;
    whole.coincident.insert(whole.coincident.end(), f.coincident.begin(), f.coincident.end());
  }
  drawing.faces.clear();
  for (auto& [polygon, face] : faces) {
    std::ranges::sort(face.coincident);
    face.coincident.erase(std::unique(face.coincident.begin(), face.coincident.end()), face.coincident.end());
    drawing.faces.push_back(std::move(face));
  }
  std::set<Point> ends;
  for (const DrawnEdge& e : drawing.edges) {
    ends.insert(e.a);
    ends.insert(e.b);
  }
  std::erase_if(drawing.seen_vertices, [&](const auto& seen) { return !ends.contains(seen.first); });
  return drawing;
}

std::string difference(const Drawing& expected, const Drawing& given) {
  std::string out;
  const auto compare = [&out](std::vector<std::string> a, std::vector<std::string> b) {
    std::ranges::sort(a);
    std::ranges::sort(b);
    std::vector<std::string> only;
    std::ranges::set_difference(a, b, std::back_inserter(only));
    for (const std::string& line : only) out += "missing: " + line + "\n";
    only.clear();
    std::ranges::set_difference(b, a, std::back_inserter(only));
    for (const std::string& line : only) out += "wrong: " + line + "\n";
  };
  const auto sorted = [](std::vector<DrawnEdge> edges) {
    std::ranges::sort(edges, less);
    return edges;
  };
  // Words only where there is something to say: they cost more than the comparison.
  if (sorted(expected.edges) != sorted(given.edges)) {
    std::vector<std::string> a, b;
    for (const DrawnEdge& e : expected.edges) a.push_back(words(e));
    for (const DrawnEdge& e : given.edges) b.push_back(words(e));
    compare(std::move(a), std::move(b));
  }
  std::vector<std::string> a, b;
  for (const DrawnFace& f : expected.faces) a.push_back(words(f));
  for (const DrawnFace& f : given.faces) b.push_back(words(f));
  compare(std::move(a), std::move(b));
  if (expected.seen_vertices != given.seen_vertices) {
    const auto list = [](const Drawing& drawing) {
      std::vector<std::string> lines;
      for (const auto& [place, vertex] : drawing.seen_vertices) {
        lines.push_back("scene vertex " + std::to_string(vertex) + " at " + oracle::words(place));
      }
      return lines;
    };
    compare(list(expected), list(given));
  }
  return out;
}

}  // namespace sightline::stress
