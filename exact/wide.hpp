// One spelling for arithmetic at every width: Wide<W> is a Fixed<W>, and for W = 0 an Integer.
#pragma once

#include "exact/fixed.hpp"
#include "exact/limbs.hpp"
#include "exact/tally.hpp"

#include <type_traits>
#include <utility>

namespace sightline {

template <int W>
struct WideOf {
  using type = Fixed<W>;
};
template <>
struct WideOf<0> {
  using type = Integer;
};
template <int W>
using Wide = typename WideOf<W>::type;

/// Words that hold a product of N by M words, but no more than R; 0 stays any length.
template <int R, int N, int M>
inline constexpr int product_words = R == 0 ? 0 : (N + M < R ? N + M : R);

template <int W>
inline Wide<W> load(const std::uint64_t* words, std::uint32_t count) {
  if constexpr (W == 0) {
    return load_integer(words, count);
  } else {
    Fixed<W> r;
    const auto n = static_cast<int>(count);
    const std::uint64_t fill = fixed_detail::sign_word(words[count - 1]);
    for (int i = 0; i < W; ++i) r.word[i] = i < n ? words[i] : fill;
    return r;
  }
}

template <int R, int N, int M>
inline Wide<R> times(const Wide<N>& a, const Wide<M>& b) {
  if constexpr (R == 0) {
    return Integer(a * b);
  } else {
    return multiply<R>(a, b);
  }
}

template <int W>
inline Sign sign_of(const Wide<W>& a) {
  if constexpr (W == 0) {
    return sgn(a);
  } else {
    return sign(a);
  }
}

template <int W>
inline Wide<W> scaled_up(const Wide<W>& a, int shift) {
  if constexpr (W == 0) {
    Integer r;
    mpz_mul_2exp(r.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    return r;
  } else {
    return shift_left(a, shift);
  }
}

template <int R, int W>
inline Wide<R> resized(const Wide<W>& a) {
  if constexpr (R == 0) {
    return a;
  } else {
    return resize<R>(a);
  }
}

/// Calls f(std::integral_constant<int, W>) with the least W of the ladder 1, 2, 3, 4, 6, 8, 12, 16 whose W words hold
/// a magnitude of `bits` bits and its sign; 0 beyond.
template <class F>
inline auto at_width(int bits, F&& f) {
  if (bits < 64) return f(std::integral_constant<int, 1>{});
  if (bits < 128) return f(std::integral_constant<int, 2>{});
  if (bits < 192) return f(std::integral_constant<int, 3>{});
  if (bits < 256) return f(std::integral_constant<int, 4>{});
  if (bits < 384) return f(std::integral_constant<int, 6>{});
  if (bits < 512) return f(std::integral_constant<int, 8>{});
  if (bits < 768) return f(std::integral_constant<int, 12>{});
  if (bits < 1024) return f(std::integral_constant<int, 16>{});
  return f(std::integral_constant<int, 0>{});
}

/// Place of a width of the ladder in Tally::widths.
template <int W>
inline constexpr std::size_t tally_index = W == 0    ? 8
                                           : W <= 4  ? static_cast<std::size_t>(W - 1)
                                           : W == 6  ? 4
                                           : W == 8  ? 5
                                           : W == 12 ? 6
                                                     : 7;

/// at_width, counted as a decision.
template <class F>
inline Sign decide(int bits, F&& f) {
  return at_width(bits, [&](auto width) -> Sign {
    ++tally().exact[tally_index<width()>];
    return f(width);
  });
}

template <int W>
using Words = std::integral_constant<int, W>;

/// Narrow operands make cheap products. Calls f(Words<N>, Words<M>) with words that hold operands of these bit
/// lengths, for a result of W words: one word each, else half of W each (rounded up), else W each.
template <int W, class F>
inline auto narrowed(int first_bits, int second_bits, F&& f) {
  if constexpr (W > 1) {
    if (first_bits < 64 && second_bits < 64) return f(Words<1>{}, Words<1>{});
    constexpr int half = (W + 1) / 2;
    if constexpr (half > 1 && half < W)
      if (first_bits < 64 * half && second_bits < 64 * half) return f(Words<half>{}, Words<half>{});
  }
  return f(Words<W>{}, Words<W>{});
}

/// The same for products of three operands of one length: one third of W words each, else W.
template <int W, class F>
inline auto narrowed_to_thirds(int bits, F&& f) {
  constexpr int third = (W + 2) / 3;
  if constexpr (W > 1)
    if (bits < 64 * third) return f(Words<third>{});
  return f(Words<W>{});
}

/// a0 b1 - a1 b0 in R words.
template <int R, int N, int M>
inline Wide<R> minor2(const Wide<N>& a0, const Wide<M>& a1, const Wide<N>& b0, const Wide<M>& b1) {
  return Wide<R>(times<R, N, M>(a0, b1) - times<R, N, M>(b0, a1));
}

template <int N>
using Wide3 = std::array<Wide<N>, 3>;

/// Three integers that stand one after the other, `stride` words each.
template <int N>
inline Wide3<N> load3(const std::uint64_t* words, std::uint32_t stride) {
  return {load<N>(words, stride), load<N>(words + stride, stride), load<N>(words + 2 * stride, stride)};
}

/// The cross product a x b.
template <int R, int N>
inline Wide3<R> cross(const Wide3<N>& a, const Wide3<N>& b) {
  return {minor2<R, N, N>(a[1], a[2], b[1], b[2]), minor2<R, N, N>(a[2], a[0], b[2], b[0]),
          minor2<R, N, N>(a[0], a[1], b[0], b[1])};
}

template <int R, int N, int M>
inline Wide<R> dot(const Wide3<N>& a, const Wide3<M>& b) {
  return Wide<R>(times<R, N, M>(a[0], b[0]) + times<R, N, M>(a[1], b[1]) + times<R, N, M>(a[2], b[2]));
}

/// det(a, b, c), of N, N and M words, in R words.
template <int R, int N, int M>
inline Wide<R> det3(const Wide3<N>& a, const Wide3<N>& b, const Wide3<M>& c) {
  constexpr int minor = product_words<R, N, N>;
  return dot<R, minor, M>(cross<minor, N>(a, b), c);
}

}  // namespace sightline
