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

using Vector = std::array<Integer, 3>;

Vector combination(int p, const Vector& a, int q, const Vector& b) {
  return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}

}  // namespace

Window::Window(const glm::dvec3& f, const glm::dvec3& r, const glm::dvec3& u) {
  const std::array<glm::dvec3, 3> given{f, r, u};
  int least = std::numeric_limits<int>::max();
  for (const glm::dvec3& v : given)
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(v[k])) throw std::invalid_argument("a vector of the window is not finite");
      if (v[k] != 0) least = std::min(least, dyadic(v[k]).exponent);
    }
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const Dyadic d = dyadic(given[i][k]);
      Integer& c = vectors_[i][static_cast<std::size_t>(k)];
      if (d.mantissa != 0) c = shifted(Integer(d.mantissa), d.exponent - least);
      bits = std::max(bits, magnitude_bits(c));
    }
  const Vector across = cross<0, 0>(vectors_[1], vectors_[2]);
  const Integer det = dot<0, 0, 0>(across, vectors_[0]);
  if (det == 0) throw std::invalid_argument("the vectors of the window are linearly dependent");
  handedness_ = det < 0 ? 1 : -1;

  bits_ = static_cast<int>(bits);
  stride_ = words_for(bits);
  words_.resize(std::size_t{9} * stride_);
  std::uint32_t across_bits = 0;
  for (std::uint32_t i = 0; i < 9; ++i) store_words(vectors_[i / 3][i % 3], words_.data() + i * stride_, stride_);
  for (const Integer& c : across) across_bits = std::max(across_bits, magnitude_bits(c));
  for (int k = 0; k < 3; ++k)
    across_[k] = nearest_double(across[static_cast<std::size_t>(k)], -static_cast<int>(across_bits));
}

SightlineRef Window::side(SightlineTable& table, Side which) const {
  const auto& [f, r, up] = vectors_;
  // The side s = 0 is spanned by 2f - r and up; its normal (2f - r) x up has the product -det(r, up, f) with f,
  // positive for handedness +1. The others alike.
  Vector n;
  switch (which) {
    case left:
      n = cross<0, 0>(combination(2, f, -1, r), up);
      break;
    case right:
      n = cross<0, 0>(up, combination(2, f, 1, r));
      break;
    case bottom:
      n = cross<0, 0>(r, combination(2, f, -1, up));
      break;
    case top:
      n = cross<0, 0>(combination(2, f, 1, up), r);
      break;
  }
  const SightlineRef ref = table.of_normal(n);
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
  return with_window_lines(table, a, b, words_.data(), stride_, bits_, 2,
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
  return signs * with_window_lines(table, b.id, a.id, words_.data(), stride_, bits_, 0,
                                   [&]<int W, int L>(Words<W>, Words<L>, const Wide3<L>& lb, const Wide3<L>& la) {
                                     ++tally().exact[tally_index<W>];
                                     return sign_of<W>(minor2<W, L, L>(lb[1], lb[2], la[1], la[2]));
                                   });
}

}  // namespace sightline
