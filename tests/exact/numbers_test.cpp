// Fixed-width integers, words and rounding against GMP.
#include "support.hpp"

#include "exact/gcd.hpp"
#include "exact/limbs.hpp"
#include "exact/quotient.hpp"
#include "exact/rounding.hpp"
#include "exact/wide.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sightline::test {
namespace {

// A random integer of at most `bits` bits; long runs of equal bits and the extremes are common.
Integer random_integer(Random& random, int bits) {
  Integer r = 0;
  const int length = below(random, bits + 1);
  for (int i = 0; i < length;) {
    const int run = std::min(length - i, 1 + below(random, below(random, 2) == 0 ? 70 : 3));
    const Integer ones = (Integer(1) << static_cast<unsigned>(run)) - 1;
    r = (r << static_cast<unsigned>(run)) + (below(random, 2) == 0 ? Integer(0) : ones);
    i += run;
  }
  return below(random, 2) == 0 ? r : Integer(-r);
}

template <int W>
Fixed<W> fixed(const Integer& x) {
  Fixed<W> r;
  store_words(x, r.word, W);
  return r;
}
template <int W>
Integer integer(const Fixed<W>& x) {
  return load_integer(x.word, W);
}

template <int N, int M, int R>
void check_width(Random& random) {
  const Integer a = random_integer(random, 64 * N - 1), b = random_integer(random, 64 * M - 1);
  ASSERT_EQ(integer(fixed<N>(a)), a);
  // Modulo 2^(64 R), as a two's complement number.
  Integer expected = a * b;
  mpz_fdiv_r_2exp(expected.get_mpz_t(), expected.get_mpz_t(), 64 * R);
  if (mpz_tstbit(expected.get_mpz_t(), 64 * R - 1) != 0) expected -= Integer(1) << (64 * R);
  ASSERT_EQ((integer(multiply<R>(fixed<N>(a), fixed<M>(b)))), expected) << a << " * " << b;
  const Integer c = random_integer(random, 64 * N - 2), d = random_integer(random, 64 * N - 2);
  ASSERT_EQ(integer(fixed<N>(c) + fixed<N>(d)), c + d);
  ASSERT_EQ(integer(fixed<N>(c) - fixed<N>(d)), c - d);
  ASSERT_EQ(integer(-fixed<N>(c)), -c);
  ASSERT_EQ(sign(fixed<N>(a)), sgn(a));
  ASSERT_EQ(integer(resize<N + 2>(fixed<N>(a))), a);
  const int shift = below(random, 64 * N);
  const Integer e = random_integer(random, 64 * N - 1 - shift);
  ASSERT_EQ(integer(shift_left(fixed<N>(e), shift)), shifted(e, shift));
}

TEST(Fixed, AgreesWithGmp) {
  Random random(1);
  for (long i = 0; i < cases(3000); ++i) {
    check_width<1, 1, 1>(random);
    check_width<1, 1, 2>(random);
    check_width<1, 2, 3>(random);
    check_width<2, 1, 2>(random);
    check_width<2, 2, 2>(random);
    check_width<2, 2, 4>(random);
    check_width<2, 2, 6>(random);
    check_width<3, 3, 4>(random);
    check_width<4, 2, 6>(random);
    check_width<4, 4, 8>(random);
    check_width<6, 2, 8>(random);
    check_width<8, 4, 12>(random);
    check_width<12, 8, 12>(random);
    check_width<6, 10, 16>(random);
    check_width<14, 14, 16>(random);
  }
}

// Law of rounding.hpp: the nearest double is a fixed point, symmetric, and scales with powers of two.
RC_GTEST_PROP(Rounding, Law1DyadicsAreFixedPoints, (double x)) {
  RC_PRE(std::isfinite(x));
  const Dyadic d = dyadic(x);
  RC_ASSERT(nearest_double(Integer(d.mantissa), d.exponent) == x);
  RC_ASSERT((d.mantissa == 0) == (x == 0));
  RC_ASSERT(x == 0 || d.mantissa % 2 != 0);
}

RC_GTEST_PROP(Rounding, Law2NeighboursAreFarther, (std::uint64_t seed)) {
  Random random(seed);
  const Integer n = random_integer(random, 300);
  Integer d = random_integer(random, 300);
  if (d == 0) d = 1;
  const double x = nearest_double(n, d);
  RC_ASSERT(nearest_double(Integer(-n), d) == -x);
  const mpq_class truth(sgn(d) < 0 ? Integer(-n) : n, abs(d));
  for (const double to : {-INFINITY, INFINITY}) {
    const mpq_class near = abs(mpq_class(x) - truth), far = abs(mpq_class(std::nextafter(x, to)) - truth);
    RC_ASSERT(near <= far);
    RC_ASSERT(near < far || (std::bit_cast<std::uint64_t>(x) & 1u) == 0);
  }
}

RC_GTEST_PROP(Rounding, Law3NearestIntegerTiesToEven, (std::uint64_t seed)) {
  Random random(seed);
  const Integer n = random_integer(random, 100), d = 1 + abs(random_integer(random, 30));
  const Integer q = nearest_integer(n, d), off = abs(Integer(2 * (n - q * d)));
  RC_ASSERT(off < d || (off == d && mpz_even_p(q.get_mpz_t()) != 0));
}

TEST(Rounding, EndsOfTheRange) {
  const double least = 0x1p-1074;
  EXPECT_EQ(nearest_double(Integer(1), -1074), least);
  EXPECT_EQ(nearest_double(Integer(1), -1075), 0.0);  // a tie: to even
  EXPECT_EQ(nearest_double(Integer(3), -1076), least);
  EXPECT_EQ(nearest_double(Integer(3), -1075), 2 * least);
  EXPECT_EQ(nearest_double(Integer(1), -3000), 0.0);
  EXPECT_EQ(nearest_double(Integer(-1), 1024), -INFINITY);
  EXPECT_EQ(nearest_double(Integer(1), 1023), 0x1p1023);
}

TEST(Quotient, CertifiedQuotientsAreTheNearest) {
  Random random(2);
  for (long i = 0; i < cases(20000); ++i) {
    Integer n = random_integer(random, 500), d = random_integer(random, 500);
    if (d == 0) d = 1;
    switch (below(random, 4)) {
      case 0:
        n = d * random_integer(random, 5);
        break;  // whole
      case 1:
        n = d * ((random_integer(random, 3) << 53) + 1);
        break;  // ties and doubles
      case 2:
        n = d * ((random_integer(random, 3) << 54) + 2) + below(random, 3) - 1;
        break;
      default:
        break;
    }
    const double expected = nearest_double(n, d);
    ASSERT_EQ((nearest_quotient<16>(fixed<16>(n), fixed<16>(d))), expected) << n << " / " << d;
    ASSERT_EQ(nearest_quotient<0>(n, d), expected);
  }
}

TEST(Words, RoundTripBitsAndDoubles) {
  Random random(3);
  for (long i = 0; i < cases(20000); ++i) {
    const Integer x = random_integer(random, 400);
    std::array<std::uint64_t, 9> words{};
    const std::uint32_t bits = magnitude_bits(x);
    const std::uint32_t count = words_for(bits) + static_cast<std::uint32_t>(below(random, 3));
    store_words(x, words.data(), count);
    ASSERT_EQ(load_integer(words.data(), count), x);
    ASSERT_EQ(magnitude_bits(words.data(), count), bits);
    ASSERT_EQ(sign_of_words(words.data(), count), sgn(x));
    const int exponent = below(random, 100) - 500;
    ASSERT_EQ(words_to_double(words.data(), count, exponent), nearest_double(x, exponent)) << x;
    LimbStore store;
    ASSERT_EQ(store.integer(store.add(x)), x);
    ASSERT_EQ(store[0].bits, bits);
  }
}

TEST(Gcd, AgreesWithGmp) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const Integer common = abs(random_integer(random, 30));
    const Integer a = abs(random_integer(random, 33)) * common, b = abs(random_integer(random, 33)) * common;
    ASSERT_EQ(Integer(gcd_of(std::uint64_t{a.get_ui()}, std::uint64_t{b.get_ui()})), gcd(a, b));
    const Integer c = a << 40, d = b * random_integer(random, 50);
    const auto wide = [](const Integer& x) {
      const Fixed<2> f = fixed<2>(abs(x));
      return static_cast<UInt128>(fixed_detail::to_int128(f));
    };
    const Fixed<2> g = fixed_detail::from_int128(static_cast<__int128>(gcd_of(wide(c), wide(d))));
    ASSERT_EQ(integer(g), gcd(c, d));
  }
}

}  // namespace
}  // namespace sightline::test
