// Sums of two doubles: twice the precision without longer numbers. Internal to visibility_map/.
//
// With v = 2^-106: a sum is within 8 v of the exact result, relative to the sizes of what goes in. Plain IEEE
// arithmetic, no contraction.
#pragma once

namespace sightline::stitching {

/// high is the sum, rounded to a double; low what that leaves.
struct Twofold {
  double high = 0, low = 0;
};

/// Exact (Knuth).
[[gnu::always_inline]] inline Twofold two_sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
/// Exact if |a| >= |b| (Dekker).
[[gnu::always_inline]] inline Twofold fast_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}
/// Exact (Dekker): both factors are split into halves of 26 bits. Or, where the processor has it, by a fused
/// multiply-add: the very same two numbers.
template <bool fused = false>
[[gnu::always_inline]] inline Twofold two_product(double a, double b) {
  const double p = a * b;
  if constexpr (fused) {
    return {p, __builtin_fma(a, b, -p)};
  } else {
    const double ca = 134217729.0 * a, cb = 134217729.0 * b;
    const double ah = ca - (ca - a), al = a - ah, bh = cb - (cb - b), bl = b - bh;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
  }
}
inline Twofold operator+(const Twofold& a, const Twofold& b) {
  const Twofold s = two_sum(a.high, b.high);
  return fast_sum(s.high, s.low + (a.low + b.low));
}
inline Twofold operator-(const Twofold& a) { return {-a.high, -a.low}; }
inline Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }

}  // namespace sightline::stitching
