// Pixels over a drawing.
#include "compare/overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline::comparison {
namespace {

/// What a piece of boundary does to one row: it rises by `rise` within pixel x, and `area` of that pixel lies left of
/// it. All that lies left of pixel x is left of it by `rise` too.
struct Step {
  std::uint32_t row, x;
  double area, rise;
};

/// The steps of an edge from `from` to `to`, in pixels, `from` below `to`; `sign` -1 for an edge that runs downwards.
void add_steps(glm::dvec2 from, glm::dvec2 to, double sign, double size, std::vector<Step>& steps) {
  const double slope = (to.x - from.x) / (to.y - from.y);
  const auto s_at = [&](double t) { return t >= to.y ? to.x : from.x + (t - from.y) * slope; };
  const auto cell = [&](double v) { return std::clamp(std::floor(v), 0.0, size - 1); };
  for (double row = cell(from.y); row < to.y && row < size; ++row) {
    const double t0 = std::max(from.y, row), t1 = std::min(to.y, row + 1);
    const double s0 = s_at(t0), s1 = s_at(t1), low = std::min(s0, s1), high = std::max(s0, s1);
    double left = low;
    for (double x = cell(low); x <= cell(high); ++x) {
      const double right = x == cell(high) ? high : x + 1;
      const double rise = sign * (high > low ? (t1 - t0) * ((right - left) / (high - low)) : t1 - t0);
      steps.push_back(
          {static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(x), rise * ((left + right) / 2 - x), rise});
      left = right;
    }
  }
}

}  // namespace

void differences(const Drawing& drawing, const Pixels& pixels, const Agrees& agrees, const Part& part) {
  const double size = pixels.size, pixel = 1 / (size * size);
  // Edges by face, the face on their left when taken by the sign.
  struct Side {
    std::uint32_t face, edge;
    double sign;
  };
  std::vector<Side> sides;
  for (std::uint32_t k = 0; k < drawing.edges.size(); ++k) {
    if (drawing.edges[k].left != none) sides.push_back({drawing.edges[k].left, k, 1});
    if (drawing.edges[k].right != none) sides.push_back({drawing.edges[k].right, k, -1});
  }
  std::ranges::stable_sort(sides, {}, &Side::face);

  std::vector<Step> steps;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    const std::uint32_t face = sides[first].face;
    steps.clear();
    for (; last < sides.size() && sides[last].face == face; ++last) {
      const Drawing::Edge& e = drawing.edges[sides[last].edge];
      const glm::dvec2 from = drawing.corners[e.from] * size, to = drawing.corners[e.to] * size;
      if (from.y < to.y) add_steps(from, to, sides[last].sign, size, steps);
      if (to.y < from.y) add_steps(to, from, -sides[last].sign, size, steps);
    }
    std::ranges::sort(steps, [](const Step& a, const Step& b) { return a.row != b.row ? a.row < b.row : a.x < b.x; });
    // Runs of pixels of one row that show the same, `area` of the face in each.
    PolygonId shown = none;
    bool right = true;
    double sum = 0;
    const auto flush = [&] {
      if (!right && sum > 0) part(face, shown, sum * pixel);
      sum = 0;
    };
    const auto add = [&](PolygonId item, double area) {
      if (item != shown || sum == 0) {
        flush();
        shown = item;
        right = agrees(face, item);
      }
      sum += area;
    };
    double beside = 0;  // part of the row's height between what has been passed and the next step
    for (std::size_t k = 0; k < steps.size();) {
      const std::uint32_t row = steps[k].row, x = steps[k].x;
      const PolygonId* const items = pixels.items.data() + std::size_t{row} * pixels.size;
      double within = 0, rise = 0;
      for (; k < steps.size() && steps[k].row == row && steps[k].x == x; ++k) {
        within += steps[k].area;
        rise += steps[k].rise;
      }
      beside -= rise;
      // What lies left of the pixel's own boundary, and what lies left of all further ones.
      add(items[x], std::max(0.0, within + beside));
      constexpr double rounding = 1e-12;  // of the sum of a row's rises, which is 0
      if (k == steps.size() || steps[k].row != row) {
        beside = 0;
      } else if (beside > rounding) {
        for (std::uint32_t i = x + 1; i < steps[k].x; ++i) add(items[i], beside);
      }
    }
    flush();
  }
}

}  // namespace sightline::comparison
