// A given map in exact numbers, and the comparison of two.
#include "tests/oracle/exact_map.hpp"

#include <algorithm>
#include <iterator>

namespace sightline::oracle {
namespace {

mpq_class turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::string name(PolygonId p) { return p == none ? "nothing" : p == outside ? "outside" : std::to_string(p); }

const char* name(EdgeKind kind) {
  constexpr const char* names[] = {"silhouette", "crease", "seam", "intersection", "window"};
  return names[static_cast<int>(kind)];
}

mpq_class area(const std::vector<Point>& loop) {
  mpq_class sum = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point &a = loop[k], &b = loop[(k + 1) % loop.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

/// Corners only, from the least one on. A corner that a loop passes twice may be the least: then the one followed by
/// the least sequence counts.
void canonicalise(std::vector<Point>& loop) {
  std::vector<Point> corners;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point& before = loop[(k + loop.size() - 1) % loop.size()];
    if (turn(before, loop[k], loop[(k + 1) % loop.size()]) != 0) corners.push_back(loop[k]);
  }
  std::vector<Point> best = corners;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    if (corners < best) best = corners;
  }
  loop = best;
}

}  // namespace

std::string words(const Point& p) { return "(" + p.x.get_str() + ", " + p.y.get_str() + ")"; }

std::string words(const ExactEdge& e) {
  const bool turned = e.ends[1] < e.ends[0];
  return "edge " + words(e.ends[turned ? 1 : 0]) + " - " + words(e.ends[turned ? 0 : 1]) + " left " +
         name(turned ? e.right : e.left) + " right " + name(turned ? e.left : e.right) + " " + name(e.kind) +
         " owner " + name(e.owner);
}

std::string words(PolygonId polygon, const std::vector<PolygonId>& coincident, std::vector<std::vector<Point>> loops) {
  for (auto& loop : loops) canonicalise(loop);
  std::ranges::sort(loops);
  std::string out = "face of " + name(polygon) + " with";
  for (const PolygonId p : coincident) out += " " + name(p);
  for (const auto& loop : loops) {
    out += " [";
    for (const Point& p : loop) out += words(p);
    out += "]";
  }
  return out;
}

ExactPlaces exact_places(const Scene& scene, const VisibilityMap& map) {
  const View view(scene, map.camera);
  ExactPlaces out;
  for (const MapLine& line : map.lines) {
    const auto& v = line.v;
    out.lines.push_back(line.kind == MapLine::window ? View::line_of_window(v[0])
                        : line.kind == MapLine::edge ? view.line_of_points(v[0], v[1])
                                                     : view.line_of_planes({v[0], v[1], v[2]}, {v[3], v[4], v[5]}));
  }
  for (const MapVertex& vertex : map.vertices) {
    const Vec ray = cross(out.lines[vertex.line[0]], out.lines[vertex.line[1]]);
    if (ray[0] == 0) return out;
    out.points.push_back({mpq_class(ray[1]) / ray[0] + mpq_class(1, 2), mpq_class(ray[2]) / ray[0] + mpq_class(1, 2)});
    out.rays.push_back(ray);
  }
  return out;
}

ExactMap exact_map(const Scene& scene, const VisibilityMap& map) {
  ExactMap out;
  const auto [lines, rays, points] = exact_places(scene, map);
  if (points.size() < map.vertices.size()) {
    out.faults.push_back("vertex " + std::to_string(points.size()) + ": its lines do not meet in the window's plane");
    return out;
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const MapVertex& vertex = map.vertices[k];
    const Point& p = points[k];
    if (abs(p.x - mpq_class(vertex.st.x)) > mpq_class(1e-12) || abs(p.y - mpq_class(vertex.st.y)) > mpq_class(1e-12)) {
      out.faults.push_back("vertex " + std::to_string(k) + ": st is not its place " + words(p));
    }
    out.scene_vertex[words(p)] = vertex.scene_vertex;
  }
  if (out.scene_vertex.size() != points.size()) out.faults.push_back("two vertices in one place");
  const auto polygon = [&](std::uint32_t face) { return face == none ? outside : map.faces[face].polygon; };
  for (std::size_t k = 0; k < map.edges.size(); ++k) {
    const MapEdge& e = map.edges[k];
    for (const std::uint32_t v : e.vertex) {
      if (dot(lines[e.line], rays[v]) != 0) out.faults.push_back("edge " + std::to_string(k) + ": not on its line");
    }
    out.edges.push_back(words(
        ExactEdge{{points[e.vertex[0]], points[e.vertex[1]]}, polygon(e.left), polygon(e.right), e.kind, e.owner}));
  }
  for (std::size_t k = 0; k < map.faces.size(); ++k) {
    const MapFace& face = map.faces[k];
    std::vector<std::vector<Point>> loops;
    mpq_class sum = 0;
    for (std::uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
      std::vector<Point> loop;
      for (const std::int32_t e : map.loop(l)) {
        const MapEdge& edge = map.edges[static_cast<std::size_t>(e >= 0 ? e : -e - 1)];
        loop.push_back(points[edge.vertex[e >= 0 ? 0 : 1]]);
        if ((e >= 0 ? edge.left : edge.right) != k)
          out.faults.push_back("face " + std::to_string(k) + ": not its edge");
      }
      const mpq_class own = area(loop);
      if ((sgn(own) > 0) != (l == face.first_loop)) {
        out.faults.push_back("face " + std::to_string(k) + ": a loop runs the wrong way");
      }
      sum += own;
      loops.push_back(loop);
    }
    if (abs(sum - mpq_class(face.area)) > mpq_class(1e-12)) {
      out.faults.push_back("face " + std::to_string(k) + ": area is not " + std::to_string(sum.get_d()));
    }
    const auto coincident = map.coincident_of(face);
    out.faces.push_back(words(face.polygon, {coincident.begin(), coincident.end()}, loops));
  }
  std::ranges::sort(out.faces);
  std::ranges::sort(out.edges);
  return out;
}

std::vector<std::string> differences(const ExactMap& oracle, const ExactMap& given) {
  std::vector<std::string> out = given.faults;
  const auto compare = [&out](const std::vector<std::string>& a, const std::vector<std::string>& b, const char* what) {
    std::vector<std::string> only;
    std::ranges::set_difference(a, b, std::back_inserter(only));
    for (const std::string& line : only) out.push_back(what + line);
  };
  compare(oracle.faces, given.faces, "missing: ");
  compare(given.faces, oracle.faces, "wrong: ");
  if (!oracle.kind_changes_inside) {
    compare(oracle.edges, given.edges, "missing: ");
    compare(given.edges, oracle.edges, "wrong: ");
    for (const auto& [place, vertex] : given.scene_vertex) {
      const auto found = oracle.scene_vertex.find(place);
      const PointId truth = found == oracle.scene_vertex.end() ? none : found->second;
      if (truth != vertex) out.push_back("vertex " + place + ": scene vertex " + name(vertex) + ", not " + name(truth));
    }
  }
  return out;
}

}  // namespace sightline::oracle
