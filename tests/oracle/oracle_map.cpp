// The oracle's own map, by brute force.
#include <algorithm>
#include <numeric>
#include <optional>

#include "tests/oracle/exact_map.hpp"

namespace sightline::oracle {
namespace {

class Drawing {
 public:
  Drawing(const Scene& scene, const Camera& camera)
      : view_(scene, camera),
        plane_(arrange(view_.segments())),
        seen_(plane_.faces.size()),
        region_(plane_.faces.size()) {}

  ExactMap map() {
    for (std::uint32_t f = 1; f < plane_.faces.size(); ++f) look(f);
    unite();
    find_edges();
    name_vertices();
    trace_loops();
    std::ranges::sort(map_.faces);
    std::ranges::sort(map_.edges);
    return std::move(map_);
  }

 private:
  static constexpr std::size_t no_piece = static_cast<std::size_t>(-1);
  struct Seen {
    std::size_t piece = no_piece;
    std::vector<PolygonId> coincident;
  };
  struct Atom {  // what a border half-edge is
    EdgeKind kind = EdgeKind::window;
    PolygonId owner = none;
    bool operator==(const Atom&) const = default;
  };

  PolygonId polygon(std::uint32_t face) const {
    if (face == 0) return outside;
    return seen_[face].piece == no_piece ? none : view_.pieces()[seen_[face].piece].polygon;
  }

  /// A point in the open face: half way from the middle of an edge to what lies straight across.
  Point inner_point(std::uint32_t face) const {
    const std::uint32_t start = plane_.faces[face][0];
    const Point &a = plane_.origin(start), &b = plane_.target(start);
    const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2}, across{a.y - b.y, b.x - a.x};
    const auto along = [&](const Point& p) {  // coordinates of p - middle along the edge and across
      const mpq_class x = p.x - middle.x, y = p.y - middle.y;
      return std::pair{mpq_class(x * across.y - y * across.x), mpq_class(x * across.x + y * across.y)};
    };
    std::optional<mpq_class> nearest;
    for (const std::uint32_t border : plane_.faces[face]) {
      std::uint32_t h = border;
      do {
        const auto [x0, y0] = along(plane_.origin(h));
        const auto [x1, y1] = along(plane_.target(h));
        for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y1}}) {
          if (x == 0 && y > 0 && (!nearest || y < *nearest)) nearest = y;
        }
        if (sgn(x0) * sgn(x1) < 0) {
          const mpq_class y = y0 + (y1 - y0) * x0 / (x0 - x1);
          if (y > 0 && (!nearest || y < *nearest)) nearest = y;
        }
        h = plane_.half_edges[h].next;
      } while (h != border);
    }
    const mpq_class step = *nearest / (across.x * across.x + across.y * across.y) / 2;
    return {middle.x + step * across.x, middle.y + step * across.y};
  }

  void look(std::uint32_t face) {
    const Vec ray = View::ray(inner_point(face));
    Depth best;
    std::vector<std::size_t> nearest;
    for (std::size_t k = 0; k < view_.pieces().size(); ++k) {
      const Piece& piece = view_.pieces()[k];
      Depth depth;
      if (!View::hit(piece, ray, depth)) continue;
      const int order = nearest.empty() ? -1 : compare(depth, best);
      if (order > 0 || !view_.inside(piece, ray)) continue;
      if (order < 0) {
        nearest.clear();
        best = depth;
      }
      nearest.push_back(k);
    }
    if (nearest.empty()) return;
    seen_[face].piece = nearest.front();  // pieces ascend by polygon
    for (const std::size_t k : nearest) {
      const PolygonId p = view_.pieces()[k].polygon;
      if (p != polygon(face)) seen_[face].coincident.push_back(p);
    }
  }

  std::uint32_t root(std::uint32_t f) const {
    while (region_[f] != f) f = region_[f];
    return f;
  }
  void unite() {
    std::iota(region_.begin(), region_.end(), 0u);
    for (const HalfEdge& h : plane_.half_edges) {
      const std::uint32_t f = h.face, g = plane_.half_edges[h.twin].face;
      if (polygon(f) != polygon(g)) continue;
      const std::uint32_t a = root(f), b = root(g);
      region_[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t f = 0; f < region_.size(); ++f) region_[f] = root(f);
  }

  bool border(std::uint32_t h) const {
    return region_[plane_.half_edges[h].face] != region_[plane_.half_edges[plane_.half_edges[h].twin].face];
  }
  /// The next border half-edge of the region on the left: clockwise around the target, past what is not its border.
  std::uint32_t next_border(std::uint32_t h) const {
    std::uint32_t g = plane_.half_edges[h].next;
    while (!border(g)) g = plane_.half_edges[plane_.half_edges[g].twin].next;
    return g;
  }

  /// Does the place at this depth of the ray lie on an edge of the file that belongs to the polygon?
  bool on_input_edge(PolygonId p, const Vec& ray, const Depth& depth) const {
    const auto& corners = view_.corners(p);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec &a = view_.point(corners[k]), &b = view_.point(corners[(k + 1) % corners.size()]);
      // In homogeneous numbers: the place is depth.num * ray / depth.den.
      Vec from, edge;
      for (std::size_t i = 0; i < 3; ++i) {
        from[i] = depth.num * ray[i] - depth.den * a[i];
        edge[i] = b[i] - a[i];
      }
      if (!is_zero(cross(from, edge))) continue;
      const mpz_class at = dot(from, edge), end = depth.den * dot(edge, edge);
      if (at >= 0 && at <= end && end > 0) return true;
    }
    return false;
  }

  Atom atom_at(std::uint32_t h, const Point& place) const {
    const std::uint32_t f = plane_.half_edges[h].face, g = plane_.half_edges[plane_.half_edges[h].twin].face;
    if (f == 0 || g == 0) return {EdgeKind::window, none};
    const std::size_t a = seen_[f].piece, b = seen_[g].piece;
    if (a == no_piece || b == no_piece) return {EdgeKind::silhouette, a == no_piece ? polygon(g) : polygon(f)};
    const Piece &p = view_.pieces()[a], &q = view_.pieces()[b];
    const Vec ray = View::ray(place);
    Depth depth_p, depth_q;
    View::hit(p, ray, depth_p);
    View::hit(q, ray, depth_q);
    const int order = compare(depth_p, depth_q);
    if (order != 0) return {EdgeKind::silhouette, order < 0 ? p.polygon : q.polygon};
    if (is_zero(cross(p.normal, q.normal))) return {EdgeKind::seam, none};
    const bool edge = on_input_edge(p.polygon, ray, depth_p) || on_input_edge(q.polygon, ray, depth_q);
    return {edge ? EdgeKind::crease : EdgeKind::intersection, none};
  }

  Atom atom(std::uint32_t h) {
    const Point &a = plane_.origin(h), &b = plane_.target(h);
    const auto at = [&](int sixteenths) {
      const mpq_class w = mpq_class(sixteenths) / 16;
      return Point{a.x + w * (b.x - a.x), a.y + w * (b.y - a.y)};
    };
    const Atom middle = atom_at(h, at(8));
    if (atom_at(h, at(5)) != middle || atom_at(h, at(11)) != middle) map_.kind_changes_inside = true;
    return middle;
  }

  void find_edges() {
    const auto count = static_cast<std::uint32_t>(plane_.half_edges.size());
    std::vector<Atom> atoms(count);
    std::vector<std::vector<std::uint32_t>> leaving(plane_.points.size());
    for (std::uint32_t h = 0; h < count; ++h) {
      if (!border(h)) continue;
      atoms[h] = atom(h);
      leaving[plane_.half_edges[h].origin].push_back(h);
    }
    // The half-edge that carries on in the same line, as the same thing; none where a vertex stands.
    const auto carried_on = [&](std::uint32_t h) {
      const auto& out = leaving[plane_.half_edges[plane_.half_edges[h].twin].origin];
      if (out.size() != 2) return none;
      const std::uint32_t on = out[0] == plane_.half_edges[h].twin ? out[1] : out[0];
      const Point &a = plane_.origin(h), &b = plane_.target(h), &c = plane_.target(on);
      const bool straight = (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
      return straight && atoms[on] == atoms[h] ? on : none;
    };
    for (std::uint32_t h = 0; h < count; ++h) {
      if (!border(h)) continue;
      const std::uint32_t back = carried_on(plane_.half_edges[h].twin);
      std::uint32_t last = h;
      if (back != none) continue;  // not the first of its edge
      for (std::uint32_t on = carried_on(h); on != none; on = carried_on(on)) last = on;
      const Point &a = plane_.origin(h), &b = plane_.target(last);
      if (b < a) continue;  // found from the other end too
      map_.edges.push_back(words(ExactEdge{{a, b},
                                           polygon(plane_.half_edges[h].face),
                                           polygon(plane_.half_edges[plane_.half_edges[h].twin].face),
                                           atoms[h].kind,
                                           atoms[h].owner}));
    }
  }

  /// At each point of the arrangement: the lowest vertex of the scene that is seen there and lies on a surface seen
  /// right beside it.
  void name_vertices() {
    std::vector<std::set<std::size_t>> beside(plane_.points.size());
    for (const HalfEdge& h : plane_.half_edges) {
      if (h.face != 0 && seen_[h.face].piece != no_piece) beside[h.origin].insert(seen_[h.face].piece);
    }
    for (std::size_t k = 0; k < plane_.points.size(); ++k) {
      const Vec ray = View::ray(plane_.points[k]);
      for (PointId v = 0; v < view_.point_count(); ++v) {
        const Vec& x = view_.point(v);
        if (!view_.used(v) || x[0] <= 0 || !is_zero(cross(ray, x))) continue;
        const bool seen = std::ranges::any_of(
            beside[k], [&](std::size_t p) { return dot(view_.pieces()[p].normal, x) == view_.pieces()[p].offset; });
        if (!seen) continue;
        map_.scene_vertex[words(plane_.points[k])] = v;
        break;
      }
    }
  }

  void trace_loops() {
    std::map<std::uint32_t, std::vector<std::vector<Point>>> loops;
    std::map<std::uint32_t, std::set<PolygonId>> coincident;
    for (std::uint32_t f = 1; f < region_.size(); ++f) {
      coincident[region_[f]].insert(seen_[f].coincident.begin(), seen_[f].coincident.end());
    }
    std::vector<char> done(plane_.half_edges.size());
    for (std::uint32_t h = 0; h < done.size(); ++h) {
      const std::uint32_t region = region_[plane_.half_edges[h].face];
      if (region == 0 || !border(h) || done[h]) continue;
      std::vector<Point> loop;
      for (std::uint32_t g = h; !done[g]; g = next_border(g)) {
        done[g] = 1;
        loop.push_back(plane_.origin(g));
      }
      loops[region].push_back(loop);
    }
    for (const auto& [region, of_region] : loops) {
      const auto& others = coincident[region];
      map_.faces.push_back(words(polygon(region), {others.begin(), others.end()}, of_region));
    }
  }

  View view_;
  Arrangement plane_;
  std::vector<Seen> seen_;
  std::vector<std::uint32_t> region_;
  ExactMap map_;
};

}  // namespace

ExactMap oracle_map(const Scene& scene, const Camera& camera) { return Drawing(scene, camera).map(); }

}  // namespace sightline::oracle
