#include "verify/exact.hpp"

#include <cmath>
#include <stdexcept>

namespace sightline::verify {

Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Triple operator*(const Integer& k, const Triple& a) { return {k * a.x, k * a.y, k * a.z}; }

void negate(Triple& a) {
  mpz_neg(a.x.get_mpz_t(), a.x.get_mpz_t());
  mpz_neg(a.y.get_mpz_t(), a.y.get_mpz_t());
  mpz_neg(a.z.get_mpz_t(), a.z.get_mpz_t());
}

namespace {

/// out = a*b - c*d
void difference(Integer& out, const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  mpz_mul(out.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  mpz_submul(out.get_mpz_t(), c.get_mpz_t(), d.get_mpz_t());
}

void dot(Integer& out, const Triple& a, const Triple& b) {
  mpz_mul(out.get_mpz_t(), a.x.get_mpz_t(), b.x.get_mpz_t());
  mpz_addmul(out.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
  mpz_addmul(out.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
}

}  // namespace

Triple cross(const Triple& a, const Triple& b) {
  Triple out;
  difference(out.x, a.y, b.z, a.z, b.y);
  difference(out.y, a.z, b.x, a.x, b.z);
  difference(out.z, a.x, b.y, a.y, b.x);
  return out;
}

Integer dot(const Triple& a, const Triple& b) {
  Integer out;
  dot(out, a, b);
  return out;
}

int sign_dot(const Triple& a, const Triple& b) {
  thread_local Integer scratch;
  dot(scratch, a, b);
  return sgn(scratch);
}

int sign_difference(const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  thread_local Integer scratch;
  difference(scratch, a, b, c, d);
  return sgn(scratch);
}

Triple shifted(const Triple& a, unsigned bits) {
  if (bits == 0) return a;
  return {a.x << bits, a.y << bits, a.z << bits};
}

double nearest_double(const Integer& num, const Integer& den) {
  if (num == 0) return 0;
  // The quotient gets at least 55 bits, and its last bit is set where something is left over: rounding that integer
  // to a double rounds the fraction, since the last bit is never the one on which a tie hangs.
  const long shift = 56 + static_cast<long>(mpz_sizeinbase(den.get_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(num.get_mpz_t(), 2));
  Integer top = abs(num), bottom = den, quotient, rest;
  if (shift >= 0) {
    top <<= static_cast<unsigned long>(shift);
  } else {
    bottom <<= static_cast<unsigned long>(-shift);
  }
  mpz_tdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), top.get_mpz_t(), bottom.get_mpz_t());
  std::uint64_t bits = mpz_get_ui(quotient.get_mpz_t());
  if (rest != 0) bits |= 1;
  const double magnitude = std::ldexp(static_cast<double>(bits), static_cast<int>(-shift));
  return num < 0 ? -magnitude : magnitude;
}

double rough_ratio(const Integer& num, const Integer& den) { return rough_ratio(num, den, 0); }

double rough_ratio(const Integer& num, const Integer& den, long shift) {
  if (num == 0) return 0;
  // Each mantissa is truncated (2^-52 relative), the quotient rounded (2^-53): below 2^-50 in all.
  long top = 0, bottom = 0;
  const double a = mpz_get_d_2exp(&top, num.get_mpz_t()), b = mpz_get_d_2exp(&bottom, den.get_mpz_t());
  const long exponent = top - bottom + shift;
  if (exponent > 1100) return a / b * HUGE_VAL;
  if (exponent < -1200) return 0;
  return std::ldexp(a / b, static_cast<int>(exponent));
}

double rough(const Integer& a, long shift) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, a.get_mpz_t());
  if (mantissa == 0) return 0;
  exponent += shift;
  if (exponent > 1100) return mantissa * HUGE_VAL;
  if (exponent < -1200) return 0;
  return std::ldexp(mantissa, static_cast<int>(exponent));
}

unsigned fraction_bits(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int low = exponent - 53 + __builtin_ctzll(static_cast<std::uint64_t>(mantissa));
  return low < 0 ? static_cast<unsigned>(-low) : 0;
}

Integer scaled_integer(double x, unsigned bits) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
  const long shift = static_cast<long>(exponent) - 53 + static_cast<long>(bits);
  Integer out(mantissa);
  if (shift >= 0) {
    out <<= static_cast<unsigned long>(shift);
  } else {
    mpz_tdiv_q_2exp(out.get_mpz_t(), out.get_mpz_t(), static_cast<unsigned long>(-shift));
  }
  return out;
}

Rational parse_decimal(const std::string& text) {
  const auto refuse = [&] { return std::invalid_argument("'" + text + "' is no decimal number"); };
  std::size_t at = 0;
  const bool negative = at < text.size() && text[at] == '-';
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  std::string digits;
  long exponent = 0;
  bool point = false;
  for (; at < text.size() && (std::isdigit(static_cast<unsigned char>(text[at])) || (text[at] == '.' && !point));
       ++at) {
    if (text[at] == '.') {
      point = true;
    } else {
      digits += text[at];
      if (point) --exponent;
    }
  }
  if (digits.empty()) throw refuse();
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t used = 0;
    const std::string rest = text.substr(at + 1);
    if (rest.empty() || std::isspace(static_cast<unsigned char>(rest[0]))) throw refuse();
    try {
      exponent += std::stol(rest, &used);
    } catch (const std::exception&) {
      throw refuse();
    }
    at += 1 + used;
  }
  if (at != text.size() || exponent > 5000 || exponent < -5000) throw refuse();
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent)));
  Rational value(Integer(digits, 10));
  if (exponent >= 0) {
    value *= power;
  } else {
    value /= power;
  }
  return negative ? Rational(-value) : value;
}

Integer nearest_multiple(double x, const Rational& unit) {
  const Rational ratio = Rational(x) / unit;
  // floor(ratio + 1/2), and one less where a tie went up to an odd number.
  const Rational up = ratio + Rational(1, 2);
  Integer nearest;
  mpz_fdiv_q(nearest.get_mpz_t(), up.get_num_mpz_t(), up.get_den_mpz_t());
  if (up.get_den() == 1 && mpz_odd_p(nearest.get_mpz_t())) nearest -= 1;
  return nearest;
}

}  // namespace sightline::verify
