// Long integers by their first bits: a filter between doubles and all of them. For this folder's own use.
#pragma once

#include "exact/wide.hpp"

namespace sightline {

/// Where doubles do not tell, but their exact numbers are long: the leading 125 bits of the components, rounded down. A
/// third of what is asked on scenes turned by rounded numbers is decided by them.
inline constexpr std::uint32_t leading_bits = 125;

inline Wide3<2> leading(const std::uint64_t* words, std::uint32_t bits) {
  const std::uint32_t stride = words_for(bits);
  if (bits <= leading_bits) return load3<2>(words, stride);
  const std::uint32_t first = (bits - leading_bits) / 64, shift = (bits - leading_bits) % 64;
  Wide3<2> r;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint64_t* const w = words + k * stride;
    const auto word = [&](std::uint32_t i) { return i < stride ? w[i] : fixed_detail::sign_word(w[stride - 1]); };
    for (std::uint32_t i = 0; i < 2; ++i) {
      const std::uint64_t low = word(first + i) >> shift;
      r[k].word[i] = shift == 0 ? low : low | word(first + i + 1) << (64 - shift);
    }
  }
  return r;
}

/// The sign of a number of W words that is at least 2^bit away from zero; else uncertain.
template <int W>
inline Sign clear_sign(const Fixed<W>& a, int bit) {
  const std::uint64_t fill = fixed_detail::sign_word(a.word[W - 1]);
  std::uint64_t above = (a.word[bit / 64] ^ fill) >> (bit % 64);
  for (int i = bit / 64 + 1; i < W; ++i) above |= a.word[i] ^ fill;
  return above == 0 ? uncertain : fill != 0 ? -1 : 1;
}

}  // namespace sightline
