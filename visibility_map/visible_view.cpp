#include "visibility_map/visible_view.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {

ConvexView ViewClipper::whole() const {
  ConvexView view{{window_.side(table_, Window::bottom), window_.side(table_, Window::right),
                   window_.side(table_, Window::top), window_.side(table_, Window::left)}};
  if (window_.handedness() < 0) std::reverse(view.sides.begin(), view.sides.end());
  return view;
}

ConvexView ViewClipper::clip(const ConvexView& view, SightlineRef k) const {
  const std::size_t count = view.sides.size();
  std::vector<Sign> sides(count);
  bool inside = false, outside = false;
  for (std::size_t i = 0; i < count; ++i) {
    sides[i] = corner_side(view, i, k);
    inside = inside || sides[i] > 0;
    outside = outside || sides[i] < 0;
  }
  if (!inside) return {};
  if (!outside) return view;
  // Side i runs from corner i - 1 to corner i. Between a corner inside and the next one outside, k takes over.
  ConvexView result;
  for (std::size_t i = 0; i < count; ++i) {
    const bool from = sides[(i + count - 1) % count] > 0, to = sides[i] > 0;
    if (from || to) result.sides.push_back(view.sides[i]);
    if (from && !to) result.sides.push_back(k);
  }
  return result;
}

std::vector<ConvexView> ViewClipper::subtract(ConvexView view, const ConvexView& other) const {
  std::vector<ConvexView> parts;
  const ConvexView before = view;
  for (const SightlineRef k : other.sides) {
    if (ConvexView part = clip(view, -k); !part.empty()) parts.push_back(std::move(part));
    view = clip(view, k);
    if (view.empty()) return {before};  // they are disjoint: no need to cut
  }
  return parts;
}

std::vector<glm::dvec2> ViewClipper::corners(const ConvexView& view) const {
  std::vector<glm::dvec2> result;
  for (std::size_t i = 0; i < view.sides.size(); ++i) {
    result.push_back(window_.st(table_, view.sides[i].id, view.sides[(i + 1) % view.sides.size()].id));
  }
  return result;
}

double ViewClipper::area(const ConvexView& view) const {
  const std::vector<glm::dvec2> c = corners(view);
  double twice = 0;  // relative to the first corner, so that errors are small where the view is
  for (std::size_t i = 2; i < c.size(); ++i) {
    twice += (c[i - 1].x - c[0].x) * (c[i].y - c[0].y) - (c[i - 1].y - c[0].y) * (c[i].x - c[0].x);
  }
  return std::abs(twice) / 2;
}

}  // namespace sightline
