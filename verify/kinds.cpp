// Kind and owner of every edge, by what meets along it.
#include "verify/checks.hpp"
#include "verify/parallel.hpp"

#include <algorithm>

namespace sightline::verify {

namespace {

/// What an edge may be called; silhouettes with the polygon that is nearer.
struct Allowed {
  std::array<bool, 5> kind{};
  std::vector<std::uint32_t> owners;
};

/// The angle from ray a to ray b in the plane of `line` (all in the window's coordinates): its sign.
int turn(const Line& line, const Triple& a, const Triple& b) { return sign_dot(cross(a, b), line.n); }

/// The part of a line between two rays less than half a turn apart.
struct Span {
  Triple from, to;
};
Span directed(const Line& line, Triple a, Triple b) {
  return turn(line, a, b) >= 0 ? Span{std::move(a), std::move(b)} : Span{std::move(b), std::move(a)};
}
bool strictly_in(const Line& line, const Triple& x, const Span& s) {
  return turn(line, s.from, x) > 0 && turn(line, x, s.to) > 0;
}
/// Do two spans on a line share more than a point?
bool overlap(const Line& line, const Span& a, const Span& b) {
  if (turn(line, a.from, a.to) == 0 || turn(line, b.from, b.to) == 0) return false;
  if (strictly_in(line, a.from, b) || strictly_in(line, a.to, b) || strictly_in(line, b.from, a) ||
      strictly_in(line, b.to, a)) {
    return true;
  }
  return cross(a.from, b.from).is_zero() && cross(a.to, b.to).is_zero() && dot(a.from, b.from) > 0;
}
bool within(const Line& line, const Span& inner, const Span& outer) {
  return turn(line, outer.from, inner.from) >= 0 && turn(line, inner.from, outer.to) > 0 &&
         turn(line, outer.from, inner.to) > 0 && turn(line, inner.to, outer.to) >= 0;
}

class KindCheck {
 public:
  KindCheck(const Context& context, std::uint32_t edge)
      : context_(context),
        drawing_(context.drawing),
        view_(drawing_.view()),
        edge_(drawing_.file().edges[edge]),
        line_(drawing_.line(edge_.line)),
        start_(drawing_.start(edge)),
        end_(drawing_.end(edge)),
        left_sign_(drawing_.left_sign(edge)) {}

  Allowed allowed() {
    const auto polygon = [&](std::uint32_t face) { return drawing_.file().faces[face].polygon; };
    left_ = polygon(edge_.left);
    right_ = polygon(edge_.right);
    if (left_ == none || right_ == none) {
      silhouette(left_ == none ? right_ : left_);
      return out_;
    }
    const auto &l = context_.seen[left_], &r = context_.seen[right_];
    if (l.size() == 1 && r.size() == 1) {
      stretch(l[0], r[0], start_, end_);
    } else {
      several(l, r);
    }
    return out_;
  }

  /// Does the scene edge that names the edge's line run along a part of it?
  bool carried() const {
    const MapLine& name = drawing_.file().lines[edge_.line];
    if (name.kind != MapLine::edge) return true;
    return overlap(line_, directed(line_, start_.r, end_.r), scene_span(name.v[0], name.v[1]));
  }

 private:
  void allow(EdgeKind kind) { out_.kind[static_cast<std::size_t>(kind)] = true; }
  void silhouette(std::uint32_t owner) {
    allow(EdgeKind::silhouette);
    out_.owners.push_back(owner);
  }

  Span scene_span(std::uint32_t a, std::uint32_t b) const {
    return directed(line_, view_.window(view_.ray(a)), view_.window(view_.ray(b)));
  }

  /// A part of the edge along which these two surfaces are seen on its sides.
  void stretch(const SeenSurface& l, const SeenSurface& r, const Point& u, const Point& v) {
    const int at_u = compare_depth(l.depth, r.depth, u), at_v = compare_depth(l.depth, r.depth, v);
    if (at_u > 0 || at_v > 0) silhouette(left_);
    if (at_u < 0 || at_v < 0) silhouette(right_);
    if (at_u != 0 || at_v != 0) return;
    if (same_plane(l.depth, r.depth)) return allow(EdgeKind::seam);
    const Span here = directed(line_, u.r, v.r);
    const MapLine& name = drawing_.file().lines[edge_.line];
    bool covered = false, touched = false;
    for (const SeenSurface* s : {&l, &r}) {
      for (const auto& [a, b] : s->surface->input_edges) {
        const bool named =
            name.kind == MapLine::edge && ((name.v[0] == a && name.v[1] == b) || (name.v[0] == b && name.v[1] == a));
        if (!named && (sign_dot(line_.n, view_.window(view_.ray(a))) != 0 ||
                       sign_dot(line_.n, view_.window(view_.ray(b))) != 0)) {
          continue;
        }
        const Span span = scene_span(a, b);
        if (!overlap(line_, here, span)) continue;
        touched = true;
        covered = covered || within(line_, here, span);
      }
    }
    if (touched) allow(EdgeKind::crease);
    if (!covered) allow(EdgeKind::intersection);
  }

  /// Where a side of the edge sees several triangles of a polygon: stretch by stretch.
  void several(const std::vector<SeenSurface>& l, const std::vector<SeenSurface>& r) {
    std::vector<Point> breaks{start_, end_};
    const auto add = [&](const Line& line) {
      if (side(line, start_) * side(line, end_) < 0) breaks.push_back(crossing(line_, line));
    };
    for (const auto* seen : {&l, &r}) {
      if (seen->size() == 1) continue;
      for (std::size_t i = 0; i < seen->size(); ++i) {
        for (const Line& line : (*seen)[i].hull) add(line);
        for (std::size_t k = 0; k < i; ++k) add(make_line(depth_line((*seen)[i].depth, (*seen)[k].depth)));
      }
    }
    std::sort(breaks.begin(), breaks.end(), [](const Point& a, const Point& b) { return compare(a, b) < 0; });
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      if (compare(breaks[i], breaks[i + 1]) == 0) continue;
      const Point mid = make_point(breaks[i].r + breaks[i + 1].r);
      // Leftwards of the edge: the way in which its line's value rises, times the sign that its left side has.
      const Triple rise{line_.n.x, line_.n.y, 0};
      const SeenSurface* a = nearest_beside(l, mid, Integer(left_sign_) * rise);
      const SeenSurface* b = nearest_beside(r, mid, Integer(-left_sign_) * rise);
      if (a && b) stretch(*a, *b, breaks[i], breaks[i + 1]);
    }
  }

  const Context& context_;
  const Drawing& drawing_;
  const View& view_;
  const MapEdge& edge_;
  const Line& line_;
  const Point &start_, &end_;
  int left_sign_;
  std::uint32_t left_ = none, right_ = none;
  Allowed out_;
};

std::string list_of(const Allowed& allowed) {
  std::string text;
  for (std::size_t k = 0; k < allowed.kind.size(); ++k) {
    if (allowed.kind[k]) text += (text.empty() ? "" : " or ") + std::string(name_of(static_cast<EdgeKind>(k)));
  }
  for (std::size_t i = 0; i < allowed.owners.size() && allowed.kind[0]; ++i) {
    const std::string owner = std::to_string(allowed.owners[i]);
    if (i == 0) text += " (owner " + owner;
    if (i > 0 && allowed.owners[i] != allowed.owners[0]) text += " or " + owner;
    if (i + 1 == allowed.owners.size()) text += ")";
  }
  return text;
}

}  // namespace

void check_kinds(const Context& context, Report& report) {
  const MapFile& file = context.drawing.file();
  std::vector<std::string> kinds(file.edges.size());
  std::vector<char> carried(file.edges.size(), 1);
  parallel_for(context.threads, file.edges.size(), [&](unsigned, std::size_t i) {
    const MapEdge& e = file.edges[i];
    KindCheck check(context, static_cast<std::uint32_t>(i));
    carried[i] = check.carried();
    Allowed allowed;
    if (e.left == none || e.right == none) {
      allowed.kind[static_cast<std::size_t>(EdgeKind::window)] = true;
    } else {
      const auto unseen = [&](std::uint32_t f) {
        return file.faces[f].polygon != none && context.seen[file.faces[f].polygon].empty();
      };
      if (unseen(e.left) || unseen(e.right)) return;  // a fault of "cover"
      allowed = check.allowed();
    }
    const bool kind_right = allowed.kind[static_cast<std::size_t>(e.kind)];
    const bool owner_right = e.kind == EdgeKind::silhouette ? std::find(allowed.owners.begin(), allowed.owners.end(),
                                                                        e.owner) != allowed.owners.end()
                                                            : e.owner == none;
    if (kind_right && owner_right) return;
    const std::string owner = e.owner == none ? "null" : std::to_string(e.owner);
    kinds[i] = std::string("is called ") + name_of(e.kind) + " (owner " + owner + "), it is " + list_of(allowed);
  });
  for (std::size_t i = 0; i < file.edges.size(); ++i) {
    if (!kinds[i].empty()) report.fault("kinds", named("edge", i), kinds[i]);
    if (!carried[i])
      report.fault("lines", named("edge", i), "its line is named by a scene edge that does not run along it");
  }
}

void check_maximality(const Context& context, Report& report) {
  const Drawing& drawing = context.drawing;
  const MapFile& file = drawing.file();
  for (std::size_t i = 0; i < file.edges.size(); ++i) {
    const MapEdge& e = file.edges[i];
    if (e.left != none && e.right != none && file.faces[e.left].polygon == file.faces[e.right].polygon) {
      report.fault("maximality", named("edge", i), "has the same polygon on both sides");
    }
  }
  for (std::uint32_t v = 0; v < file.vertices.size(); ++v) {
    const auto ring = drawing.around(v);
    if (ring.size() != 2) continue;
    const MapEdge &a = file.edges[edge_of(ring[0])], &b = file.edges[edge_of(ring[1])];
    if (a.kind != b.kind || a.owner != b.owner) continue;
    if (drawing.side_at(a.line, drawing.to(ring[1])) == 0) {
      report.fault("maximality", named("vertex", v),
                   "stands between two edges of one kind and owner in a straight line");
    }
  }
}

}  // namespace sightline::verify
