// A drawing over a drawing.
#include "compare/overlay.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::comparison {
namespace {

/// An edge that rises from `low` to `high`, of one of the two drawings, with the faces on its two sides.
struct Rising {
  glm::dvec2 low, high;
  std::uint32_t right;
  bool other;
  double s(double t) const { return low.x + (t - low.y) / (high.y - low.y) * (high.x - low.x); }
};

void add_rising(const Drawing& drawing, bool other, std::vector<Rising>& rising) {
  for (const Drawing::Edge& e : drawing.edges) {
    const glm::dvec2 from = drawing.corners[e.from], to = drawing.corners[e.to];
    if (from.y < to.y) rising.push_back({from, to, e.right, other});
    if (to.y < from.y) rising.push_back({to, from, e.left, other});
  }
}

/// The edges of one stretch of t at its two ends, sorted by where they are.
struct Passing {
  double from, to;
  const Rising* edge;
};

/// Where edges of a stretch that are sorted at its beginning change places: parts of the stretch from 0 to 1.
void crossings(std::vector<Passing>& passing, std::vector<double>& parts) {
  parts.clear();
  for (std::size_t k = 1; k < passing.size(); ++k) {
    const Passing moved = passing[k];
    std::size_t i = k;
    for (; i > 0 && passing[i - 1].to > moved.to; --i) {
      const double before = moved.from - passing[i - 1].from, after = passing[i - 1].to - moved.to;
      if (before + after > 0) parts.push_back(before / (before + after));
      passing[i] = passing[i - 1];
    }
    passing[i] = moved;
  }
}

}  // namespace

void differences(const Drawing& drawing, const Drawing& other, const Agrees& agrees, const Part& part) {
  std::vector<Rising> rising;
  add_rising(drawing, false, rising);
  add_rising(other, true, rising);
  std::ranges::stable_sort(rising, {}, [](const Rising& r) { return r.low.y; });
  std::vector<double> heights;
  for (const Rising& r : rising) {
    heights.push_back(r.low.y);
    heights.push_back(r.high.y);
  }
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());

  std::vector<const Rising*> active;
  std::vector<Passing> passing, sorted;
  std::vector<double> parts;
  std::size_t next = 0;
  const auto walk = [&](double bottom, double top) {  // a stretch without crossings
    const double t = (bottom + top) / 2;
    for (Passing& p : sorted) p.from = p.edge->s(t);
    std::ranges::stable_sort(sorted, {}, &Passing::from);
    std::uint32_t face = none, other_face = none;
    for (std::size_t k = 0; k + 1 < sorted.size(); ++k) {
      (sorted[k].edge->other ? other_face : face) = sorted[k].edge->right;
      const double width = sorted[k + 1].from - sorted[k].from;
      if (!(width > 0) || face == none) continue;
      const PolygonId shown = other_face == none ? none : other.polygons[other_face];
      if (!agrees(face, shown)) part(face, shown, width * (top - bottom));
    }
  };
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double bottom = heights[h], top = heights[h + 1];
    std::erase_if(active, [&](const Rising* r) { return r->high.y <= bottom; });
    for (; next < rising.size() && rising[next].low.y <= bottom; ++next) active.push_back(&rising[next]);
    passing.clear();
    for (const Rising* r : active) passing.push_back({r->s(bottom), r->s(top), r});
    std::ranges::stable_sort(
        passing, [](const Passing& a, const Passing& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    sorted = passing;
    crossings(passing, parts);
    std::ranges::sort(parts);
    double from = bottom;
    for (const double p : parts) {
      const double to = bottom + p * (top - bottom);
      if (to > from) walk(from, to);
      from = std::max(from, to);
    }
    if (top > from) walk(from, top);
  }
}

}  // namespace sightline::comparison
