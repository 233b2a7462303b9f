// Exactness starts in the reader: std::from_chars must give the double nearest to the decimal. Checked on cases made to
// be hard, against MPFR and against the exact rational.
#include "support.hpp"

#include "exact/rounding.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>
#include <charconv>
#include <string>

namespace sightline::test {
namespace {

double by_from_chars(const std::string& s) {
  double x = 0;
  const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), x);
  if (error == std::errc::result_out_of_range) return std::strtod(s.c_str(), nullptr);
  EXPECT_EQ(end, s.data() + s.size()) << s;
  return x;
}

double by_mpfr(const std::string& s) {
  mpfr_set_emin(-1073);  // the range of doubles: rounded once, subnormal numbers too
  mpfr_set_emax(1024);
  mpfr_t x;
  mpfr_init2(x, 53);
  const int inexact = mpfr_strtofr(x, s.c_str(), nullptr, 10, MPFR_RNDN);
  mpfr_subnormalize(x, inexact, MPFR_RNDN);
  const double r = mpfr_get_d(x, MPFR_RNDN);
  mpfr_clear(x);
  return r;
}

// digits * 10^exponent
double by_rational(const Integer& digits, long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? nearest_double(digits, power) : nearest_double(Integer(digits * power), Integer(1));
}

void check(const Integer& digits, long exponent) {
  const std::string s = digits.get_str() + "e" + std::to_string(exponent);
  const double x = by_from_chars(s);
  ASSERT_EQ(x, by_mpfr(s)) << s;
  ASSERT_EQ(x, by_rational(digits, exponent)) << s;
}

TEST(FromChars, RandomDecimals) {
  Random random(5);
  for (long i = 0; i < cases(20000); ++i) {
    const auto digits = random() >> below(random, 64);
    check(Integer(digits), below(random, 660) - 340);
  }
}

// The exact middle between two doubles in all its digits (a tie), and a hair above and below it.
TEST(FromChars, MiddlesBetweenDoubles) {
  Random random(6);
  for (long i = 0; i < cases(2000); ++i) {
    const auto mantissa =
        ((random() >> 12) | (std::uint64_t{1} << 52)) >> (below(random, 8) == 0 ? below(random, 53) : 0);
    const long exponent = below(random, 8) == 0 ? -1074 : below(random, 600) - 400;
    // (2m + 1) 2^(e-1); a negative power of two in decimal: m 2^-k = m 5^k 10^-k.
    Integer middle = 2 * Integer(mantissa) + 1;
    long ten = 0;
    if (exponent - 1 >= 0) {
      middle <<= static_cast<unsigned>(exponent - 1);
    } else {
      Integer five;
      mpz_ui_pow_ui(five.get_mpz_t(), 5, static_cast<unsigned long>(1 - exponent));
      middle *= five;
      ten = exponent - 1;
    }
    check(middle, ten);
    check(Integer(middle * 10 + 1), ten - 1);
    check(Integer(middle * 10 - 1), ten - 1);
  }
}

TEST(FromChars, WellKnownHardOnes) {
  for (const auto& [digits, exponent] : std::vector<std::pair<const char*, long>>{{"22250738585072011", -324},
                                                                                  {"22250738585072014", -324},
                                                                                  {"17976931348623157", 292},
                                                                                  {"17976931348623158", 292},
                                                                                  {"9007199254740993", 0},
                                                                                  {"49406564584124654", -340},
                                                                                  {"24703282292062327", -340},
                                                                                  {"24703282292062328", -340},
                                                                                  {"6929495644600919", -1},
                                                                                  {"69294956446009195", 15},
                                                                                  {"235", -2},
                                                                                  {"1", -1}})
    check(Integer(digits), exponent);
}

}  // namespace
}  // namespace sightline::test
