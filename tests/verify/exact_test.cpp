// The exact numbers that everything rests on.
#include "verify/exact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace sightline::verify {
namespace {

TEST(Exact, QuotientsAreRoundedToTheNearestDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    // Doubles a and b are integers here, so a / b in doubles is the nearest double by IEEE 754.
    const auto a = static_cast<double>(random() >> (11 + random() % 40)), b = static_cast<double>((random() >> 11) + 1);
    ASSERT_EQ(nearest_double(Integer(a), Integer(b)), a / b);
    ASSERT_EQ(nearest_double(Integer(-a), Integer(b)), -a / b);
    ASSERT_NEAR(rough_ratio(Integer(a), Integer(b)), a / b, a / b * 0x1p-50);
  }
}

TEST(Exact, TiesGoToEvenAndJustBesideThemTheRightWay) {
  const Integer two53 = Integer(1) << 53, far = Integer(1) << 300;
  EXPECT_EQ(nearest_double(two53 + 1, 1), 0x1p53);
  EXPECT_EQ(nearest_double(two53 + 3, 1), 0x1p53 + 4);
  EXPECT_EQ(nearest_double((two53 + 1) * far + 1, far), 0x1p53 + 2);
  EXPECT_EQ(nearest_double((two53 + 1) * far - 1, far), 0x1p53);
}

TEST(Exact, FractionsOfDoubles) {
  for (const double x : {0.0, 1.0, -0.75, 0.1, 1e300, -1e-300, 5e-324, 12345.678}) {
    const unsigned bits = fraction_bits(x);
    EXPECT_EQ(Rational(scaled_integer(x, bits)) / Rational(Integer(1) << bits), Rational(x)) << x;
    EXPECT_TRUE(bits == 0 || mpz_odd_p(scaled_integer(x, bits).get_mpz_t())) << x;
  }
}

TEST(Exact, Decimals) {
  EXPECT_EQ(parse_decimal("1e-3"), Rational(1, 1000));
  EXPECT_EQ(parse_decimal("0.25"), Rational(1, 4));
  EXPECT_EQ(parse_decimal("-12.5E1"), Rational(-125));
  EXPECT_EQ(parse_decimal(".5"), Rational(1, 2));
  for (const char* bad : {"", "e3", "1e", "1e 3", "1.2.3", "0x1", "nan", "1 ", " 1", "1e999999"}) {
    EXPECT_THROW(parse_decimal(bad), std::invalid_argument) << bad;
  }
}

TEST(Exact, MultiplesRoundTiesToEven) {
  const Rational quarter(1, 4);
  EXPECT_EQ(nearest_multiple(0.125, quarter), 0);
  EXPECT_EQ(nearest_multiple(0.375, quarter), 2);
  EXPECT_EQ(nearest_multiple(-0.125, quarter), 0);
  EXPECT_EQ(nearest_multiple(-0.375, quarter), -2);
  EXPECT_EQ(nearest_multiple(-0.626, quarter), -3);
  EXPECT_EQ(nearest_multiple(0.3, parse_decimal("0.1")), 3);
  // 0.15 as a double lies a little below 15 / 100.
  EXPECT_EQ(nearest_multiple(0.15, parse_decimal("0.1")), 1);
}

}  // namespace
}  // namespace sightline::verify
