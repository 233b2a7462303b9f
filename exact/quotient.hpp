// The nearest double of a quotient of exact integers, quickly where that can be certified.
#pragma once

#include "exact/rounding.hpp"
#include "exact/wide.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace sightline {

/// The magnitude of an integer by its leading bits: value = lead * 2^(bits - 128), truncated; lead has its top bit set.
struct Leading {
  unsigned __int128 lead = 0;
  int bits = 0;
};
template <int W>
inline Leading leading(const Fixed<W>& magnitude) {
  int top = W - 1;
  while (top >= 0 && magnitude.word[top] == 0) --top;
  if (top < 0) return {};
  const auto word = [&](int i) { return i >= 0 ? magnitude.word[i] : std::uint64_t{0}; };
  const int zeros = std::countl_zero(word(top));
  unsigned __int128 lead = (static_cast<unsigned __int128>(word(top)) << 64) | word(top - 1);
  if (zeros > 0) lead = (lead << zeros) | (word(top - 2) >> (64 - zeros));
  return {lead, 64 * (top + 1) - zeros};
}

/// numerator / denominator to the nearest double, ties to even; not a number where the denominator is zero.
template <int W>
inline double nearest_quotient(const Wide<W>& numerator, const Wide<W>& denominator) {
  const Sign sn = sign_of<W>(numerator), sd = sign_of<W>(denominator);
  if (sd == 0) return std::numeric_limits<double>::quiet_NaN();
  if (sn == 0) return 0;
  if constexpr (W > 0) {
    const Leading n = leading<W>(sn < 0 ? -numerator : numerator), d = leading<W>(sd < 0 ? -denominator : denominator);
    // q = floor(floor(n.lead / 2) / top word of d): n.lead / 2 < 2^127 and the word >= 2^63, so 2^62 - 1 <= q < 2^64.
    // What was cut off n makes the true quotient at most 2 greater; what was cut off d, less than 2^-63 of it, makes it
    // at most q 2^-63 < 2 less. So the truth is q + (-2, 3), in units of 2^(n.bits - d.bits - 63).
    const auto q = static_cast<std::uint64_t>((n.lead >> 1) / static_cast<std::uint64_t>(d.lead >> 64));
    const int drop = 64 - std::countl_zero(q) - 53;
    const std::uint64_t below = q & ((std::uint64_t{1} << drop) - 1), half = std::uint64_t{1} << (drop - 1);
    const int exponent = n.bits - d.bits - 63;
    if ((below + 3 < half || below > half + 3) && std::abs(exponent) < 900) {
      const std::uint64_t kept = (q >> drop) + (below > half ? 1 : 0);
      const double r = std::ldexp(static_cast<double>(kept), exponent + drop);
      return sn * sd < 0 ? -r : r;
    }
    return nearest_double(load_integer(numerator.word, W), load_integer(denominator.word, W));
  } else {
    return nearest_double(numerator, denominator);
  }
}

}  // namespace sightline
