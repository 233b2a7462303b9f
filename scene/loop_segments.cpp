#include "scene/loop_segments.hpp"

#include <algorithm>
#include <map>

namespace sightline {
namespace {

using Place = std::array<Integer, 2>;

/// The coefficients without common divisor, the first that is not 0 positive: equal for equal lines.
std::array<Integer, 3> canonical(const PlaneLine& l) {
  Integer divisor = gcd(gcd(l.a, l.b), l.c);
  if (l.a != 0 ? l.a < 0 : l.b < 0) divisor = -divisor;
  return {l.a / divisor, l.b / divisor, l.c / divisor};
}

struct End {
  Place place;
  PointId point;
  int begins;  // by how much the net number of passages towards +(x, y) grows here
};

}  // namespace

LoopSegments loop_segments(const PlaneView& view, std::span<const PointId> loop) {
  std::map<std::array<Integer, 3>, std::vector<End>> groups;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PointId a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
    Place from = view.grid(a), to = view.grid(b);
    if (from == to) continue;
    std::vector<End>& ends = groups[canonical(view.line(from, to))];
    ends.push_back({std::move(from), a, 1});
    ends.push_back({std::move(to), b, -1});
  }
  LoopSegments result;
  for (auto& [key, ends] : groups) {
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.place < b.place; });
    const std::size_t before = result.segments.size();
    const auto line = static_cast<std::uint32_t>(result.lines.size());
    int net = 0;
    for (std::size_t i = 0; i < ends.size();) {
      const std::size_t here = i;
      int change = 0;
      for (; i < ends.size() && ends[i].place == ends[here].place; ++i) change += ends[i].begins;
      if (change == 0) continue;
      if (net != 0) result.segments.back().q = ends[here].point;
      net += change;
      if (net != 0) result.segments.push_back({line, ends[here].point, none, net});
    }
    if (result.segments.size() != before) result.lines.push_back(view.line(ends.front().place, ends.back().place));
  }
  return result;
}

}  // namespace sightline
