// Every face lies within what its polygon covers.
#include "verify/checks.hpp"
#include "verify/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::verify {

Context make_context(Drawing& drawing, bool one_sided, unsigned threads) {
  Context context{drawing, one_sided, threads, {}, {}};
  const Scene& scene = drawing.view().scene();
  context.seen.resize(scene.polygon_count());
  context.faces_of.resize(scene.polygon_count());
  std::vector<std::uint32_t> polygons;
  for (std::uint32_t f = 0; f < drawing.file().faces.size(); ++f) {
    const std::uint32_t p = drawing.file().faces[f].polygon;
    if (p == none) continue;
    if (context.faces_of[p].empty()) polygons.push_back(p);
    context.faces_of[p].push_back(f);
  }
  parallel_for(threads, polygons.size(), [&](unsigned, std::size_t i) {
    context.seen[polygons[i]] = see(drawing.view(), polygons[i], one_sided);
  });
  return context;
}

namespace {

/// A rectangle around a face, within the window.
Convex box_around(const Drawing& drawing, std::uint32_t face, std::deque<Line>& pool) {
  Box box;
  for (const std::int32_t entry : drawing.file().faces[face].loops[0]) box.add(drawing.tree().box(edge_of(entry)));
  const auto upright = [](double at, int sign) {  // sign * (s - at) as a line
    const unsigned bits = fraction_bits(at);
    return Triple{Integer(sign) << bits, 0, -sign * scaled_integer(at, bits)};
  };
  const auto level = [&](double at, int sign) {
    Triple n = upright(at, sign);
    std::swap(n.x, n.y);
    return n;
  };
  std::vector<const Line*> lines;
  for (const Triple& n : {upright(box.s0, 1), upright(box.s1, -1), level(box.t0, 1), level(box.t1, -1)}) {
    pool.push_back(make_line(n));
    lines.push_back(&pool.back());
  }
  Convex out;
  clip_all(drawing.view().square(), lines, out);
  return out;
}

bool covered(const Context& context, std::uint32_t face) {
  const Drawing& drawing = context.drawing;
  const MapFace& f = drawing.file().faces[face];
  const auto& seen = context.seen[f.polygon];
  const auto within = [&](const SeenSurface& s) {
    return std::all_of(f.loops[0].begin(), f.loops[0].end(), [&](std::int32_t entry) {
      const Point& p = drawing.vertex(drawing.from(entry));
      return std::all_of(s.hull.begin(), s.hull.end(), [&](const Line& line) { return side(line, p) >= 0; });
    });
  };
  const auto clear_of = [&](const std::deque<Line>& lines) {
    Convex region;
    return !clip_all(drawing.view().square(), pointers(lines), region) || !meets_face(drawing, region, face);
  };
  if (seen.size() == 1) {
    return within(seen[0]) && std::all_of(seen[0].outside.begin(), seen[0].outside.end(), clear_of);
  }
  if (std::any_of(seen.begin(), seen.end(), within)) return true;
  std::deque<Line> pool;
  std::vector<Convex> left{box_around(drawing, face, pool)};
  for (const SeenSurface& s : seen) left = subtract(left, pointers(s.hull), pool);
  return std::none_of(left.begin(), left.end(), [&](const Convex& r) { return meets_face(drawing, r, face); });
}

}  // namespace

void check_cover(const Context& context, Report& report) {
  const MapFile& file = context.drawing.file();
  std::vector<char> right(file.faces.size(), 1);
  parallel_for(context.threads, file.faces.size(), [&](unsigned, std::size_t f) {
    if (file.faces[f].polygon != none) right[f] = covered(context, static_cast<std::uint32_t>(f));
  });
  for (std::size_t f = 0; f < right.size(); ++f) {
    if (right[f]) continue;
    const std::uint32_t p = file.faces[f].polygon;
    report.fault("cover", named("face", f),
                 context.seen[p].empty() ? named("polygon", p) + " is not seen from this eye"
                                         : "is not wholly covered by polygon " + std::to_string(p));
  }
}

}  // namespace sightline::verify
