// A fused multiply-add gives the product that Dekker's way gives: maps are the same on every processor.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "visibility_map/stitch_twofold.hpp"

namespace sightline::stitching {
namespace {

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("fma")]] Twofold fused_product(double a, double b) { return two_product<true>(a, b); }
bool has_fused() { return __builtin_cpu_supports("fma"); }
#else
Twofold fused_product(double a, double b) { return two_product<true>(a, b); }
bool has_fused() { return true; }
#endif

TEST(Twofold, FusedProductsAreThoseOfHalves) {
  if (!has_fused()) GTEST_SKIP() << "this processor has no fused multiply-add";
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-200, 200);
  const auto number = [&](int k) {
    if (k % 4 == 0) return std::ldexp(std::round(mantissa(random) * 0x1p20), exponent(random));  // short ones
    return std::ldexp(mantissa(random), exponent(random));
  };
  int inexact = 0;
  for (int k = 0; k < 100'000; ++k) {
    const double a = number(k), b = number(k / 4);
    const Twofold plain = two_product(a, b), fused = fused_product(a, b);
    ASSERT_EQ(plain.high, fused.high) << a << " " << b;
    ASSERT_EQ(plain.low, fused.low) << a << " " << b;
    inexact += plain.low != 0;
  }
  EXPECT_GT(inexact, 50'000);
}

}  // namespace
}  // namespace sightline::stitching
