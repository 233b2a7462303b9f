// Greatest common divisors of short integers, by Stein's binary method.
#pragma once

#include <bit>
#include <cstdint>

namespace sightline {

using UInt128 = unsigned __int128;

inline int trailing_zeros(std::uint64_t x) { return std::countr_zero(x); }
inline int trailing_zeros(UInt128 x) {
  const auto low = static_cast<std::uint64_t>(x);
  return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(x >> 64));
}

namespace gcd_detail {
// Both odd. Written without branches on the operands, which no predictor could foresee.
template <class UInt>
inline UInt of_odd(UInt a, UInt b) {
  while (a != b) {
    if constexpr (sizeof(UInt) > 8)
      if (((a | b) >> 64) == 0) return of_odd(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b));
    const UInt difference = a > b ? a - b : b - a;
    a = a > b ? b : a;
    b = difference >> trailing_zeros(difference);
  }
  return a;
}
}  // namespace gcd_detail

/// gcd(a, b) of unsigned integers of 64 or 128 bits; gcd(a, 0) = a.
template <class UInt>
inline UInt gcd_of(UInt a, UInt b) {
  if (a == 0 || b == 0) return a | b;
  return gcd_detail::of_odd(static_cast<UInt>(a >> trailing_zeros(a)), static_cast<UInt>(b >> trailing_zeros(b)))
         << trailing_zeros(static_cast<UInt>(a | b));
}

}  // namespace sightline
