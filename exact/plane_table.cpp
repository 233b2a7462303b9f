#include "exact/plane_table.hpp"

#include "exact/gcd.hpp"
#include "exact/wide.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace sightline {
namespace {

std::uint64_t mix(std::uint64_t h, std::uint64_t x) {
  h ^= x;
  h *= 0x9e3779b97f4a7c15u;
  return h ^ (h >> 29);
}

constexpr int two_words = 124;  // bits of coordinates whose differences, planes and walls `canonical` can take

/// A plane as intern_words takes it: its normal without common divisors and with the sign of its first component, and
/// the offset.
struct Canonical {
  std::array<std::uint64_t, 3 * 4 + 6> words;
  std::uint32_t normal_bits = 0, offset_bits = 0;
  bool flipped = false;
};

/// x / 2^shift of a number that is not negative; shift >= 0.
template <int N>
Fixed<N> shift_right(const Fixed<N>& x, int shift) {
  Fixed<N> r;
  const int words = shift / 64, bits = shift % 64;
  for (int i = 0; i < N; ++i) {
    const std::uint64_t low = i + words < N ? x.word[i + words] : 0;
    const std::uint64_t high = i + words + 1 < N ? x.word[i + words + 1] : 0;
    r.word[i] = bits == 0 ? low : (low >> bits) | (high << (64 - bits));
  }
  return r;
}

/// The highest power of two that divides all three, not all zero: its exponent.
template <int N>
int common_twos(const Wide3<N>& m) {
  for (int i = 0; i < N; ++i) {
    const std::uint64_t any = m[0].word[i] | m[1].word[i] | m[2].word[i];
    if (any != 0) return 64 * i + std::countr_zero(any);
  }
  return 0;
}

/// Of a normal of N words and a point of the plane in two. None if the normal is zero.
template <int N>
std::optional<Canonical> canonical(const Wide3<N>& n, const Wide3<2>& p) {
  static_assert(std::is_same_v<mp_limb_t, std::uint64_t>);
  const std::array<Sign, 3> s{sign(n[0]), sign(n[1]), sign(n[2])};
  const Sign leading = s[0] != 0 ? s[0] : s[1] != 0 ? s[1] : s[2];
  if (leading == 0) return std::nullopt;
  Wide3<N> m;
  mpz_t view[3];
  for (std::size_t k = 0; k < 3; ++k) m[k] = s[k] < 0 ? -n[k] : n[k];
  // Most divisors are powers of two, for which there is no need to divide.
  if (const int twos = common_twos<N>(m); twos > 0) {
    for (auto& x : m) x = shift_right(x, twos);
  }
  for (std::size_t k = 0; k < 3; ++k) mpz_roinit_n(view[k], m[k].word, N);
  // These keep their room: to ask for it anew takes longer than the rest.
  thread_local Integer divisor, quotient;
  mpz_gcd(divisor.get_mpz_t(), view[0], view[1]);
  mpz_gcd(divisor.get_mpz_t(), divisor.get_mpz_t(), view[2]);
  if (divisor != 1) {
    for (std::size_t k = 0; k < 3; ++k) {
      mpz_divexact(quotient.get_mpz_t(), view[k], divisor.get_mpz_t());
      store_words(quotient, m[k].word, N);
    }
  }
  Canonical made;
  made.flipped = leading < 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (s[k] == -leading) m[k] = -m[k];
    made.normal_bits = std::max(made.normal_bits, magnitude_bits(m[k].word, N));
  }
  const std::uint32_t stride = words_for(made.normal_bits);
  for (std::size_t k = 0; k < 3; ++k) std::copy(m[k].word, m[k].word + stride, made.words.data() + k * stride);
  // What divides a normal divides its product with a point.
  const Fixed<N + 2> offset = dot<N + 2, N, 2>(m, p);
  made.offset_bits = magnitude_bits(offset.word, N + 2);
  std::copy(offset.word, offset.word + words_for(made.offset_bits), made.words.data() + std::size_t{3} * stride);
  return made;
}

}  // namespace

PlaneTable::Interned PlaneTable::add_points(PointId a, PointId b, PointId c) {
  const PlaneSource source{PlaneSource::points, a, b, c};
  const int bits = points_->bits();
  const std::uint64_t *const p = points_->words(a), *const q = points_->words(b), *const r = points_->words(c);
  // Differences have B + 1 bits, n 2B + 3, d = n.p 3B + 5: 61 and 92 for B = 29, 123 and 185 for B = 60, 251 and 377
  // for B = 124.
  const auto normal = [&]<int N, int M>() {
    const std::uint32_t stride = points_->stride();
    Wide3<N> u, v;
    for (std::uint32_t k = 0; k < 3; ++k) {
      u[k] = load<N>(q + k * stride, stride) - load<N>(p + k * stride, stride);
      v[k] = load<N>(r + k * stride, stride) - load<N>(p + k * stride, stride);
    }
    return cross<M, N>(u, v);
  };
  // A normal along an axis needs no division: the plane is coordinate = p's.
  const auto along_axis = [&](const auto& n) -> std::optional<Interned> {
    const std::array<Sign, 3> s{sign(n[0]), sign(n[1]), sign(n[2])};
    if (std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]) != 1) return std::nullopt;
    const std::size_t k = s[0] != 0 ? 0 : s[1] != 0 ? 1 : 2;
    Wide3<1> axis{};
    axis[k].word[0] = 1;
    Interned made = intern_short(axis, resize<2>(Fixed<1>{{p[k]}}), source);
    made.flipped = s[k] < 0;
    return made;
  };
  if (bits <= 29) {
    const Wide3<1> n = normal.operator()<1, 1>();
    if (const auto made = along_axis(n)) return *made;
    return intern_short(n, dot<2, 1, 1>(n, load3<1>(p, 1)), source);
  }
  if (bits <= 60) {
    const Wide3<2> n = normal.operator()<1, 2>();
    if (const auto made = along_axis(n)) return *made;
    return intern_short(n, dot<3, 2, 1>(n, load3<1>(p, 1)), source);
  }
  if (bits <= two_words) {
    const auto made = canonical<4>(normal.operator()<2, 4>(), load3<2>(p, points_->stride()));
    if (!made) return {};
    return intern_words(made->words.data(), made->normal_bits, made->offset_bits, made->flipped, source);
  }
  const Wide3<0> n = normal.operator()<0, 0>();
  return intern(n, dot<0, 0, 0>(n, points_->point(a)), source);
}

PlaneTable::Interned PlaneTable::add_axis(int axis, const Integer& value) {
  if (axis < 0 || axis > 2) throw std::invalid_argument("no such axis");
  const PlaneSource source{PlaneSource::axis, static_cast<std::uint32_t>(axis), 0, 0};
  const auto k = static_cast<std::size_t>(axis);
  if (value.fits_slong_p()) {
    Wide3<1> n{};
    n[k].word[0] = 1;
    return intern_short(n, fixed_detail::from_int128(value.get_si()), source);
  }
  std::array<Integer, 3> n{0, 0, 0};
  n[k] = 1;
  return intern(n, value, source);
}

PlaneTable::Interned PlaneTable::add_wall(PointId a, PointId b, int axis) {
  if (axis < 0 || axis > 2) throw std::invalid_argument("no such axis");
  const PlaneSource source{PlaneSource::wall, a, b, static_cast<std::uint32_t>(axis)};
  // (b - a) x e_k: component k+1 is the difference's k+2, component k+2 its negative k+1.
  const auto k = static_cast<std::size_t>(axis), k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  // n has B + 1 bits, d two products of 2B + 1.
  if (points_->bits() <= 60) {
    const Wide3<1> p = load3<1>(points_->words(a), 1), q = load3<1>(points_->words(b), 1);
    Wide3<1> n{};
    n[k1] = q[k2] - p[k2];
    n[k2] = p[k1] - q[k1];
    return intern_short(n, dot<2, 1, 1>(n, p), source);
  }
  if (points_->bits() <= two_words) {
    const std::uint32_t stride = points_->stride();
    const Wide3<2> p = load3<2>(points_->words(a), stride), q = load3<2>(points_->words(b), stride);
    Wide3<2> n{};
    n[k1] = q[k2] - p[k2];
    n[k2] = p[k1] - q[k1];
    const auto made = canonical<2>(n, p);
    if (!made) return {};
    return intern_words(made->words.data(), made->normal_bits, made->offset_bits, made->flipped, source);
  }
  const auto p = points_->point(a), q = points_->point(b);
  Wide3<0> n;
  n[k1] = q[k2] - p[k2];
  n[k2] = p[k1] - q[k1];
  return intern(n, dot<0, 0, 0>(n, p), source);
}

namespace {

UInt128 magnitude(__int128 x) { return x < 0 ? 0 - static_cast<UInt128>(x) : static_cast<UInt128>(x); }
bool leads_negative(__int128 x, __int128 y, __int128 z) { return x != 0 ? x < 0 : y != 0 ? y < 0 : z < 0; }

}  // namespace

// n in one word, d in two: everything stays short.
PlaneTable::Interned PlaneTable::intern_short(const std::array<Fixed<1>, 3>& n, const Fixed<2>& d,
                                              const PlaneSource& source) {
  std::array<std::int64_t, 3> c;
  std::uint64_t divisor = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = static_cast<std::int64_t>(n[k].word[0]);
    divisor = gcd_of(divisor, static_cast<std::uint64_t>(c[k] < 0 ? -c[k] : c[k]));
  }
  if (divisor == 0) return {};
  __int128 offset = fixed_detail::to_int128(d);
  if (divisor > 1) divisor = gcd_of(divisor, static_cast<std::uint64_t>(magnitude(offset) % divisor));
  const bool flipped = leads_negative(c[0], c[1], c[2]);
  const auto by = static_cast<std::int64_t>(divisor) * (flipped ? -1 : 1);
  std::array<std::uint64_t, 5> words;
  std::uint32_t normal_bits = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (by != 1) c[k] /= by;
    normal_bits = std::max(normal_bits, magnitude_bits(c[k]));
    words[k] = static_cast<std::uint64_t>(c[k]);
  }
  if (by != 1) offset = divisor == 1 ? -offset : offset / by;
  const Fixed<2> reduced = fixed_detail::from_int128(offset);
  words[3] = reduced.word[0];
  words[4] = reduced.word[1];
  return intern_words(words.data(), normal_bits, magnitude_bits(words.data() + 3, 2), flipped, source);
}

// n in two words, d in three. Only a divisor of 1, the common case, is dealt with here.
PlaneTable::Interned PlaneTable::intern_short(const std::array<Fixed<2>, 3>& n, const Fixed<3>& d,
                                              const PlaneSource& source) {
  std::array<__int128, 3> c;
  UInt128 divisor = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = fixed_detail::to_int128(n[k]);
    divisor = gcd_of(divisor, magnitude(c[k]));
  }
  if (divisor == 0) return {};
  const bool flipped = leads_negative(c[0], c[1], c[2]);
  if (divisor != 1) {
    std::array<Integer, 3> long_normal;
    for (std::size_t k = 0; k < 3; ++k) long_normal[k] = load_integer(n[k].word, 2);
    return intern(long_normal, load_integer(d.word, 3), source);
  }
  std::uint32_t normal_bits = 0;
  std::array<std::uint64_t, 9> words;
  for (std::size_t k = 0; k < 3; ++k) {
    const Fixed<2> x = flipped ? -n[k] : n[k];
    std::copy(x.word, x.word + 2, words.data() + 2 * k);
    normal_bits = std::max(normal_bits, magnitude_bits(x.word, 2));
  }
  const std::uint32_t stride = words_for(normal_bits);
  for (std::uint32_t k = 1; stride == 1 && k < 3; ++k) words[k] = words[std::size_t{2} * k];
  const Fixed<3> offset = flipped ? -d : d;
  std::copy(offset.word, offset.word + 3, words.data() + std::size_t{3} * stride);
  return intern_words(words.data(), normal_bits, magnitude_bits(offset.word, 3), flipped, source);
}

PlaneTable::Interned PlaneTable::intern(const std::array<Integer, 3>& n, const Integer& d, const PlaneSource& source) {
  Integer divisor = gcd(gcd(n[0], n[1]), n[2]);
  if (divisor == 0) return {};
  divisor = gcd(divisor, d);
  const bool flipped = sgn(n[0]) != 0 ? sgn(n[0]) < 0 : sgn(n[1]) != 0 ? sgn(n[1]) < 0 : sgn(n[2]) < 0;
  if (flipped) divisor = -divisor;
  std::array<Integer, 4> canonical{n[0] / divisor, n[1] / divisor, n[2] / divisor, d / divisor};
  std::uint32_t normal_bits = 0;
  for (std::size_t k = 0; k < 3; ++k) normal_bits = std::max(normal_bits, magnitude_bits(canonical[k]));
  const std::uint32_t offset_bits = magnitude_bits(canonical[3]);
  const std::uint32_t stride = words_for(normal_bits);
  std::vector<std::uint64_t> words(3 * stride + words_for(offset_bits));
  for (std::uint32_t k = 0; k < 3; ++k) store_words(canonical[k], words.data() + k * stride, stride);
  store_words(canonical[3], words.data() + 3 * stride, words_for(offset_bits));
  return intern_words(words.data(), normal_bits, offset_bits, flipped, source);
}

PlaneTable::Interned PlaneTable::intern_words(const std::uint64_t* words, std::uint32_t normal_bits,
                                              std::uint32_t offset_bits, bool flipped, const PlaneSource& source) {
  const std::uint32_t stride = words_for(normal_bits), count = 3 * stride + words_for(offset_bits);
  std::uint64_t hash = mix(normal_bits, offset_bits);
  for (std::uint32_t i = 0; i < count; ++i) hash = mix(hash, words[i]);
  if (2 * (record_.size() + 1) > index_.size()) grow_index();
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = hash & mask;
  for (; index_[slot] != none; slot = (slot + 1) & mask) {
    const PlaneId id = index_[slot];
    const Record& r = record_[id];
    if (r.hash == hash && r.normal_bits == normal_bits && r.offset_bits == offset_bits &&
        std::equal(words, words + count, words_.data() + r.first))
      return {id, flipped};
  }
  const PlaneId id = size();
  index_[slot] = id;
  record_.push_back({hash, words_.size(), normal_bits, offset_bits});
  words_.insert(words_.end(), words, words + count);
  source_.push_back(source);
  // All four numbers times 2^-normal_bits; the offset's unit is the grid's, n.u = d 2^-unit_bits.
  const int scale = -static_cast<int>(normal_bits);
  ApproxPlane approx{};
  int nonzero = 0, last = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    approx.n[k] = words_to_double(words + k * stride, stride, scale);
    if (sign_of_words(words + k * stride, stride) != 0) {
      ++nonzero;
      last = static_cast<int>(k);
    }
  }
  approx.d = words_to_double(words + 3 * stride, words_for(offset_bits), scale - points_->grid().unit_bits());
  approx_.push_back(approx);
  axis_.push_back(static_cast<std::int8_t>(nonzero == 1 && normal_bits == 1 ? last : -1));
  return {id, flipped};
}

void PlaneTable::grow_index() {
  index_.assign(std::max<std::size_t>(64, 2 * index_.size()), none);
  const std::size_t mask = index_.size() - 1;
  for (PlaneId id = 0; id < record_.size(); ++id) {
    std::size_t slot = record_[id].hash & mask;
    while (index_[slot] != none) slot = (slot + 1) & mask;
    index_[slot] = id;
  }
}

Limbs PlaneTable::component(PlaneId p, int k) const {
  const Record& r = record_[p];
  const std::uint32_t stride = words_for(r.normal_bits);
  const std::uint64_t* const w = words_.data() + r.first + static_cast<std::uint32_t>(k) * stride;
  const std::uint32_t count = k < 3 ? stride : words_for(r.offset_bits);
  return {w, count, magnitude_bits(w, count)};
}

Integer PlaneTable::integer(PlaneId p, int k) const {
  const Limbs l = component(p, k);
  return load_integer(l.words, l.count);
}

}  // namespace sightline
