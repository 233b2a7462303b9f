// Exact integers in triples, and the way from them to doubles.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <string>

namespace sightline::verify {

using Integer = mpz_class;
using Rational = mpq_class;

/// A vector or a covector.
struct Triple {
  Integer x, y, z;
  bool is_zero() const { return x == 0 && y == 0 && z == 0; }
};

Triple operator-(const Triple& a, const Triple& b);
Triple operator+(const Triple& a, const Triple& b);
Triple operator*(const Integer& k, const Triple& a);
void negate(Triple& a);
Triple cross(const Triple& a, const Triple& b);
Integer dot(const Triple& a, const Triple& b);
/// Sign of dot(a, b), without an allocation once warm.
int sign_dot(const Triple& a, const Triple& b);
/// Sign of a*b - c*d.
int sign_difference(const Integer& a, const Integer& b, const Integer& c, const Integer& d);
/// a << bits, or a itself where bits is 0.
Triple shifted(const Triple& a, unsigned bits);

/// num/den (den > 0) to the nearest double, ties to even.
double nearest_double(const Integer& num, const Integer& den);
/// num/den with a relative error below 2^-50; quicker.
double rough_ratio(const Integer& num, const Integer& den);
/// num/den * 2^shift with a relative error below 2^-50; infinite or zero where the exponent is out of range.
double rough_ratio(const Integer& num, const Integer& den, long shift);
/// a * 2^shift, truncated: relative error below 2^-52.
double rough(const Integer& a, long shift);

/// The smallest e >= 0 for which x * 2^e is an integer (x finite).
unsigned fraction_bits(double x);
/// x * 2^bits, which must be an integer.
Integer scaled_integer(double x, unsigned bits);
/// A decimal such as 12, 0.25, 1e-6. Throws std::invalid_argument where `text` is none.
Rational parse_decimal(const std::string& text);
/// The integer nearest to x / unit, ties to even.
Integer nearest_multiple(double x, const Rational& unit);

}  // namespace sightline::verify
