#include "verify/window.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::verify {

Line make_line(Triple n) {
  Line line;
  long shift = 0;
  for (const Integer* x : {&n.x, &n.y, &n.z}) {
    if (*x != 0) shift = std::max(shift, static_cast<long>(mpz_sizeinbase(x->get_mpz_t(), 2)));
  }
  line.a = rough(n.x, -shift);
  line.b = rough(n.y, -shift);
  line.c = rough(n.z, -shift);
  line.n = std::move(n);
  return line;
}

Point make_point(Triple r) {
  if (r.z < 0) negate(r);
  Point p;
  p.s = rough_ratio(r.x, r.z);
  p.t = rough_ratio(r.y, r.z);
  p.r = std::move(r);
  return p;
}

Point crossing(const Line& a, const Line& b) { return make_point(cross(a.n, b.n)); }

int side(const Line& line, const Point& p) {
  const double f = rough_side(line, p);
  if (f > line_error) return 1;
  if (f < -line_error) return -1;
  return sign_dot(line.n, p.r);
}

namespace {

int compare_ratio(double a, double b, const Integer& top_a, const Integer& bottom_a, const Integer& top_b,
                  const Integer& bottom_b) {
  if (a - b > 0x1p-48) return 1;  // each is off by less than 2^-50
  if (a - b < -0x1p-48) return -1;
  return sign_difference(top_a, bottom_b, top_b, bottom_a);
}

}  // namespace

int compare_s(const Point& a, const Point& b) { return compare_ratio(a.s, b.s, a.r.x, a.r.z, b.r.x, b.r.z); }
int compare_t(const Point& a, const Point& b) { return compare_ratio(a.t, b.t, a.r.y, a.r.z, b.r.y, b.r.z); }
int compare(const Point& a, const Point& b) {
  const int order = compare_s(a, b);
  return order != 0 ? order : compare_t(a, b);
}

bool clip(const Convex& convex, const Line* line, Convex& out) {
  const std::size_t n = convex.corners.size();
  std::vector<int> sign(n);
  bool any_positive = false, any_negative = false;
  for (std::size_t i = 0; i < n; ++i) {
    sign[i] = side(*line, convex.corners[i]);
    any_positive = any_positive || sign[i] > 0;
    any_negative = any_negative || sign[i] < 0;
  }
  if (!any_positive) return false;
  if (!any_negative) {
    out = convex;
    return true;
  }
  Convex result;
  const auto add = [&](Point corner, const Line* outgoing) {
    result.corners.push_back(std::move(corner));
    result.sides.push_back(outgoing);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const int here = sign[i], next = sign[(i + 1) % n];
    if (here > 0) {
      add(convex.corners[i], convex.sides[i]);
      if (next < 0) add(crossing(*convex.sides[i], *line), line);
    } else if (here == 0) {
      // Something is positive and something negative, so the line passes through the interior at this corner.
      add(convex.corners[i], next > 0 ? convex.sides[i] : line);
    } else if (next > 0) {
      add(crossing(*convex.sides[i], *line), convex.sides[i]);
    }
  }
  out = std::move(result);
  return true;
}

Point middle(const Convex& convex) {
  Triple sum = convex.corners[0].r;
  for (std::size_t i = 1; i < convex.corners.size(); ++i) sum = sum + convex.corners[i].r;
  return make_point(std::move(sum));
}

bool meets_segment(std::span<const Line* const> lines, const Point& u, const Point& v) {
  struct Bound {
    const Line* line;
    double at_u, at_v;
  };
  // Where a line is positive at one end only, it bounds the part of the segment on its positive side from u's end
  // (`lower`) or from v's end (`upper`).
  thread_local std::vector<Bound> lower, upper;
  lower.clear();
  upper.clear();
  for (const Line* line : lines) {
    const double fu = rough_side(*line, u), fv = rough_side(*line, v);
    const int su = fu > line_error ? 1 : fu < -line_error ? -1 : sign_dot(line->n, u.r);
    if (su < 0 && fv < -line_error) return false;
    const int sv = fv > line_error ? 1 : fv < -line_error ? -1 : sign_dot(line->n, v.r);
    if (su <= 0 && sv <= 0) return false;
    if (su < 0) lower.push_back({line, fu, fv});
    if (sv < 0) upper.push_back({line, fu, fv});
  }
  // The line at u + x (v - u) is positive for x > |lu| / (|lu| + lv) (lower), x < hu / (hu + |hv|) (upper); the
  // region is met unless for some pair |lu| |hv| >= hu lv.
  for (const Bound& l : lower) {
    for (const Bound& h : upper) {
      const double difference = h.at_u * l.at_v - l.at_u * h.at_v;
      // Values up to 3 are off by 2^-48 each: the products by 2^-48 times the sum of the four and less than 2^-90
      // besides; the three roundings are below 2^-50 times that sum.
      const double error =
          0x1p-47 * (std::abs(h.at_u) + std::abs(l.at_v) + std::abs(l.at_u) + std::abs(h.at_v)) + 0x1p-90;
      if (difference > error) continue;
      if (difference < -error) return false;
      if (sign_difference(dot(h.line->n, u.r), dot(l.line->n, v.r), dot(l.line->n, u.r), dot(h.line->n, v.r)) <= 0) {
        return false;
      }
    }
  }
  return true;
}

int compare_depth(const Depth& a, const Depth& b, const Point& p) {
  // A value is off by 3 * 2^-50 (coefficients) + 2 * 2^-50 (s, t) + 2^-50 (roundings) times the scale at most; the
  // last term stands for coefficients below the range of doubles.
  const double f = (a.a * p.s + a.b * p.t + a.c) - (b.a * p.s + b.b * p.t + b.c);
  const double error = (a.scale + b.scale) * 0x1p-47 + 0x1p-1000;
  if (f > error) return 1;
  if (f < -error) return -1;
  return sign_difference(b.height, dot(a.form, p.r), a.height, dot(b.form, p.r));
}

Triple depth_line(const Depth& a, const Depth& b) { return b.height * a.form - a.height * b.form; }

bool same_plane(const Depth& a, const Depth& b) {
  return sign_difference(b.height, a.form.x, a.height, b.form.x) == 0 &&
         sign_difference(b.height, a.form.y, a.height, b.form.y) == 0 &&
         sign_difference(b.height, a.form.z, a.height, b.form.z) == 0;
}

}  // namespace sightline::verify
