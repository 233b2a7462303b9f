#include "exact/window.hpp"
#include "exact/quotient.hpp"
#include "exact/rounding.hpp"
#include "exact/wide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sightline {
namespace {

// mantissa * 2^shift as `count` words; it fits.
void store_shifted(std::int64_t mantissa, int shift, std::uint64_t* words, std::uint32_t count) {
  std::fill(words, words + count, 0);
  const std::uint64_t size = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
  const auto at = static_cast<std::uint32_t>(shift) / 64;
  const int bits = shift % 64;
  words[at] = size << bits;
  if (bits > 0 && at + 1 < count) words[at + 1] = size >> (64 - bits);
  if (mantissa >= 0) return;
  std::uint64_t carry = 1;
  for (std::uint32_t i = at; i < count; ++i) {
    words[i] = ~words[i] + carry;
    carry = carry != 0 && words[i] == 0 ? 1 : 0;
  }
}

// Calls f(Words<N>, Words<W>) with words for the vectors with two bits more, and for products of two of them: two
// widths that need no allocation, and any.
template <class F>
auto at_window_width(int bits, F&& f) {
  if (bits + 2 < 128) return f(Words<2>{}, Words<4>{});
  if (bits + 2 < 256) return f(Words<4>{}, Words<8>{});
  return f(Words<0>{}, Words<0>{});
}

}  // namespace

Window::Window(const glm::dvec3& f, const glm::dvec3& r, const glm::dvec3& u) {
  const glm::dvec3* const given[3] = {&f, &r, &u};
  Dyadic number[9];
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < 9; ++i) {
    const double x = (*given[i / 3])[static_cast<int>(i % 3)];
    if (!std::isfinite(x)) throw std::invalid_argument("a vector of the window is not finite");
    number[i] = dyadic(x);
    if (x != 0) least = std::min(least, number[i].exponent);
  }
  for (const Dyadic& d : number) {
    if (d.mantissa != 0) bits_ = std::max(bits_, d.exponent - least + static_cast<int>(magnitude_bits(d.mantissa)));
  }
  stride_ = words_for(static_cast<std::uint32_t>(bits_));
  if (stride_ > short_stride) long_words_.resize(std::size_t{9} * stride_);
  std::uint64_t* const to = stride_ > short_stride ? long_words_.data() : short_words_.data();
  for (std::uint32_t i = 0; i < 9; ++i) {
    store_shifted(number[i].mantissa, number[i].mantissa == 0 ? 0 : number[i].exponent - least, to + i * stride_,
                  stride_);
  }

  std::uint32_t across_bits = 0;
  at_window_width(bits_, [&]<int N, int W>(Words<N>, Words<W>) {
    const Wide3<W> across = cross<W, N>(load3<N>(to + 3 * stride_, stride_), load3<N>(to + 6 * stride_, stride_));
    if constexpr (W > 0) {
      for (const Wide<W>& c : across) across_bits = std::max(across_bits, magnitude_bits(c.word, W));
      for (std::size_t k = 0; k < 3; ++k)
        across_[static_cast<int>(k)] = words_to_double(across[k].word, W, -static_cast<int>(across_bits));
    } else {
      for (const Integer& c : across) across_bits = std::max(across_bits, magnitude_bits(c));
      for (std::size_t k = 0; k < 3; ++k)
        across_[static_cast<int>(k)] = nearest_double(across[k], -static_cast<int>(across_bits));
    }
  });
  // det(forward, right, up): forward, over its largest component, and right x up are at most 1 and within 2^-53 each,
  // so that their product is within 3 (1 + 1) 2^-53 (data) + (3 + 2 + 3) 2^-53 (rounding) < 32 2^-53.
  const double size = std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)});
  const double det = across_.x * (f.x / size) + across_.y * (f.y / size) + across_.z * (f.z / size);
  if (std::abs(det) > 0x1p-48) {
    ++tally().filter;
    handedness_ = det < 0 ? 1 : -1;
    return;
  }
  const Integer exact =
      det3<0, 0, 0>(load3<0>(to, stride_), load3<0>(to + 3 * stride_, stride_), load3<0>(to + 6 * stride_, stride_));
  if (exact == 0) throw std::invalid_argument("the vectors of the window are linearly dependent");
  handedness_ = exact < 0 ? 1 : -1;
}

SightlineRef Window::side(SightlineTable& table, Side which) const {
  // The side s = 0 is spanned by 2f - r and up; its normal (2f - r) x up has the product -det(r, up, f) with f,
  // positive for handedness +1. The others alike.
  const SightlineRef ref = at_window_width(bits_, [&]<int N, int W>(Words<N>, Words<W>) {
    const bool upright = which == left || which == right, less = which == left || which == bottom;
    const Wide3<N> f = load3<N>(words(), stride_), r = load3<N>(words() + 3 * stride_, stride_),
                   up = load3<N>(words() + 6 * stride_, stride_);
    const Wide3<N>&across = upright ? r : up, &along = upright ? up : r;
    Wide3<N> spanned;
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide<N> twice = Wide<N>(f[k] + f[k]);
      spanned[k] = less ? Wide<N>(twice - across[k]) : Wide<N>(twice + across[k]);
    }
    const bool first = which == left || which == top;
    const Wide3<W> n = first ? cross<W, N>(spanned, along) : cross<W, N>(along, spanned);
    if constexpr (W > 0) {
      std::uint64_t normal[3 * W];
      for (std::size_t k = 0; k < 3; ++k) std::copy(n[k].word, n[k].word + W, normal + k * W);
      return table.of_normal(normal, W);
    } else {
      return table.of_normal(n);
    }
  });
  return handedness_ > 0 ? ref : -ref;
}

SightlineRef Window::upright(SightlineTable& table, unsigned k, unsigned n) const {
  // Spanned by 2n f + (2k - n) r and up, like the left side, which is k = 0.
  const auto vector = [this](std::uint32_t i) { return load3<0>(words() + 3 * i * stride_, stride_); };
  const std::array<Integer, 3> f = vector(0), r = vector(1), up = vector(2);
  std::array<Integer, 3> spanned;
  for (std::size_t i = 0; i < 3; ++i)
    spanned[i] = 2 * n * f[i] + (2 * static_cast<long>(k) - static_cast<long>(n)) * r[i];
  const SightlineRef ref = table.of_normal(cross<0, 0>(spanned, up));
  return handedness_ > 0 ? ref : -ref;
}

// With l_f, l_r, l_u the products of a line's normal with forward, right and up, the line is
// l_f + (s - 1/2) l_r + (t - 1/2) l_u = 0 in the window. Two lines a, b meet where
//   (s - 1/2) : (t - 1/2) : 1 = a_u b_f - a_f b_u : a_f b_r - a_r b_f : a_r b_u - a_u b_r.
namespace {

// f(Words<W>, la, lb): both lines' three products, in words for f's minors and `more` further bits.
template <class F>
auto with_window_lines(const SightlineTable& table, SightlineId a, SightlineId b, const std::uint64_t* vectors,
                       std::uint32_t stride, int vector_bits, int more, F&& f) {
  const auto bits_a = static_cast<int>(table.bits(a)), bits_b = static_cast<int>(table.bits(b));
  const int longest = std::max(bits_a, bits_b);
  // Products of three terms have two bits more than their factors together; minors of them one more than both.
  return at_width(bits_a + bits_b + 2 * vector_bits + 5 + more, [&](auto width) {
    constexpr int W = width();
    const auto go = [&]<int L>(Words<L>) {
      const auto line = [&](SightlineId id) {
        return narrowed<L>(longest, vector_bits, [&]<int N, int M>(Words<N>, Words<M>) {
          const Wide3<N> n = load3<N>(table.words(id), words_for(table.bits(id)));
          Wide3<L> l;
          for (std::uint32_t i = 0; i < 3; ++i) l[i] = dot<L, N, M>(n, load3<M>(vectors + 3 * i * stride, stride));
          return l;
        });
      };
      return f(width, Words<L>{}, line(a), line(b));
    };
    constexpr int half = (W + 1) / 2;
    if constexpr (W > 1)
      if (longest + vector_bits + 2 < 64 * half) return go(Words<half>{});
    return go(Words<W>{});
  });
}

}  // namespace

glm::dvec2 Window::st(const SightlineTable& table, SightlineId a, SightlineId b) const {
  // s = (w + 2x) / 2w with x : y : w as above: two bits more.
  return with_window_lines(table, a, b, words(), stride_, bits_, 2,
                           [&]<int W, int L>(Words<W>, Words<L>, const Wide3<L>& la, const Wide3<L>& lb) {
                             const auto minor = [&](std::size_t i, std::size_t j) {
                               return minor2<W, L, L>(la[i], la[j], lb[i], lb[j]);
                             };
                             const Wide<W> x = minor(2, 0), y = minor(0, 1), w = minor(1, 2);
                             const Wide<W> twice = w + w;
                             return glm::dvec2(nearest_quotient<W>(Wide<W>(w + x + x), twice),
                                               nearest_quotient<W>(Wide<W>(w + y + y), twice));
                           });
}

Sign Window::forwardness(const SightlineTable& table, SightlineRef a, SightlineRef b) const {
  // n_b x n_a = l (forward + ...): its product with right x up is l D, and D = det(forward, right, up) has the sign
  // -handedness. That product is the minor b_r a_u - b_u a_r.
  const Sign filtered = filter_order(table.approx(b.id), table.approx(a.id), across_);
  const Sign signs = -handedness_ * a.sign * b.sign;
  if (filtered != uncertain) {
    ++tally().filter;
    return signs * filtered;
  }
  return signs * with_window_lines(table, b.id, a.id, words(), stride_, bits_, 0,
                                   [&]<int W, int L>(Words<W>, Words<L>, const Wide3<L>& lb, const Wide3<L>& la) {
                                     ++tally().exact[tally_index<W>];
                                     return sign_of<W>(minor2<W, L, L>(lb[1], lb[2], la[1], la[2]));
                                   });
}

}  // namespace sightline
