// How much of the window each polygon takes up: what is left of stitching where nobody asks what lies beside what.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::stitching {

/// Corners are within 2^-54 of where they are, and lie in the window, as do the sides between them: a side's cross
/// product is off by at most 2^-52, half of which counts; the sums add 2^-100 of what they hold. A mirrored camera sees
/// all sides run clockwise.
void sum_areas(State& s, std::vector<PolygonArea>& areas) {
  take_corners(s);
  s.vertices.clear();
  for (CornerId c = 0; c < s.corners.size(); ++c) s.vertices.push_back({c, c, {}, {}});
  place_vertices(s);
  const Fragments& f = *s.fragments;
  s.polygon_sums.clear();
  for (const Fragment& fragment : f.fragments) {
    Twofold twice;
    for (std::uint32_t k = fragment.first_side; k < fragment.first_side + fragment.side_count; ++k) {
      const glm::dvec2 &a = s.vertices[f.sides[k].from].st, &b = s.vertices[f.sides[k].to].st;
      twice = twice + (two_product(a.x, b.y) - two_product(a.y, b.x));
    }
    const bool hit = fragment.seen_count != 0;
    s.polygon_sums.emplace_back(hit ? s.scene->surfaces()[f.seen[fragment.first_seen]].polygon : none, twice);
  }
  std::sort(s.polygon_sums.begin(), s.polygon_sums.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  areas.clear();
  for (std::size_t k = 0; k < s.polygon_sums.size();) {
    const PolygonId polygon = s.polygon_sums[k].first;
    Twofold twice;
    for (; k < s.polygon_sums.size() && s.polygon_sums[k].first == polygon; ++k)
      twice = twice + s.polygon_sums[k].second;
    areas.push_back({polygon, std::max(0.0, s.handedness * twice.high / 2)});
  }
}

}  // namespace sightline::stitching
