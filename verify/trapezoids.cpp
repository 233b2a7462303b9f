// A polygon that is not convex, by the even-odd rule: slabs between all its corners and crossings, trapezoids in them.
#include "verify/scene.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace sightline::verify {

namespace {

/// A side of the polygon in the plane's own coordinates, left end first.
struct Side {
  Rational u0, v0, u1, v1;
  Rational at(const Rational& u) const {
    if (v0 == v1) return v0;
    return v0 + (u - u0) * (v1 - v0) / (u1 - u0);
  }
};

/// Coordinates (u, v) of the plane: the two axes after the one along which the normal is longest.
class Frame {
 public:
  explicit Frame(const Surface& surface) : surface_(surface) {
    const Triple& n = surface.normal;
    k_ = abs(n.x) >= abs(n.y) && abs(n.x) >= abs(n.z) ? 0 : abs(n.y) >= abs(n.z) ? 1 : 2;
  }
  const Integer& u(const Triple& p) const { return axis(p, (k_ + 1) % 3); }
  const Integer& v(const Triple& p) const { return axis(p, (k_ + 2) % 3); }
  /// Do counter-clockwise chains in (u, v) run so about the normal?
  bool upright() const { return axis(surface_.normal, k_) > 0; }

  Corner lift(const Rational& u, const Rational& v) const {
    Integer w = u.get_den() * v.get_den();
    const Integer uw = u.get_num() * v.get_den(), vw = v.get_num() * u.get_den();
    const Triple& n = surface_.normal;
    const Integer& steep = axis(n, k_);
    Integer third = surface_.offset * w - axis(n, (k_ + 1) % 3) * uw - axis(n, (k_ + 2) % 3) * vw;
    Corner corner;
    axis(corner.p, k_) = third;
    axis(corner.p, (k_ + 1) % 3) = uw * steep;
    axis(corner.p, (k_ + 2) % 3) = vw * steep;
    corner.w = w * steep;
    if (corner.w < 0) {
      corner.w = -corner.w;
      negate(corner.p);
    }
    return corner;
  }

 private:
  static const Integer& axis(const Triple& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }
  static Integer& axis(Triple& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }
  const Surface& surface_;
  int k_;
};

/// Where the order of two sides changes, if it does.
void add_crossing(const Side& a, const Side& b, std::vector<Rational>& breaks) {
  const Rational low = std::max(a.u0, b.u0), high = std::min(a.u1, b.u1);
  if (low >= high) return;
  const Rational before = a.at(low) - b.at(low), after = a.at(high) - b.at(high);
  if (sgn(before) * sgn(after) < 0) breaks.push_back(low + (high - low) * before / (before - after));
}

}  // namespace

void cut_into_trapezoids(Surface& surface, std::span<const Corner> chain) {
  const Frame frame(surface);
  std::vector<Rational> breaks;
  std::vector<Side> sides(2);  // the first two: bottom and top of the box
  Rational low = frame.v(chain[0].p), high = low;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Triple &p = chain[i].p, &q = chain[(i + 1) % chain.size()].p;
    breaks.emplace_back(frame.u(p));
    low = std::min<Rational>(low, frame.v(p));
    high = std::max<Rational>(high, frame.v(p));
    Side side{frame.u(p), frame.v(p), frame.u(q), frame.v(q)};
    if (side.u0 == side.u1) continue;
    if (side.u0 > side.u1) {
      std::swap(side.u0, side.u1);
      std::swap(side.v0, side.v1);
    }
    sides.push_back(std::move(side));
  }
  for (std::size_t i = 2; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) add_crossing(sides[i], sides[k], breaks);
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  sides[0] = {breaks.front(), low, breaks.back(), low};
  sides[1] = {breaks.front(), high, breaks.back(), high};

  const auto piece = [&](const Rational& left, const Rational& right, const Side& lower, const Side& upper) {
    std::vector<std::pair<Rational, Rational>> corners{{left, lower.at(left)}, {right, lower.at(right)}};
    if (upper.at(right) != corners[1].second) corners.emplace_back(right, upper.at(right));
    if (upper.at(left) != corners[0].second) corners.emplace_back(left, upper.at(left));
    if (!frame.upright()) std::reverse(corners.begin(), corners.end());
    Piece out;
    for (const auto& [u, v] : corners) out.push_back(frame.lift(u, v));
    return out;
  };

  // Trapezoids that go on into the next slab, by (is it inside, lower side, upper side): where they began.
  using Key = std::array<std::size_t, 3>;
  std::map<Key, Rational> open;
  const auto close = [&](const Key& key, const Rational& left, const Rational& right) {
    (key[0] ? surface.inside : surface.outside).push_back(piece(left, right, sides[key[1]], sides[key[2]]));
  };
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
    const Rational middle = (breaks[b] + breaks[b + 1]) / 2;
    std::vector<std::pair<Rational, std::size_t>> stack;
    for (std::size_t i = 2; i < sides.size(); ++i) {
      if (sides[i].u0 < middle && middle < sides[i].u1) stack.emplace_back(sides[i].at(middle), i);
    }
    std::sort(stack.begin(), stack.end());
    std::vector<std::size_t> order{0};
    for (std::size_t i = 0; i < stack.size(); ++i) {
      if (i + 1 < stack.size() && stack[i].first == stack[i + 1].first) {
        ++i;  // two that lie on each other leave the parity as it is
      } else {
        order.push_back(stack[i].second);
      }
    }
    order.push_back(1);
    std::map<Key, Rational> next;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      const Key key{i % 2, order[i], order[i + 1]};
      if (sides[key[1]].at(middle) == sides[key[2]].at(middle)) continue;
      const auto going = open.find(key);
      next.emplace(key, going == open.end() ? breaks[b] : going->second);
      if (going != open.end()) open.erase(going);
    }
    for (const auto& [key, left] : open) close(key, left, breaks[b]);
    open = std::move(next);
  }
  for (const auto& [key, left] : open) close(key, left, breaks.back());
  surface.hull = piece(breaks.front(), breaks.back(), sides[0], sides[1]);
}

}  // namespace sightline::verify
