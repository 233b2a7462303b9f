#include "scene/triangulate.hpp"

#include "exact/predicates.hpp"
#include "exact/wide.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace sightline {
namespace {

struct View {
  int axis;
  Sign turn;  // of a loop that does not cross itself: +1 if it runs counter-clockwise seen along the axis
};

/// In doubles; axis -1 where they cannot tell.
View newell_filter(const PointTable& points, std::span<const PointId> loop) {
  // With u = 2^-53 and coordinates up to 1/2, each within u/2: differences are up to 1 and within 3u/2, rounding
  // included; products within 3u + u/2, and the difference of two, up to 2, within 7u + u: 8u a step. A sum of n such
  // steps stays below 2n and rounds by at most 2n u at each: n (8 + 2n) u in all, and that twice for a difference.
  const auto n = static_cast<double>(loop.size());
  const double bound = n * (9 + 2 * n) * 0x1p-53;
  const glm::dvec3& origin = points.approx(loop[0]);
  glm::dvec3 sum{0}, last{0};
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const glm::dvec3 next = points.approx(loop[i]) - origin;
    sum += glm::cross(last, next);
    last = next;
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(sum[k]) > std::abs(sum[axis])) axis = k;
  }
  const double largest = std::abs(sum[axis]);
  const double second = std::max(std::abs(sum[(axis + 1) % 3]), std::abs(sum[(axis + 2) % 3]));
  if (!(largest - second > 2 * bound)) return {-1, 0};
  return {axis, sum[axis] > 0 ? 1 : -1};
}

/// The axis of the largest component of the Newell normal, the sum of (p_i - p_0) x (p_{i+1} - p_0), ties to the
/// lowest; and the sign of that component.
View newell_view(const PointTable& points, std::span<const PointId> loop) {
  if (const View found = newell_filter(points, loop); found.axis >= 0) {
    ++tally().filter;
    return found;
  }
  // Differences have B + 1 bits, their minors 2B + 3, a sum of fewer than 2^32 of them 2B + 35, one more of two such.
  View view{0, 0};
  decide(2 * points.bits() + 36, [&](auto width) -> Sign {
    constexpr int W = width(), N = (W + 1) / 2;  // 64 N is at least B + 18
    const std::uint32_t stride = points.stride();
    const Wide3<N> origin = load3<N>(points.words(loop[0]), stride);
    Wide3<W> sum{};
    Wide3<N> last{};
    for (std::size_t i = 1; i < loop.size(); ++i) {
      Wide3<N> next = load3<N>(points.words(loop[i]), stride);
      for (std::size_t k = 0; k < 3; ++k) next[k] = Wide<N>(next[k] - origin[k]);
      const Wide3<W> turned = cross<W, N>(last, next);
      for (std::size_t k = 0; k < 3; ++k) sum[k] = Wide<W>(sum[k] + turned[k]);
      last = std::move(next);
    }
    const auto size = [&sum](std::size_t k) { return sign_of<W>(sum[k]) < 0 ? Wide<W>(-sum[k]) : sum[k]; };
    for (std::size_t k = 1; k < 3; ++k) {
      if (sign_of<W>(Wide<W>(size(k) - size(static_cast<std::size_t>(view.axis)))) > 0) view.axis = static_cast<int>(k);
    }
    return view.turn = sign_of<W>(sum[static_cast<std::size_t>(view.axis)]);
  });
  return view;
}

/// Cuts ears off a loop in a view.
class EarCutter {
 public:
  EarCutter(const PointTable& points, std::span<const PointId> loop, const View& view)
      : points_(points), axis_(view.axis), turn_(view.turn), left_(loop.begin(), loop.end()) {}

  /// Nothing if at some step no vertex is an ear.
  std::optional<std::vector<Triangle>> cut() {
    std::vector<Triangle> triangles;
    std::size_t at = 1, tried = 0;
    while (left_.size() > 3) {
      const std::size_t n = left_.size();
      at %= n;
      const Triangle t{left_[(at + n - 1) % n], left_[at], left_[(at + 1) % n]};
      if (!is_ear(t)) {
        if (++tried == n) return std::nullopt;
        ++at;
        continue;
      }
      triangles.push_back(t);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    if (side(left_[0], left_[1], left_[2]) < 0) return std::nullopt;
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  Sign side(PointId a, PointId b, PointId c) const { return turn_ * orientation(points_, a, b, c, axis_); }
  /// The same place in the view.
  bool same(PointId a, PointId b) const {
    return compare(points_, a, b, (axis_ + 1) % 3) == 0 && compare(points_, a, b, (axis_ + 2) % 3) == 0;
  }
  /// A corner that does not turn away, and no other vertex in the triangle, its border included: but one in the same
  /// place as one of its corners (the two banks of a keyhole) does not hinder.
  bool is_ear(const Triangle& t) const {
    const Sign turn = side(t[0], t[1], t[2]);
    if (turn < 0) return false;
    if (turn == 0) return true;  // it has no area in the view
    for (PointId p : left_) {
      if (p == t[0] || p == t[1] || p == t[2]) continue;
      if (side(t[0], t[1], p) < 0 || side(t[1], t[2], p) < 0 || side(t[2], t[0], p) < 0) continue;
      if (!same(p, t[0]) && !same(p, t[1]) && !same(p, t[2])) return false;
    }
    return true;
  }

  const PointTable& points_;
  int axis_;
  Sign turn_;
  std::vector<PointId> left_;
};

}  // namespace

std::vector<Triangle> triangulate(const PointTable& points, std::span<const PointId> loop) {
  const View view = newell_view(points, loop);
  std::vector<Triangle> fan;
  bool left = false, right = false;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    fan.push_back({loop[0], loop[i], loop[i + 1]});
    const Sign turn = orientation(points, loop[0], loop[i], loop[i + 1], view.axis);
    left |= turn > 0;
    right |= turn < 0;
  }
  if (!(left && right) || view.turn == 0) return fan;
  auto ears = EarCutter(points, loop, view).cut();
  return ears ? *std::move(ears) : fan;
}

}  // namespace sightline
