// Scene vertices: named at the map's vertices where they are seen, and none left out.
#include "verify/checks.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace sightline::verify {

namespace {

class SceneVertexCheck {
 public:
  SceneVertexCheck(const Context& context, Report& report)
      : context_(context),
        drawing_(context.drawing),
        view_(drawing_.view()),
        scene_(view_.scene()),
        file_(drawing_.file()),
        report_(report),
        at_(file_.vertices.size()),
        drawn_(scene_.vertex_count(), 0) {}

  void run() {
    match();
    for (std::uint32_t v = 0; v < file_.vertices.size(); ++v) check_name(v);
    for (std::uint32_t p = 0; p < scene_.polygon_count(); ++p) {
      if (!context_.faces_of[p].empty()) check_corners(p);
    }
  }

 private:
  /// Fills at_: the scene vertices exactly behind (or at) each vertex of the map.
  void match() {
    std::vector<std::uint32_t> order(file_.vertices.size());
    for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return drawing_.vertex(a).s < drawing_.vertex(b).s; });
    for (std::uint32_t w = 0; w < scene_.vertex_count(); ++w) {
      const auto [x, y, z, e] = view_.near(w);
      if (z < -e || x < -e || y < -e || x - z > 3 * e || y - z > 3 * e) continue;
      Box box{0, 0, 1, 1};
      Triple r;
      if (z > 4 * e) {
        // |x / z| is below 2 here, and x and z are off by e: x / z by 3 e / (z - e) < 4 e / z, and by its rounding.
        const double reach = 4 * e / z + 0x1p-50;
        box = {x / z - reach, y / z - reach, x / z + reach, y / z + reach};
      }
      auto first = std::lower_bound(order.begin(), order.end(), box.s0,
                                    [&](std::uint32_t v, double s) { return drawing_.vertex(v).s < s; });
      for (; first != order.end() && drawing_.vertex(*first).s <= box.s1; ++first) {
        const Point& p = drawing_.vertex(*first);
        if (p.t < box.t0 || p.t > box.t1) continue;
        if (r.is_zero()) r = view_.window(view_.ray(w));
        const auto& lines = file_.vertices[*first].lines;
        if (r.z > 0 && sign_dot(drawing_.line(lines[0]).n, r) == 0 && sign_dot(drawing_.line(lines[1]).n, r) == 0) {
          at_[*first].push_back(w);
          drawn_[w] = 1;
          break;
        }
      }
    }
  }

  /// The surfaces that are visible right beside a vertex, in the sector to the left of an entry leading away from it.
  std::vector<const SeenSurface*> beside(std::uint32_t v, std::size_t sector) const {
    const auto ring = drawing_.around(v);
    const std::uint32_t face = drawing_.face(ring[sector]);
    std::vector<const SeenSurface*> out;
    if (face == none || file_.faces[face].polygon == none) return out;
    const auto& seen = context_.seen[file_.faces[face].polygon];
    if (seen.size() <= 1) {
      for (const SeenSurface& s : seen) out.push_back(&s);
      return out;
    }
    // Several triangles: look between all directions in which what is seen may change.
    const Point& p = drawing_.vertex(v);
    std::vector<Triple> directions;
    const auto add = [&](const Triple& n) {
      directions.push_back({n.y, -n.x, 0});
      directions.push_back({-n.y, n.x, 0});
    };
    for (const std::int32_t entry : ring) add(drawing_.line(file_.edges[edge_of(entry)].line).n);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (const Line& line : seen[i].hull) {
        if (side(line, p) == 0) add(line.n);
      }
      for (std::size_t k = 0; k < i; ++k) {
        const Triple n = depth_line(seen[i].depth, seen[k].depth);
        if (sign_dot(n, p.r) == 0 && !(n.x == 0 && n.y == 0)) add(n);
      }
    }
    add({1, 0, 0});
    add({0, 1, 0});
    const auto half = [](const Triple& d) { return d.x > 0 || (d.x == 0 && d.y > 0) ? 0 : 1; };
    const auto turn = [](const Triple& a, const Triple& b) { return sign_difference(a.x, b.y, a.y, b.x); };
    std::sort(directions.begin(), directions.end(), [&](const Triple& a, const Triple& b) {
      return half(a) != half(b) ? half(a) < half(b) : turn(a, b) > 0;
    });
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Triple &a = directions[i], &b = directions[(i + 1) % directions.size()];
      if (turn(a, b) <= 0) continue;
      const Triple between = a + b;
      if (!in_sector(ring, sector, between)) continue;
      const SeenSurface* s = nearest_beside(seen, p, between);
      if (s && std::find(out.begin(), out.end(), s) == out.end()) out.push_back(s);
    }
    return out;
  }

  /// Does a direction lead into the sector from ring[sector] counter-clockwise to the next?
  bool in_sector(std::span<const std::int32_t> ring, std::size_t sector, const Triple& direction) const {
    const auto leftwards = [&](std::int32_t entry) {  // is the direction to the left of the entry's?
      const std::uint32_t e = edge_of(entry);
      const Triple& n = drawing_.line(file_.edges[e].line).n;
      return sgn(Integer(n.x * direction.x + n.y * direction.y)) * drawing_.left_sign(e) * (entry >= 0 ? 1 : -1) > 0;
    };
    const std::int32_t a = ring[sector], b = ring[(sector + 1) % ring.size()];
    const std::uint32_t e = edge_of(a);
    const int turn = drawing_.left_sign(e) * (a >= 0 ? 1 : -1) * drawing_.side_at(file_.edges[e].line, drawing_.to(b));
    return turn > 0 ? leftwards(a) && !leftwards(b) : turn == 0 ? leftwards(a) : leftwards(a) || !leftwards(b);
  }

  void check_name(std::uint32_t v) {
    const std::uint32_t name = file_.vertices[v].scene_vertex;
    const std::string item = named("vertex", v);
    if (at_[v].empty()) {
      if (name != none) report_.fault("scene vertices", item, named("scene vertex", name) + " is not there");
      return;
    }
    std::vector<const SeenSurface*> surfaces;
    std::set<std::uint32_t> polygons;
    const auto ring = drawing_.around(v);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t face = drawing_.face(ring[i]);
      if (face != none && file_.faces[face].polygon != none) polygons.insert(file_.faces[face].polygon);
      const auto here = beside(v, i);
      surfaces.insert(surfaces.end(), here.begin(), here.end());
    }
    // Those that lie on a surface visible right beside; `required` if one is a corner of a polygon visible there.
    std::vector<std::uint32_t> on;
    bool required = false;
    for (const std::uint32_t w : at_[v]) {
      const auto holds = [&](const SeenSurface* s) {
        return dot(s->surface->normal, scene_.point(w)) == s->surface->offset;
      };
      if (std::none_of(surfaces.begin(), surfaces.end(), holds)) continue;
      on.push_back(w);
      required = required || std::any_of(polygons.begin(), polygons.end(), [&](std::uint32_t p) {
                   const auto corners = scene_.corners(p);
                   return std::find(corners.begin(), corners.end(), w) != corners.end();
                 });
    }
    if (name == none) {
      if (required)
        report_.fault("scene vertices", item, named("scene vertex", on[0]) + " is seen there and not named");
      return;
    }
    if (!accepted(on, name)) {
      report_.fault("scene vertices", item,
                    "names scene vertex " + std::to_string(name) +
                        (on.empty() ? std::string(", none is seen there") : ", it is " + std::to_string(on[0])));
    }
  }

  /// The lowest of all; or of the nearest ones, since those behind are seen beside them only. Vertices that belong to
  /// no polygon, or to none that has an area, may count or not.
  bool accepted(const std::vector<std::uint32_t>& on, std::uint32_t name) const {
    std::vector<std::uint32_t> nearest;
    for (const std::uint32_t w : on) {
      const Triple ray = view_.ray(w);
      if (!nearest.empty()) {
        const Triple other = view_.ray(nearest[0]);
        const Integer difference = dot(ray, ray) - dot(other, other);
        if (difference > 0) continue;
        if (difference < 0) nearest.clear();
      }
      nearest.push_back(w);
    }
    for (const std::vector<std::uint32_t>* list : {&on, static_cast<const std::vector<std::uint32_t>*>(&nearest)}) {
      if (!list->empty() && (*list)[0] == name) return true;
      const auto used = std::find_if(list->begin(), list->end(), [&](std::uint32_t w) { return scene_.used(w); });
      if (used != list->end() && *used == name) return true;
      const auto solid = std::find_if(list->begin(), list->end(), [&](std::uint32_t w) { return has_area(w); });
      if (solid != list->end() && *solid == name) return true;
    }
    return false;
  }

  /// Is the vertex a corner of a polygon that is not dropped?
  bool has_area(std::uint32_t vertex) const {
    for (std::uint32_t p = 0; p < scene_.polygon_count(); ++p) {
      const auto corners = scene_.corners(p);
      if (std::find(corners.begin(), corners.end(), vertex) != corners.end() && !scene_.shape(p).surfaces.empty()) {
        return true;
      }
    }
    return false;
  }

  /// Corners of a convex polygon that are seen in one of its faces must be vertices of the map. (Corners that are not
  /// seen at all, or where a polygon is not convex, are the matter of "cover" and "depth".)
  void check_corners(std::uint32_t p) {
    const auto& seen = context_.seen[p];
    if (seen.size() != 1 || seen[0].surface->inside.size() != 1) return;
    for (const Corner& corner : seen[0].surface->hull) {
      if (corner.vertex == Corner::none || drawn_[corner.vertex]) continue;
      Triple r = view_.window(view_.ray(corner));
      if (r.z <= 0 || r.x < 0 || r.y < 0 || r.x > r.z || r.y > r.z) continue;
      const Point point = make_point(std::move(r));
      for (const std::uint32_t f : context_.faces_of[p]) {
        if (!in_closed_face(f, point)) continue;
        report_.fault("scene vertices", named("scene vertex", corner.vertex),
                      "is a corner of polygon " + std::to_string(p) + " seen in face " + std::to_string(f) +
                          ", but no vertex of the map");
        break;
      }
    }
  }

  bool in_closed_face(std::uint32_t face, const Point& p) const {
    const Box box{p.s - 0x1p-48, p.t - 0x1p-48, p.s + 0x1p-48, p.t + 0x1p-48};
    Box all;
    for (const std::int32_t entry : file_.faces[face].loops[0]) all.add(drawing_.tree().box(edge_of(entry)));
    if (!all.meets(box)) return false;
    for (const auto& loop : file_.faces[face].loops) {
      for (const std::int32_t entry : loop) {
        const std::uint32_t e = edge_of(entry);
        if (!drawing_.tree().box(e).meets(box) || side(drawing_.line(file_.edges[e].line), p) != 0) continue;
        if (compare(drawing_.start(e), p) * compare(p, drawing_.end(e)) >= 0) return true;
      }
    }
    return drawing_.holds(face, p);
  }

  const Context& context_;
  const Drawing& drawing_;
  const View& view_;
  const Scene& scene_;
  const MapFile& file_;
  Report& report_;
  std::vector<std::vector<std::uint32_t>> at_;
  std::vector<char> drawn_;
};

}  // namespace

void check_scene_vertices(const Context& context, Report& report) { SceneVertexCheck(context, report).run(); }

}  // namespace sightline::verify
