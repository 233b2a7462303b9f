// No polygon is nearer than what a face sees: for every convex piece of every polygon, the faces whose interiors it
// meets are found, and in each the region where it would be nearer (the piece, cut by a line, since inverse distances
// are linear in the window) must not meet the face.
#include "verify/checks.hpp"
#include "verify/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::verify {

namespace {

enum class Problem { nearer, coplanar };
struct Finding {
  std::uint32_t face, polygon;
  Problem problem;
  auto operator<=>(const Finding&) const = default;
};

class Worker {
 public:
  Worker(const Context& context, std::span<const double> face_least, std::span<const View::Near> near)
      : context_(context),
        drawing_(context.drawing),
        view_(drawing_.view()),
        file_(drawing_.file()),
        face_least_(face_least),
        near_(near),
        stamp_(file_.faces.size(), 0) {}

  std::vector<Finding> findings;

  void polygon(std::uint32_t q) {
    const auto corners = view_.scene().corners(q);
    inside_ = true;
    if (!may_matter(q, corners)) return;
    for (const Surface& surface : view_.scene().shape(q).surfaces) {
      const std::optional<Depth> depth = view_.depth(surface);
      if (!depth || (context_.one_sided && !depth->front)) continue;
      for (const Piece& p : surface.inside) piece(q, *depth, p);
    }
  }

 private:
  /// Filter: false where the polygon is certainly outside of the window or behind everything.
  bool may_matter(std::uint32_t q, std::span<const std::uint32_t> corners) {
    bool in_front = true, left = true, right = true, below = true, above = true, behind = true;
    Box box;
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t v : corners) {
      const auto [x, y, z, e] = near_[v];
      in_front = in_front && z > e;
      behind = behind && z < -e;
      left = left && x < -e;
      below = below && y < -e;
      right = right && x - z > 3 * e;  // the difference is rounded once
      above = above && y - z > 3 * e;
      inside_ = inside_ && x > e && y > e && z - x > 3 * e && z - y > 3 * e;
      const double s0 = (x - e) / (x > e ? z + e : z - e), s1 = (x + e) / (x > -e ? z - e : z + e);
      const double t0 = (y - e) / (y > e ? z + e : z - e), t1 = (y + e) / (y > -e ? z - e : z + e);
      box.add({s0, t0, s1, t1});
      nearest = std::min(nearest, z - e);
    }
    if (left || right || below || above || behind) return false;
    if (!in_front || !context_.faces_of[q].empty()) return true;
    const auto clamp = [](double x) { return std::min(std::max(x, 0.0), 1.0); };
    // Roundings of the quotients: 3 * 2^-53 of values that are cut to [0, 1] (or do not matter).
    box = {clamp(box.s0 - 0x1p-50), clamp(box.t0 - 0x1p-50), clamp(box.s1 + 0x1p-50), clamp(box.t1 + 0x1p-50)};
    if (view_.inverse_factor() < 0x1p-900) return true;  // the filter would leave the range of doubles
    const double inverse = view_.inverse_factor() / nearest * (1 + 0x1p-48);
    return !hidden(box, inverse);
  }

  /// Certainly behind what the file shows, all over the box?
  bool hidden(const Box& box, double inverse) const {
    const auto behind = [&](std::uint32_t face) {
      if (face == none || face_least_[face] > inverse) return true;
      const std::uint32_t p = file_.faces[face].polygon;
      if (p == none || context_.seen[p].size() != 1) return false;
      const Depth& d = context_.seen[p][0].depth;
      const double least = d.a * (d.a > 0 ? box.s0 : box.s1) + d.b * (d.b > 0 ? box.t0 : box.t1) + d.c;
      return least - d.scale * 0x1p-47 - 0x1p-1000 > inverse;
    };
    const auto holds = [&](const Point& p) { return p.s > box.s0 && p.s < box.s1 && p.t > box.t0 && p.t < box.t1; };
    bool crossed = false;
    const bool clear =
        drawing_.tree().visit([&](const Box& b, double least) { return b.meets(box) && !(least > inverse); },
                              [&](std::uint32_t e) {
                                if (!drawing_.tree().box(e).meets(box)) return true;
                                crossed = crossed || holds(drawing_.start(e)) || holds(drawing_.end(e));
                                return behind(file_.edges[e].left) && behind(file_.edges[e].right);
                              });
    if (!clear) return false;
    // Either edges meet the box, and the faces on their sides are all that do, or it lies within one face.
    return crossed || behind(drawing_.locate(point_at((box.s0 + box.s1) / 2, (box.t0 + box.t1) / 2)));
  }

  static Point point_at(double s, double t) {
    const unsigned bits = std::max(fraction_bits(s), fraction_bits(t));
    return {{scaled_integer(s, bits), scaled_integer(t, bits), Integer(1) << bits}, s, t};
  }

  void piece(std::uint32_t q, const Depth& depth, const Piece& p) {
    const std::deque<Line> lines = view_.sides(p, depth.front);
    Convex region;
    const bool plain =
        inside_ && std::all_of(p.begin(), p.end(), [](const Corner& c) { return c.vertex != Corner::none; });
    if (plain) {
      region.sides = pointers(lines);
      for (const Corner& c : p) region.corners.push_back(make_point(view_.window(view_.ray(c))));
    } else if (!clip_all(view_.square(), pointers(lines), region)) {
      return;
    }
    edges_.clear();
    faces_.clear();
    ++now_;
    drawing_.tree().visit([&](const Box& b, double) { return !outside(region.sides, b); },
                          [&](std::uint32_t e) {
                            if (meets_segment(region.sides, drawing_.start(e), drawing_.end(e))) {
                              edges_.push_back(e);
                              note(file_.edges[e].left);
                              note(file_.edges[e].right);
                            }
                            return true;
                          });
    if (edges_.empty()) note(drawing_.locate(middle(region)));
    mixed_.clear();
    for (const std::uint32_t face : faces_) {
      if (file_.faces[face].polygon != q) against(q, depth, region, face);
    }
    if (!mixed_.empty()) settle(q, region);
  }

  void note(std::uint32_t face) {
    if (face == none || stamp_[face] == now_) return;
    stamp_[face] = now_;
    faces_.push_back(face);
  }

  void found(std::uint32_t face, std::uint32_t q, Problem problem) { findings.push_back({face, q, problem}); }

  /// The region of q meets the face: is q nearer there?
  void against(std::uint32_t q, const Depth& depth, const Convex& region, std::uint32_t face) {
    const std::uint32_t p = file_.faces[face].polygon;
    if (p == none) return found(face, q, Problem::nearer);
    const auto& seen = context_.seen[p];
    if (seen.size() != 1) return against_several(q, depth, region, face);
    bool nearer = false, farther = false;
    for (const Point& corner : region.corners) {
      const int sign = compare_depth(depth, seen[0].depth, corner);
      nearer = nearer || sign > 0;
      farther = farther || sign < 0;
    }
    if (!nearer && !farther) {
      found(face, q, Problem::coplanar);
    } else if (nearer && !farther) {
      found(face, q, Problem::nearer);
    } else if (nearer) {
      mixed_.push_back({face, make_line(depth_line(depth, seen[0].depth))});
    }
  }

  /// q is nearer in a part of the region only, on one side of a line: does that part meet the face?
  struct Mixed {
    std::uint32_t face;
    Line line;
    bool done = false;
  };

  void settle(std::uint32_t q, const Convex& region) {
    std::vector<const Line*> lines = region.sides;
    lines.push_back(nullptr);
    for (const std::uint32_t e : edges_) {
      for (Mixed& m : mixed_) {
        if (m.done || (file_.edges[e].left != m.face && file_.edges[e].right != m.face)) continue;
        lines.back() = &m.line;
        m.done = meets_segment(lines, drawing_.start(e), drawing_.end(e));
        if (m.done) found(m.face, q, Problem::nearer);
      }
    }
    for (const Mixed& m : mixed_) {
      Convex part;
      if (!m.done && clip(region, &m.line, part) && drawing_.holds(m.face, middle(part))) {
        found(m.face, q, Problem::nearer);
      }
    }
  }

  /// The same for a face that sees several triangles of a polygon that is not planar: what is left of q's region
  /// where all triangles nearer than q are taken out must not meet the face.
  void against_several(std::uint32_t q, const Depth& depth, const Convex& region, std::uint32_t face) {
    const auto& seen = context_.seen[file_.faces[face].polygon];
    const bool behind_all = std::all_of(seen.begin(), seen.end(), [&](const SeenSurface& s) {
      return std::all_of(region.corners.begin(), region.corners.end(),
                         [&](const Point& p) { return compare_depth(depth, s.depth, p) < 0; });
    });
    if (behind_all) return;
    std::deque<Line> pool;
    std::vector<Convex> left{region};
    for (const SeenSurface& s : seen) {
      std::vector<const Line*> lines = pointers(s.hull);
      if (same_plane(s.depth, depth)) {
        if (lies_in(region, seen, s, face)) found(face, q, Problem::coplanar);
      } else {
        pool.push_back(make_line(depth_line(s.depth, depth)));
        lines.push_back(&pool.back());
      }
      left = subtract(left, lines, pool);
    }
    for (const Convex& part : left) {
      if (meets_face(drawing_, part, face)) return found(face, q, Problem::nearer);
    }
  }

  /// Does the region meet the face where the face sees this triangle of its polygon?
  bool lies_in(const Convex& region, const std::vector<SeenSurface>& seen, const SeenSurface& triangle,
               std::uint32_t face) {
    Convex common;
    if (!clip_all(region, pointers(triangle.hull), common)) return false;
    std::deque<Line> pool;
    std::vector<Convex> left{common};
    for (const SeenSurface& s : seen) {
      if (&s == &triangle || same_plane(s.depth, triangle.depth)) continue;
      std::vector<const Line*> lines = pointers(s.hull);
      pool.push_back(make_line(depth_line(s.depth, triangle.depth)));
      lines.push_back(&pool.back());
      left = subtract(left, lines, pool);
    }
    return std::any_of(left.begin(), left.end(), [&](const Convex& part) { return meets_face(drawing_, part, face); });
  }

  const Context& context_;
  const Drawing& drawing_;
  const View& view_;
  const MapFile& file_;
  std::span<const double> face_least_;
  std::span<const View::Near> near_;
  bool inside_ = false;  // the polygon at hand is certainly inside the window
  std::vector<std::uint32_t> stamp_;
  std::uint32_t now_ = 0;
  std::vector<std::uint32_t> edges_, faces_;
  std::vector<Mixed> mixed_;
};

/// A lower bound of the inverse distance of what a face sees.
double least_inverse(const Context& context, std::span<const View::Near> near, std::uint32_t face) {
  const Drawing& drawing = context.drawing;
  const MapFace& f = drawing.file().faces[face];
  if (f.polygon == none) return -std::numeric_limits<double>::infinity();
  const auto& seen = context.seen[f.polygon];
  if (seen.size() == 1) {
    const Depth& d = seen[0].depth;
    double least = std::numeric_limits<double>::infinity();
    for (const std::int32_t entry : f.loops[0]) {
      const Point& p = drawing.vertex(drawing.from(entry));
      least = std::min(least, d.a * p.s + d.b * p.t + d.c);
    }
    return least - d.scale * 0x1p-47 - 0x1p-1000;
  }
  double farthest = 0;
  for (const std::uint32_t v : drawing.view().scene().corners(f.polygon)) {
    farthest = std::max(farthest, near[v].z + near[v].error);
  }
  return drawing.view().inverse_factor() / farthest * (1 - 0x1p-48);
}

}  // namespace

void check_depth(Context& context, Report& report) {
  Drawing& drawing = context.drawing;
  const MapFile& file = drawing.file();
  const View& view = drawing.view();
  std::vector<View::Near> near(view.scene().vertex_count());
  for (std::uint32_t v = 0; v < near.size(); ++v) near[v] = view.near(v);
  std::vector<double> face_least(file.faces.size()), edge_least;
  for (std::uint32_t f = 0; f < face_least.size(); ++f) face_least[f] = least_inverse(context, near, f);
  for (const MapEdge& e : file.edges) {
    const double infinite = std::numeric_limits<double>::infinity();
    edge_least.push_back(
        std::min(e.left == none ? infinite : face_least[e.left], e.right == none ? infinite : face_least[e.right]));
  }
  drawing.tree().set_values(edge_least);

  std::vector<Worker> workers(context.threads, Worker(context, face_least, near));
  parallel_for(context.threads, view.scene().polygon_count(),
               [&](unsigned worker, std::size_t q) { workers[worker].polygon(static_cast<std::uint32_t>(q)); });
  std::vector<Finding> findings;
  for (const Worker& worker : workers) {
    findings.insert(findings.end(), worker.findings.begin(), worker.findings.end());
  }
  std::sort(findings.begin(), findings.end());
  findings.erase(std::unique(findings.begin(), findings.end()), findings.end());

  std::vector<std::vector<std::uint32_t>> coplanar(file.faces.size());
  for (const Finding& finding : findings) {
    const std::string face = named("face", finding.face), polygon = named("polygon", finding.polygon);
    const std::uint32_t own = file.faces[finding.face].polygon;
    if (finding.problem == Problem::coplanar) {
      coplanar[finding.face].push_back(finding.polygon);
      if (finding.polygon < own) {
        report.fault("coincident", face, polygon + " lies in the same place and has the lower index");
      }
    } else if (own == none) {
      report.fault("depth", face, polygon + " is seen in it, where the file says nothing is");
    } else {
      report.fault("depth", face, polygon + " is nearer in a part of it than polygon " + std::to_string(own));
    }
  }
  for (std::size_t f = 0; f < file.faces.size(); ++f) {
    const auto& listed = file.faces[f].coincident;
    for (const std::uint32_t q : coplanar[f]) {
      if (q > file.faces[f].polygon && !std::binary_search(listed.begin(), listed.end(), q)) {
        report.fault("coincident", named("face", f), named("polygon", q) + " lies in the same place and is not listed");
      }
    }
    for (const std::uint32_t q : listed) {
      if (!std::binary_search(coplanar[f].begin(), coplanar[f].end(), q)) {
        report.fault("coincident", named("face", f), named("polygon", q) + " is listed but lies elsewhere");
      }
    }
  }
}

}  // namespace sightline::verify
