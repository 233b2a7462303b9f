// Signed integers of a fixed number of 64-bit words: no allocation, no branches on values.
#pragma once

#include <cstdint>

namespace sightline {

inline constexpr int most_words = 16;

/// Two's complement, little-endian. All operations are exact modulo 2^(64 W): a chain of them is right as soon as its
/// final result fits, whatever happened on the way.
template <int W>
struct Fixed {
  static_assert(W >= 1 && W <= most_words);
  std::uint64_t word[W];
};

namespace fixed_detail {

inline unsigned char add_carry(unsigned char carry, std::uint64_t a, std::uint64_t b, std::uint64_t& sum) {
#if defined(__x86_64__) && !defined(__clang__)
  unsigned long long out;
  carry = __builtin_ia32_addcarryx_u64(carry, a, b, &out);
  sum = out;
  return carry;
#else
  const unsigned __int128 t = static_cast<unsigned __int128>(a) + b + carry;
  sum = static_cast<std::uint64_t>(t);
  return static_cast<unsigned char>(t >> 64);
#endif
}

inline unsigned char sub_borrow(unsigned char borrow, std::uint64_t a, std::uint64_t b, std::uint64_t& difference) {
#if defined(__x86_64__) && !defined(__clang__)
  unsigned long long out;
  borrow = __builtin_ia32_sbb_u64(borrow, a, b, &out);
  difference = out;
  return borrow;
#else
  const unsigned __int128 t = static_cast<unsigned __int128>(a) - b - borrow;
  difference = static_cast<std::uint64_t>(t);
  return static_cast<unsigned char>((t >> 64) & 1);
#endif
}

inline __int128 to_int128(const Fixed<2>& a) {
  return static_cast<__int128>((static_cast<unsigned __int128>(a.word[1]) << 64) | a.word[0]);
}
inline Fixed<2> from_int128(__int128 a) {
  return {{static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(static_cast<unsigned __int128>(a) >> 64)}};
}
inline std::uint64_t sign_word(std::uint64_t top) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(top) >> 63);
}

}  // namespace fixed_detail

template <int W>
inline Fixed<W> operator+(const Fixed<W>& a, const Fixed<W>& b) {
  Fixed<W> r;
  if constexpr (W == 1) {
    r.word[0] = a.word[0] + b.word[0];
  } else {
    unsigned char carry = 0;
#pragma GCC unroll 16
    for (int i = 0; i < W; ++i) carry = fixed_detail::add_carry(carry, a.word[i], b.word[i], r.word[i]);
  }
  return r;
}

template <int W>
inline Fixed<W> operator-(const Fixed<W>& a, const Fixed<W>& b) {
  Fixed<W> r;
  if constexpr (W == 1) {
    r.word[0] = a.word[0] - b.word[0];
  } else {
    unsigned char borrow = 0;
#pragma GCC unroll 16
    for (int i = 0; i < W; ++i) borrow = fixed_detail::sub_borrow(borrow, a.word[i], b.word[i], r.word[i]);
  }
  return r;
}

template <int W>
inline Fixed<W> operator-(const Fixed<W>& a) {
  return Fixed<W>{} - a;
}

/// The same value (modulo) in R words.
template <int R, int W>
inline Fixed<R> resize(const Fixed<W>& a) {
  Fixed<R> r;
  const std::uint64_t fill = fixed_detail::sign_word(a.word[W - 1]);
  for (int i = 0; i < R; ++i) r.word[i] = i < W ? a.word[i] : fill;
  return r;
}

namespace fixed_detail {
/// r = a b modulo 2^(64 count), for a and b of n and m words, count <= n + m.
void multiply_words(std::uint64_t* r, int count, const std::uint64_t* a, int n, const std::uint64_t* b, int m);
/// Products of more word pairs than this are loops, not unrolled code: they are rare, and code is not free.
inline constexpr int unrolled_products = 20;
}  // namespace fixed_detail

/// The product modulo 2^(64 R), of N times M words.
template <int R, int N, int M>
inline Fixed<R> multiply(const Fixed<N>& a, const Fixed<M>& b) {
  if constexpr (R > N + M) {
    return resize<R>(multiply<N + M>(a, b));
  } else if constexpr (R == 1) {
    return {{a.word[0] * b.word[0]}};
  } else if constexpr (R == 2 && N == 1 && M == 1) {
    return fixed_detail::from_int128(static_cast<__int128>(static_cast<std::int64_t>(a.word[0])) *
                                     static_cast<std::int64_t>(b.word[0]));
  } else if constexpr (N * M > fixed_detail::unrolled_products) {
    Fixed<R> r;
    fixed_detail::multiply_words(r.word, R, a.word, N, b.word, M);
    return r;
  } else {
    // Unsigned product; then, with a = ua - [a<0] 2^(64N) and the same for b, the corrections
    // - [a<0] ub 2^(64N) - [b<0] ua 2^(64M); the last term, 2^(64(N+M)), vanishes as R <= N+M.
    Fixed<R> r{};
#pragma GCC unroll 16
    for (int i = 0; i < N; ++i) {
      if (i >= R) break;
      std::uint64_t carry = 0;
#pragma GCC unroll 16
      for (int j = 0; j < M; ++j) {
        if (i + j >= R) break;
        const unsigned __int128 t =
            static_cast<unsigned __int128>(a.word[i]) * b.word[j] + r.word[i + j] + carry;  // < 2^128: no overflow
        r.word[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      if (i + M < R) r.word[i + M] = carry;
    }
    if constexpr (R > N) {
      const std::uint64_t mask = fixed_detail::sign_word(a.word[N - 1]);
      unsigned char borrow = 0;
#pragma GCC unroll 16
      for (int i = N; i < R; ++i) borrow = fixed_detail::sub_borrow(borrow, r.word[i], b.word[i - N] & mask, r.word[i]);
    }
    if constexpr (R > M) {
      const std::uint64_t mask = fixed_detail::sign_word(b.word[M - 1]);
      unsigned char borrow = 0;
#pragma GCC unroll 16
      for (int i = M; i < R; ++i) borrow = fixed_detail::sub_borrow(borrow, r.word[i], a.word[i - M] & mask, r.word[i]);
    }
    return r;
  }
}

/// a * 2^shift, modulo; shift >= 0.
template <int W>
inline Fixed<W> shift_left(const Fixed<W>& a, int shift) {
  if (shift == 0) return a;
  Fixed<W> r;
  const int words = shift / 64, bits = shift % 64;
  for (int i = W - 1; i >= 0; --i) {
    const std::uint64_t high = i >= words ? a.word[i - words] : 0;
    const std::uint64_t low = i >= words + 1 ? a.word[i - words - 1] : 0;
    r.word[i] = bits == 0 ? high : (high << bits) | (low >> (64 - bits));
  }
  return r;
}

template <int W>
inline int sign(const Fixed<W>& a) {
  if (static_cast<std::int64_t>(a.word[W - 1]) < 0) return -1;
  std::uint64_t any = 0;
  for (int i = 0; i < W; ++i) any |= a.word[i];
  return any != 0;
}

}  // namespace sightline
