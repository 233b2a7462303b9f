// The exact stages of SightlineTable: normals of new lines, and signs where the filters do not tell.
#include "exact/gcd.hpp"
#include "exact/plane_row.hpp"
#include "exact/sightline_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sightline {
namespace {

// point - eye on the eye's grid; N words hold it.
template <int N>
Wide3<N> from_eye(const PointTable& points, PointId p, const ExactEye& eye) {
  if constexpr (N == 1) {
    // The lowest words tell it all, since the result fits.
    const std::uint64_t *w = points.words(p), *e = eye.words.data();
    const std::uint32_t i = points.stride(), k = eye.stride;
    return {Fixed<1>{{(w[0] << eye.shift) - e[0]}}, Fixed<1>{{(w[i] << eye.shift) - e[k]}},
            Fixed<1>{{(w[2 * i] << eye.shift) - e[2 * k]}}};
  }
  Wide3<N> r = load3<N>(points.words(p), points.stride());
  const Wide3<N> e = load3<N>(eye.words.data(), eye.stride);
  for (std::size_t k = 0; k < 3; ++k) r[k] = Wide<N>(scaled_up<N>(r[k], eye.shift) - e[k]);
  return r;
}

// (b - eye) where it differs from (a - eye) in one component only: their product is a multiple of (a - eye) x e_k, and
// that is shorter by half. All edges along an axis come here.
template <int W, int N>
bool axis_cross(const Wide3<N>& a, const Wide3<N>& b, Wide3<W>& n) {
  std::array<Sign, 3> s;
  for (std::size_t k = 0; k < 3; ++k) s[k] = sign_of<N>(Wide<N>(b[k] - a[k]));
  if (std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]) != 1) return false;
  const std::size_t k = s[0] != 0 ? 0 : s[1] != 0 ? 1 : 2, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  n = {};
  n[k1] = resized<W, N>(s[k] > 0 ? a[k2] : Wide<N>(-a[k2]));
  n[k2] = resized<W, N>(s[k] > 0 ? Wide<N>(-a[k1]) : a[k1]);
  return true;
}

// Hands the words of a normal to `take(words, stride)`; on the stack where the width is fixed.
template <int W, class Take>
SightlineRef with_words(const Wide3<W>& n, std::vector<std::uint64_t>& scratch, Take&& take) {
  if constexpr (W == 0) {
    std::uint32_t bits = 0;
    for (const Integer& c : n) bits = std::max(bits, magnitude_bits(c));
    const std::uint32_t stride = words_for(bits);
    scratch.resize(std::size_t{3} * stride);
    for (std::uint32_t k = 0; k < 3; ++k) store_words(n[k], scratch.data() + k * stride, stride);
    return take(scratch.data(), stride);
  } else {
    std::array<std::uint64_t, 3 * W> words;
    for (std::size_t k = 0; k < 3; ++k) std::copy(n[k].word, n[k].word + W, words.data() + k * W);
    return take(words.data(), static_cast<std::uint32_t>(W));
  }
}

// P(eye) = n.eye - d 2^shift has at most this many bits: three products, and the offset.
int value_bits(const PlaneRow& row, const ExactEye& eye) {
  return std::max(row.normal_bits + eye.bits + 2, row.offset_bits + eye.shift) + 1;
}

template <int R, int N>
Wide<R> value_at(const PlaneRow& row, const ExactEye& eye) {
  const auto product = narrowed<R>(row.normal_bits, eye.bits, [&]<int A, int B>(Words<A>, Words<B>) {
    return dot<R, A, B>(row.normal<A>(), load3<B>(eye.words.data(), eye.stride));
  });
  return Wide<R>(product - scaled_up<R>(row.offset<R>(), eye.shift));
}

}  // namespace

// As intern() below for normals of up to 63 or 127 bits, in registers.
template <class Int>
SightlineRef SightlineTable::intern_short(const std::array<Int, 3>& n) {
  using Unsigned = std::conditional_t<sizeof(Int) == 8, std::uint64_t, UInt128>;
  // The magnitudes laid over each other are as long as the longest and have the common factors of two.
  Unsigned over = 0;
  for (const Int c : n) over |= static_cast<Unsigned>(c < 0 ? -c : c);
  if (over == 0) return {};
  const int twos = trailing_zeros(over);
  over >>= twos;
  int bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(over)));
  if constexpr (sizeof(Int) > 8) {
    if (const auto above = static_cast<std::uint64_t>(over >> 64); above != 0) {
      bits = 64 + static_cast<int>(std::bit_width(above));
    }
  }
  const bool one_word = sizeof(Int) == 8 || bits < 64;
  std::uint64_t words[6];
  Normal made{words, static_cast<std::uint32_t>(bits), {}, {}, {}};
  // One word: the conversion rounds once, by 2^-54 at most. Two: what the upper 63 bits leave out, less than 2^-63, is
  // below what the promise of approx() has left.
  const double power = one_word ? std::bit_cast<double>(static_cast<std::uint64_t>(1023 - bits) << 52) : 0x1p-63;
  for (int k = 0; k < 3; ++k) {
    const Int c = n[static_cast<std::size_t>(k)] >> twos;
    const auto low = static_cast<std::uint64_t>(c);
    std::uint64_t top = low;
    if (one_word) {
      words[k] = low;
    } else if constexpr (sizeof(Int) > 8) {
      const auto high = static_cast<std::uint64_t>(c >> 64);
      words[2 * k] = low;
      words[2 * k + 1] = high;
      top = (high << (127 - bits)) | (low >> 1 >> (bits - 64));
    }
    made.approx[k] = static_cast<double>(static_cast<std::int64_t>(top)) * power;
    made.sign[k] = (c > 0) - (c < 0);
  }
  if (made.bits > word_bits) made.leading = LeadingBits(words, made.bits);
  return find_or_add(made);
}

// Coordinates and differences of one word, as most scenes have.
SightlineRef SightlineTable::make_of_short_points(PointId a, PointId b) {
  const PointTable& points = planes_->points();
  const std::uint64_t *const e = exact_eye_.words.data(), *const wa = points.words(a), *const wb = points.words(b);
  const int shift = exact_eye_.shift;
  std::int64_t p[3], q[3];
  for (int k = 0; k < 3; ++k) {
    p[k] = static_cast<std::int64_t>((wa[k] << shift) - e[k]);
    q[k] = static_cast<std::int64_t>((wb[k] << shift) - e[k]);
  }
  // Edges along an axis, as in axis_cross.
  const bool x = p[0] == q[0], y = p[1] == q[1], z = p[2] == q[2];
  if (x + y + z == 2) {
    const int k = !x ? 0 : !y ? 1 : 2, k1 = k == 2 ? 0 : k + 1, k2 = k == 0 ? 2 : k - 1;
    const bool up = q[k] > p[k];
    std::array<std::int64_t, 3> n{};
    n[static_cast<std::size_t>(k1)] = up ? p[k2] : -p[k2];
    n[static_cast<std::size_t>(k2)] = up ? -p[k1] : p[k1];
    return intern_short(n);
  }
  // Below 2^126, their differences below 2^127.
  const auto minor = [&](int i, int j) {
    return static_cast<__int128>(p[i]) * q[j] - static_cast<__int128>(p[j]) * q[i];
  };
  return intern_short(std::array{minor(1, 2), minor(2, 0), minor(0, 1)});
}

SightlineRef SightlineTable::make_of_points(PointId a, PointId b) {
  const int bits = exact_eye_.difference_bits;
  const auto take = [&](std::uint64_t* words, std::uint32_t stride) { return intern(words, stride); };
  // The difference of two products of differences.
  return at_width(2 * bits + 1, [&](auto width) {
    constexpr int W = width();
    return narrowed<W>(bits, bits, [&]<int N, int M>(Words<N>, Words<M>) {
      const PointTable& points = planes_->points();
      const Wide3<N> p = from_eye<N>(points, a, exact_eye_), q = from_eye<N>(points, b, exact_eye_);
      Wide3<W> n;
      if (!axis_cross<W, N>(p, q, n)) n = cross<W, N>(p, q);
      return with_words<W>(n, scratch_, take);
    });
  });
}

SightlineRef SightlineTable::make_of_planes(PlaneId p, PlaneId q) {
  const auto take = [&](std::uint64_t* words, std::uint32_t stride) { return intern(words, stride); };
  const PlaneRow rp(*planes_, p), rq(*planes_, q);
  const int bits_p = value_bits(rp, exact_eye_), bits_q = value_bits(rq, exact_eye_);
  const int normal_bits = std::max(rp.normal_bits, rq.normal_bits), bits = std::max(bits_p, bits_q);
  return at_width(std::max(bits_p + rq.normal_bits, bits_q + rp.normal_bits) + 1, [&](auto width) {
    constexpr int W = width();
    const auto make = [&]<int N, int M>(Words<N>, Words<M>) {
      const Wide<M> at_p = value_at<M, N>(rp, exact_eye_), at_q = value_at<M, N>(rq, exact_eye_);
      const Wide3<N> np = rp.normal<N>(), nq = rq.normal<N>();
      Wide3<W> n;
      for (std::size_t k = 0; k < 3; ++k) n[k] = Wide<W>(times<W, M, N>(at_p, nq[k]) - times<W, M, N>(at_q, np[k]));
      return with_words<W>(n, scratch_, take);
    };
    // A normal of 2B+2 bits and a value of 3B+5: two and three fifths, rounded up.
    constexpr int N = W == 0 ? 0 : (2 * W + 4) / 5, M = W == 0 ? 0 : (3 * W + 4) / 5;
    if constexpr (W > 1)
      if (normal_bits < 64 * N && bits < 64 * M) return make(Words<N>{}, Words<M>{});
    return make(Words<W>{}, Words<W>{});
  });
}

glm::dvec3 SightlineTable::corner(SightlineId a, SightlineId b) const {
  const Line &x = line_[a], &y = line_[b];
  const auto bits_x = static_cast<int>(x.bits), bits_y = static_cast<int>(y.bits);
  // Each component is the difference of two products.
  return at_width(bits_x + bits_y + 1, [&](auto width) {
    constexpr int W = width();
    return narrowed<W>(bits_x, bits_y, [&]<int N, int M>(Words<N>, Words<M>) {
      const Wide3<N> p = load3<N>(words_.data() + x.first, words_for(x.bits));
      const Wide3<M> q = load3<M>(words_.data() + y.first, words_for(y.bits));
      Wide3<W> n;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = Wide<W>(times<W, N, M>(p[i], q[j]) - times<W, N, M>(p[j], q[i]));
      }
      glm::dvec3 ray;
      std::vector<std::uint64_t> longer;
      with_words<W>(n, longer, [&](std::uint64_t* words, std::uint32_t stride) {
        std::uint32_t bits = 0;
        for (std::uint32_t k = 0; k < 3; ++k) bits = std::max(bits, magnitude_bits(words + k * stride, stride));
        for (std::uint32_t k = 0; k < 3; ++k) {
          ray[static_cast<int>(k)] = words_to_double(words + k * stride, stride, -static_cast<int>(bits));
        }
        return SightlineRef{};
      });
      return ray;
    });
  });
}

SightlineRef SightlineTable::of_plane(PlaneId p) {
  const PlaneRow row(*planes_, p);
  scratch_.assign(row.words, row.words + std::size_t{3} * row.normal_words);
  return intern(scratch_.data(), row.normal_words);
}

SightlineRef SightlineTable::of_normal(const std::array<Integer, 3>& n) {
  return with_words<0>(n, scratch_, [&](std::uint64_t* words, std::uint32_t stride) { return intern(words, stride); });
}

SightlineRef SightlineTable::intern(std::uint64_t* words, std::uint32_t stride) {
  // The common factors of two go: they are many where the eye is finer than the grid. Never all words at a time.
  const std::uint64_t low = words[0] | words[stride] | words[2 * stride];
  if (const int twos = std::countr_zero(low); twos > 0 && twos < 64)
    for (std::uint64_t* w = words; w != words + std::size_t{3} * stride; w += stride) {
      for (std::uint32_t i = 0; i + 1 < stride; ++i) w[i] = (w[i] >> twos) | (w[i + 1] << (64 - twos));
      w[stride - 1] = static_cast<std::uint64_t>(static_cast<std::int64_t>(w[stride - 1]) >> twos);
    }
  std::uint32_t bits = 0;
  for (std::uint32_t k = 0; k < 3; ++k) bits = std::max(bits, magnitude_bits(words + k * stride, stride));
  if (bits == 0) return {};
  const std::uint32_t tight = words_for(bits);
  for (std::uint32_t k = 1; tight != stride && k < 3; ++k)
    std::copy(words + k * stride, words + k * stride + tight, words + k * tight);
  Normal n{words, bits, {}, {}, LeadingBits(words, bits)};
  // What the leading word leaves out, less than 2^-62, is below what the promise of approx() has left: rounding a
  // number below 1 takes 2^-54 of its 2^-53.
  for (std::uint32_t k = 0; k < 3; ++k) {
    n.sign[k] = sign_of_words(words + k * tight, tight);
    n.approx[static_cast<int>(k)] = static_cast<double>(n.leading.high[k]) * 0x1p-62;
  }
  return find_or_add(n);
}

Sign SightlineTable::exact_eye_side(PlaneId p) const {
  const PlaneRow row(*planes_, p);
  return decide(value_bits(row, exact_eye_), [&](auto width) -> Sign {
    constexpr int W = width();
    return sign_of<W>(value_at<W, W>(row, exact_eye_));
  });
}

Sign SightlineTable::exact_order(SightlineId a, SightlineId b, SightlineId c) {
  // Short numbers are multiplied sooner than looked up.
  if (line_[a].bits + line_[b].bits + line_[c].bits <= 3 * word_bits) return compute_order(a, b, c);
  Sign turn = 1;
  const auto sort = [&](SightlineId& i, SightlineId& j) {
    if (i < j) return;
    std::swap(i, j);
    turn = -turn;
  };
  sort(a, b);
  sort(b, c);
  sort(a, b);
  constexpr unsigned index_bits = 10;
  if (told_.empty()) told_.resize(std::size_t{1} << index_bits, {none, none, none, 0, 0});
  Told& told = told_[((a * 0x9e3779b1u ^ b) * 0x85ebca6bu ^ c) * 0x9e3779b1u >> (32 - index_bits)];
  if (told.a == a && told.b == b && told.c == c && told.stamp == stamp_) {
    ++tally().identity;
  } else {
    told = {a, b, c, stamp_, compute_order(a, b, c)};
  }
  return turn * told.sign;
}

Sign SightlineTable::compute_order(SightlineId a, SightlineId b, SightlineId c) const {
  const Line *x = &line_[a], *y = &line_[b], *z = &line_[c];
  if (x->bits + y->bits + z->bits > 3 * word_bits) {
    const LeadingBits first = leading(a), second = leading(b), third = leading(c);
    Sign sign = leading_order_short(first, second, third);
    if (sign == uncertain) sign = leading_order(first, second, third);
    if (sign != uncertain) {
      ++tally().filter;
      return sign;
    }
  }
  // In turn until the longest is last, which leaves the determinant as it is.
  while (z->bits < x->bits || z->bits < y->bits) {
    const Line* const first = x;
    x = y;
    y = z;
    z = first;
  }
  const int shorter = static_cast<int>(std::max(x->bits, y->bits)), longest = static_cast<int>(z->bits);
  const auto at = [&]<int N>(Words<N>, const Line* l) {
    return load3<N>(words_.data() + l->first, words_for(l->bits));
  };
  // Six terms of three components.
  return decide(static_cast<int>(x->bits + y->bits + z->bits) + 3, [&](auto width) -> Sign {
    constexpr int W = width();
    const auto value = [&]<int N, int M>(Words<N> n, Words<M> m) -> Sign {
      return sign_of<W>(det3<W, N, M>(at(n, x), at(n, y), at(m, z)));
    };
    // Three lines of one kind have a third of the result each; two of points and one of planes 2:2:5, one and two
    // 2:5:5.
    constexpr int third = (W + 2) / 3, quarter = (W + 3) / 4, rest = W - quarter, half = (W + 1) / 2;
    if constexpr (W > 1) {
      if (longest < 64 * third) return value(Words<third>{}, Words<third>{});
      if (shorter < 64 * quarter && longest < 64 * rest) return value(Words<quarter>{}, Words<rest>{});
      if (longest < 64 * half) return value(Words<half>{}, Words<half>{});
    }
    return value(Words<W>{}, Words<W>{});
  });
}

Sign SightlineTable::exact_side(SightlineRef a, PointId p) const {
  const ExactEye& e = exact_eye_;
  const Line& line = line_[a.id];
  const auto bits = static_cast<int>(line.bits);
  if (e.difference_bits > static_cast<int>(word_bits) && e.difference_bits <= static_cast<int>(leading_bits)) {
    const Wide3<2> difference = from_eye<2>(planes_->points(), p, e);
    std::int64_t word[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const __int128 c = fixed_detail::to_int128(difference[k]);
      word[k] = static_cast<std::int64_t>(c >> (e.difference_bits - static_cast<int>(word_bits)));
    }
    const Sign sign = leading_dot(leading(a.id).high, word);
    if (sign != uncertain) {
      ++tally().filter;
      return a.sign * sign;
    }
  }
  return a.sign * decide(bits + e.difference_bits + 2, [&](auto width) -> Sign {
           constexpr int W = width();
           return narrowed<W>(bits, e.difference_bits, [&]<int N, int M>(Words<N>, Words<M>) -> Sign {
             const Wide3<N> normal = load3<N>(words_.data() + line.first, words_for(line.bits));
             return sign_of<W>(dot<W, N, M>(normal, from_eye<M>(planes_->points(), p, e)));
           });
         });
}

bool SightlineTable::is_eye(PointId p) const {
  // Both approximations are the same function of the exact value: if they differ, so do the points.
  if (planes_->points().approx(p) != exact_eye_.approx) return false;
  return at_width(exact_eye_.difference_bits, [&](auto width) {
    constexpr int W = width();
    const Wide3<W> d = from_eye<W>(planes_->points(), p, exact_eye_);
    return sign_of<W>(d[0]) == 0 && sign_of<W>(d[1]) == 0 && sign_of<W>(d[2]) == 0;
  });
}

}  // namespace sightline
