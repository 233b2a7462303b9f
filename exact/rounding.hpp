// From doubles to integers and back, correctly rounded.
//
// Laws. 1: a dyadic goes back to its double. 2: no double is nearer than nearest_double, and ties go to even; it is odd
// in its argument. 3: nearest_integer is within 1/2, and even on ties.
#pragma once

#include "exact/types.hpp"

namespace sightline {

/// A finite double as mantissa * 2^exponent with an odd mantissa; zero is 0 * 2^0.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};
Dyadic dyadic(double x);

/// x * 2^exponent to the nearest double, ties to even; infinite beyond the largest.
double nearest_double(const Integer& x, int exponent);
/// numerator / denominator to the nearest double, ties to even; denominator not zero.
double nearest_double(const Integer& numerator, const Integer& denominator);
/// numerator / denominator to the nearest integer, ties to even; denominator positive.
Integer nearest_integer(const Integer& numerator, const Integer& denominator);
/// x * 2^shift; shift >= 0.
Integer shifted(const Integer& x, int shift);

}  // namespace sightline
