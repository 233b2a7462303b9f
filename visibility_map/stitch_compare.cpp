// The order of the places where vertices are seen, exactly.
#include "exact/rounding.hpp"
#include "visibility_map/seen_place.hpp"

#include <cmath>
#include <limits>

namespace sightline::stitching {

std::array<Integer, 3> exact_ray(const State& s, CornerId c) {
  const Corner& corner = s.corners[c];
  const std::array<Integer, 3> a = s.table->normal(corner.low), b = s.table->normal(corner.high);
  std::array<Integer, 3> r{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const Integer factor = gcd(gcd(r[0], r[1]), r[2]);
  for (Integer& k : r) k = corner.sign * k / factor;
  return r;
}

namespace {

using Integer3 = std::array<Integer, 3>;
Integer det(const Integer3& a, const Integer3& b, const Integer3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Forward, right and up, times one power of two.
void find_exact_frame(State& s) {
  const glm::dvec3* const given[3] = {&s.camera->forward, &s.camera->right, &s.camera->up};
  int least = std::numeric_limits<int>::max();
  for (std::size_t k = 0; k < 9; ++k) {
    const double x = (*given[k / 3])[static_cast<int>(k % 3)];
    if (x != 0) least = std::min(least, dyadic(x).exponent);
  }
  for (std::size_t k = 0; k < 9; ++k) {
    const Dyadic d = dyadic((*given[k / 3])[static_cast<int>(k % 3)]);
    s.exact_frame[k / 3][k % 3] = d.mantissa == 0 ? Integer(0) : shifted(Integer(d.mantissa), d.exponent - least);
  }
  s.has_exact_frame = true;
}

/// s - 1/2, t - 1/2 as numerators over a common denominator, which comes last.
Integer3 exact_st(State& s, CornerId c) {
  if (!s.has_exact_frame) find_exact_frame(s);
  const Corner& corner = s.corners[c];
  const Integer3 a = s.table->normal(corner.low), b = s.table->normal(corner.high);
  const Integer3 x{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const auto& [forward, right, up] = s.exact_frame;
  return {det(x, up, forward), det(x, forward, right), det(x, right, up)};
}

/// The sign of p - q, each within its error; uncertain where that leaves a choice.
Sign apart(const Twofold& p, double p_error, const Twofold& q, double q_error) {
  // The difference of two twofold numbers is rounded three times, by u of what is left and u^2 of the numbers.
  const Twofold upper = two_sum(p.high, -q.high);
  const double difference = upper.high + (upper.low + (p.low - q.low));
  const double bound = 2 * (p_error + q_error) + 0x1p-100 * (std::abs(p.high) + std::abs(q.high));
  return difference > bound ? 1 : difference < -bound ? -1 : uncertain;
}

const WindowLine& window_line(const State& s, SightlineId line) { return s.window_lines[s.window_line_of[line]]; }

/// As compare_places, by places twice as long as doubles; uncertain where they agree. After place_vertices, which has
/// left the lines of all vertices behind.
Sign compare_seen(const State& s, const Corner& a, const Corner& b) {
  const auto place = [&](const Corner& c) {
    return seen_place<false>(s, window_line(s, c.low), window_line(s, c.high));
  };
  const SeenPlace p = place(a), q = place(b);
  return apart(p.s, p.s_error, q.s, q.s_error);
}

/// The sign of the product of a line's normal with a vector of the frame: right (1) or up (2).
Sign frame_side(State& s, SightlineId line, std::size_t k) {
  const WindowLine& l = window_line(s, line);
  const double value = k == 1 ? l.right.high : l.up.high;
  if (std::abs(value) > 0x1p-98) return value > 0 ? 1 : -1;  // within 2^-99, see dot
  if (!s.has_exact_frame) find_exact_frame(s);
  const Integer3 n = s.table->normal(line);
  const Integer3& f = s.exact_frame[k];
  return sgn(Integer(n[0] * f[0] + n[1] * f[1] + n[2] * f[2]));
}

/// As compare_places, by the order along a line that both corners have in their names; uncertain if there is none. A
/// line runs with its front, where l_r ds + l_u dt > 0, on the left as the eye sees it: in the direction (l_u, -l_r),
/// or against it where the window is mirrored.
Sign compare_along(State& s, const Corner& a, const Corner& b) {
  for (const SightlineId line : {a.low, a.high}) {
    if (line != b.low && line != b.high) continue;
    const Sign later = s.table->order({line, 1}, b.across(line), a.across(line));  // 1: b comes after a
    const Sign up = frame_side(s, line, 2);
    return s.handedness * later * (up != 0 ? -up : frame_side(s, line, 1));
  }
  return uncertain;
}

}  // namespace

Sign compare_places(State& s, CornerId a, CornerId b) {
  if (!s.camera) {
    const std::array<Integer, 3> p = exact_ray(s, a), q = exact_ray(s, b);
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] != q[k]) return p[k] < q[k] ? -1 : 1;
    }
    return 0;
  }
  if (const Sign seen = compare_seen(s, s.corners[a], s.corners[b]); seen != uncertain) return seen;
  if (const Sign along = compare_along(s, s.corners[a], s.corners[b]); along != uncertain) return along;
  const Integer3 p = exact_st(s, a), q = exact_st(s, b);
  const Sign denominators = sgn(p[2]) * sgn(q[2]);
  for (std::size_t k = 0; k < 2; ++k) {
    const Integer difference = p[k] * q[2] - q[k] * p[2];
    if (difference != 0) return sgn(difference) * denominators;
  }
  return 0;
}

}  // namespace sightline::stitching
