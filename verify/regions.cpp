#include "verify/regions.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::verify {

std::vector<SeenSurface> see(const View& view, std::uint32_t polygon, bool one_sided) {
  std::vector<SeenSurface> seen;
  for (const Surface& surface : view.scene().shape(polygon).surfaces) {
    std::optional<Depth> depth = view.depth(surface);
    if (!depth || (one_sided && !depth->front)) continue;
    SeenSurface s;
    s.surface = &surface;
    s.hull = view.sides(surface.hull, depth->front);
    for (const Piece& piece : surface.outside) s.outside.push_back(view.sides(piece, depth->front));
    s.depth = std::move(*depth);
    seen.push_back(std::move(s));
  }
  return seen;
}

const SeenSurface* nearest_beside(const std::vector<SeenSurface>& seen, const Point& p, const Triple& direction) {
  // Signs just beside the point: of the value there or, where that is zero, of its growth in the direction.
  const auto beside = [&](const Line& line) {
    const int here = side(line, p);
    return here != 0 ? here : sign_dot(line.n, direction);
  };
  const SeenSurface* nearest = nullptr;
  for (const SeenSurface& s : seen) {
    if (std::any_of(s.hull.begin(), s.hull.end(), [&](const Line& line) { return beside(line) <= 0; })) continue;
    if (nearest) {
      int order = compare_depth(s.depth, nearest->depth, p);
      if (order == 0) order = sign_dot(depth_line(s.depth, nearest->depth), direction);
      if (order <= 0) continue;
    }
    nearest = &s;
  }
  return nearest;
}

std::vector<const Line*> pointers(const std::deque<Line>& lines) {
  std::vector<const Line*> out;
  for (const Line& line : lines) out.push_back(&line);
  return out;
}

bool outside(std::span<const Line* const> lines, const Box& box) {
  const double s = (box.s0 + box.s1) / 2, t = (box.t0 + box.t1) / 2;
  const double ds = (box.s1 - box.s0) / 2, dt = (box.t1 - box.t0) / 2;
  for (const Line* line : lines) {
    const double most = line->a * s + line->b * t + line->c + std::abs(line->a) * ds + std::abs(line->b) * dt;
    if (most < -0x1p-46) return true;
  }
  return false;
}

bool clip_all(const Convex& region, std::span<const Line* const> lines, Convex& out) {
  Convex current = region;
  for (const Line* line : lines) {
    if (!clip(current, line, current)) return false;
  }
  out = std::move(current);
  return true;
}

std::vector<Convex> subtract(const std::vector<Convex>& pieces, std::span<const Line* const> lines,
                             std::deque<Line>& pool) {
  std::vector<const Line*> opposite;
  for (const Line* line : lines) {
    Triple n = line->n;
    negate(n);
    pool.push_back(make_line(std::move(n)));
    opposite.push_back(&pool.back());
  }
  std::vector<Convex> left;
  for (const Convex& piece : pieces) {
    std::vector<Convex> parts;
    Convex rest = piece;
    bool met = true;
    for (std::size_t i = 0; i < lines.size() && met; ++i) {
      Convex part;
      if (clip(rest, opposite[i], part)) parts.push_back(std::move(part));
      met = clip(rest, lines[i], rest);
    }
    if (met) {
      for (Convex& part : parts) left.push_back(std::move(part));
    } else {
      left.push_back(piece);
    }
  }
  return left;
}

bool meets_face(const Drawing& drawing, const Convex& region, std::uint32_t face) {
  const auto crossed = [&](std::uint32_t e) { return meets_segment(region.sides, drawing.start(e), drawing.end(e)); };
  const auto& loops = drawing.file().faces[face].loops;
  std::size_t size = 0;
  for (const auto& loop : loops) size += loop.size();
  if (size <= 64) {
    for (const auto& loop : loops) {
      for (const std::int32_t entry : loop) {
        if (crossed(edge_of(entry))) return true;
      }
    }
  } else {
    const bool none_crossed = drawing.tree().visit([&](const Box& b, double) { return !outside(region.sides, b); },
                                                   [&](std::uint32_t e) {
                                                     const MapEdge& edge = drawing.file().edges[e];
                                                     return (edge.left != face && edge.right != face) || !crossed(e);
                                                   });
    if (!none_crossed) return true;
  }
  return drawing.holds(face, middle(region));
}

}  // namespace sightline::verify
