#include "exact/rounding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sightline {

Dyadic dyadic(double x) {
  if (x == 0) return {};
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
  int exponent = -1074;
  if (biased > 0) {
    mantissa |= std::uint64_t{1} << 52;
    exponent = biased - 1075;
  }
  const int zeros = std::countr_zero(mantissa);
  const auto odd = static_cast<std::int64_t>(mantissa >> zeros);
  return {x < 0 ? -odd : odd, exponent + zeros};
}

Integer shifted(const Integer& x, int shift) {
  Integer r;
  mpz_mul_2exp(r.get_mpz_t(), x.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
  return r;
}

Integer nearest_integer(const Integer& numerator, const Integer& denominator) {
  Integer quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  const int half = cmp(Integer(2 * remainder), denominator);
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0)) ++quotient;
  return quotient;
}

double nearest_double(const Integer& numerator, const Integer& denominator) {
  if (numerator == 0) return 0;
  const bool negative = sgn(numerator) * sgn(denominator) < 0;
  const auto length = [](const Integer& x) { return static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  // The quotient times 2^shift has 55 or 56 bits before the point: two or more below the last of the double.
  const int shift = 55 - (length(numerator) - length(denominator));
  Integer n = abs(numerator), d = abs(denominator);
  (shift >= 0 ? n : d) <<= static_cast<mp_bitcnt_t>(std::abs(shift));
  Integer quotient, remainder;
  mpz_tdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  const int drop = std::max(length(quotient) - 53, shift - 1074);  // bits below the double's last place, 2 or more
  if (drop > 60) return negative ? -0.0 : 0.0;                     // below a quarter of the smallest double
  const std::uint64_t q = mpz_get_ui(quotient.get_mpz_t());
  std::uint64_t kept = q >> drop;
  const std::uint64_t below = q & ((std::uint64_t{1} << drop) - 1), half = std::uint64_t{1} << (drop - 1);
  if (below > half || (below == half && (remainder != 0 || kept % 2 == 1))) ++kept;
  const double r = std::ldexp(static_cast<double>(kept), drop - shift);
  return negative ? -r : r;
}

double nearest_double(const Integer& x, int exponent) {
  return exponent >= 0 ? nearest_double(shifted(x, exponent), Integer(1))
                       : nearest_double(x, shifted(Integer(1), -exponent));
}

}  // namespace sightline
