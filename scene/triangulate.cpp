#include "scene/triangulate.hpp"

#include "exact/predicates.hpp"

#include <optional>

namespace sightline {
namespace {

struct View {
  int axis;
  Sign turn;  // of a loop that does not cross itself: +1 if it runs counter-clockwise seen along the axis
};

/// The axis of the largest component of the Newell normal, the sum of (p_i - p_0) x (p_{i+1} - p_0), ties to the
/// lowest; and the sign of that component.
View newell_view(const PointTable& points, std::span<const PointId> loop) {
  std::array<Integer, 3> sum, last{};
  const std::array<Integer, 3> origin = points.point(loop[0]);
  for (std::size_t i = 1; i < loop.size(); ++i) {
    std::array<Integer, 3> next = points.point(loop[i]);
    for (std::size_t k = 0; k < 3; ++k) next[k] -= origin[k];
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += last[(k + 1) % 3] * next[(k + 2) % 3] - last[(k + 2) % 3] * next[(k + 1) % 3];
    }
    last = std::move(next);
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(sum[k]) > abs(sum[axis])) axis = k;
  }
  return {static_cast<int>(axis), sgn(sum[axis])};
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
