// Long integers by their first bits: a filter between doubles and all of them. For this folder's own use.
#pragma once

#include "exact/wide.hpp"

namespace sightline {

/// Where doubles do not tell, but their exact numbers are long: first the leading 62 bits of the components, then the
/// leading 125, rounded down. On a building turned by rounded numbers what is asked is mostly about hairs, 2^-48 to
/// 2^-60 of the whole: the first tell three fifths of it, the second nearly all the rest.
inline constexpr std::uint32_t leading_bits = 125, word_bits = 62;

/// The leading bits, 62 in one word or 125 in two, of three components of `bits` bits at most.
template <int N>
inline Wide3<N> leading(const std::uint64_t* words, std::uint32_t bits) {
  constexpr std::uint32_t kept = N == 1 ? word_bits : leading_bits;
  const std::uint32_t stride = words_for(bits);
  if (bits <= kept) {
    Wide3<N> r = load3<N>(words, stride);
    for (Wide<N>& c : r) c = shift_left(c, static_cast<int>(kept - bits));
    return r;
  }
  const std::uint32_t first = (bits - kept) / 64, shift = (bits - kept) % 64;
  Wide3<N> r;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint64_t* const w = words + k * stride + first;
    for (std::uint32_t i = 0; i < N; ++i) {
      // Where there is no next word the sign fills up; it is there below the last one kept. Two shifts, since by 64
      // there is none.
      const std::uint64_t next = i + 1 < N || first + N < stride ? w[i + 1] : fixed_detail::sign_word(w[i]);
      r[k].word[i] = (w[i] >> shift) | (next << 1 << (63 - shift));
    }
  }
  return r;
}

/// The leading 62 bits, as numbers.
inline std::array<std::int64_t, 3> leading_word(const std::uint64_t* words, std::uint32_t bits) {
  const Wide3<1> r = leading<1>(words, bits);
  return {static_cast<std::int64_t>(r[0].word[0]), static_cast<std::int64_t>(r[1].word[0]),
          static_cast<std::int64_t>(r[2].word[0])};
}

/// The sign of det(a, b, c) by leading words, if they tell.
inline Sign leading_order(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b,
                          const std::array<std::int64_t, 3>& c) {
  // With w = 2^62 above all components, each less than 1 too small: a minor has two products below w^2, each within
  // 2w + 1, so it is below 2w^2 and within 4w + 2; over w, rounded down, below 2w and within 6. Times c: below 2w^2,
  // and within 6w + 2w + 6; the three together below 6w^2 < 2^127 and within 24w + 18 < 32w.
  const auto minor = [&](std::size_t i, std::size_t j) {
    return static_cast<std::int64_t>((static_cast<__int128>(a[i]) * b[j] - static_cast<__int128>(a[j]) * b[i]) >>
                                     word_bits);
  };
  const __int128 det = static_cast<__int128>(minor(1, 2)) * c[0] + static_cast<__int128>(minor(2, 0)) * c[1] +
                       static_cast<__int128>(minor(0, 1)) * c[2];
  constexpr __int128 bound = static_cast<__int128>(1) << (word_bits + 5);
  return det > bound ? 1 : det < -bound ? -1 : uncertain;
}

/// The sign of a.b by leading words, if they tell.
inline Sign leading_dot(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b) {
  // As above: three products below w^2, each within 2w + 1; together within 6w + 3 < 8w.
  const __int128 dot =
      static_cast<__int128>(a[0]) * b[0] + static_cast<__int128>(a[1]) * b[1] + static_cast<__int128>(a[2]) * b[2];
  constexpr __int128 bound = static_cast<__int128>(1) << (word_bits + 3);
  return dot > bound ? 1 : dot < -bound ? -1 : uncertain;
}

/// Do leading words tell that a and b are not parallel?
inline bool leading_apart(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b) {
  // As above: minors within 4w + 2 < 8w.
  constexpr __int128 bound = static_cast<__int128>(1) << (word_bits + 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i == 2 ? 0 : i + 1;
    const __int128 minor = static_cast<__int128>(a[i]) * b[j] - static_cast<__int128>(a[j]) * b[i];
    if (minor > bound || minor < -bound) return true;
  }
  return false;
}

/// The sign of a number of W words that is at least 2^bit away from zero; else uncertain.
template <int W>
inline Sign clear_sign(const Fixed<W>& a, int bit) {
  const std::uint64_t fill = fixed_detail::sign_word(a.word[W - 1]);
  std::uint64_t above = (a.word[bit / 64] ^ fill) >> (bit % 64);
  for (int i = bit / 64 + 1; i < W; ++i) above |= a.word[i] ^ fill;
  return above == 0 ? uncertain : fill != 0 ? -1 : 1;
}

/// The sign of det(a, b, c) by the leading 125 bits, if they tell.
inline Sign leading_order(const Wide3<2>& a, const Wide3<2>& b, const Wide3<2>& c) {
  // Components below 2^125 and less than 1 too small: minors below 2^251, within 2^127 + 2; over 2^128, rounded down,
  // below 2^123 and within 2. Times c: below 2^248, and within 2^126 + 2^123 + 2; the three together within 2^128.
  const Wide3<4> minors = cross<4, 2>(a, b);
  Wide3<2> upper;
  for (std::size_t k = 0; k < 3; ++k) upper[k] = {{minors[k].word[2], minors[k].word[3]}};
  return clear_sign(dot<4, 2, 2>(upper, c), 128);
}

}  // namespace sightline
