// Sums of two doubles: twice the precision without longer numbers. Internal to visibility_map/.
//
// With v = 2^-106: each operation is within 8 v of the exact result, relative to the sizes of what goes in (for
// products and quotients: to the result). Plain IEEE arithmetic, no contraction.
#pragma once

namespace sightline::stitching {

/// high is the sum, rounded to a double; low what that leaves.
struct Twofold {
  double high = 0, low = 0;
};

/// Exact (Knuth).
inline Twofold two_sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
/// Exact if |a| >= |b| (Dekker).
inline Twofold fast_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}
/// Exact (Dekker): both factors are split into halves of 26 bits.
inline Twofold two_product(double a, double b) {
  const double p = a * b, ca = 134217729.0 * a, cb = 134217729.0 * b;
  const double ah = ca - (ca - a), al = a - ah, bh = cb - (cb - b), bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}
inline Twofold operator+(const Twofold& a, const Twofold& b) {
  const Twofold s = two_sum(a.high, b.high);
  return fast_sum(s.high, s.low + (a.low + b.low));
}
inline Twofold operator-(const Twofold& a) { return {-a.high, -a.low}; }
inline Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }
inline Twofold operator*(const Twofold& a, const Twofold& b) {
  const Twofold p = two_product(a.high, b.high);
  return fast_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
inline Twofold operator/(const Twofold& a, const Twofold& b) {
  const double first = a.high / b.high;
  const Twofold rest = a - b * Twofold{first, 0};
  return fast_sum(first, rest.high / b.high);
}

}  // namespace sightline::stitching
