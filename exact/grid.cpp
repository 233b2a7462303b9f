#include "exact/grid.hpp"

#include "exact/limbs.hpp"
#include "exact/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sightline {
namespace {

void require_finite(const glm::dvec3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    throw std::invalid_argument("a coordinate is not finite");
}

// The coordinate in steps of 2^exponent; it is a multiple of them.
Integer in_steps(double x, int exponent) {
  const Dyadic d = dyadic(x);
  return d.mantissa == 0 ? Integer(0) : shifted(Integer(d.mantissa), d.exponent - exponent);
}

// The nearest multiple of `unit` to x, as a number of units.
Integer in_units(double x, const mpq_class& unit) {
  const mpq_class quotient = mpq_class(x) / unit;
  return nearest_integer(quotient.get_num(), quotient.get_den());
}

// digits[.digits][e[+-]digits], or .digits; at most 1000 characters and an exponent below 5000.
mpq_class parse_unit(const std::string& text) {
  const auto wrong = [&] { return std::invalid_argument("not a positive decimal: '" + text.substr(0, 60) + "'"); };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (text.size() > 1000) throw wrong();
  std::string digits;
  long exponent = 0;
  std::size_t i = 0;
  for (; i < text.size() && digit(text[i]); ++i) digits += text[i];
  if (i < text.size() && text[i] == '.')
    for (++i; i < text.size() && digit(text[i]); ++i, --exponent) digits += text[i];
  if (digits.empty()) throw wrong();
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    const bool negative = i < text.size() && text[i] == '-';
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    if (i == text.size()) throw wrong();
    long power = 0;
    for (; i < text.size() && digit(text[i]); ++i) power = std::min(power * 10 + (text[i] - '0'), 5000L);
    if (power == 5000) throw wrong();
    exponent += negative ? -power : power;
  }
  if (i != text.size()) throw wrong();
  Integer scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  mpq_class unit =
      exponent < 0 ? mpq_class(Integer(digits, 10), scale) : mpq_class(Integer(Integer(digits, 10) * scale));
  unit.canonicalize();
  if (unit == 0) throw wrong();
  return unit;
}

// The box of the points, axis by axis, and the least exponent among the lowest set bits.
struct Extent {
  glm::dvec3 low{0}, high{0};
  int exponent = 0;
  explicit Extent(std::span<const glm::dvec3> points) {
    if (points.empty()) return;
    low = high = points[0];
    int least = std::numeric_limits<int>::max();
    for (const glm::dvec3& p : points) {
      require_finite(p);
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
        if (p[k] != 0) least = std::min(least, dyadic(p[k]).exponent);
      }
    }
    if (least != std::numeric_limits<int>::max()) exponent = least;
  }
};

struct Framing {
  std::array<Integer, 3> origin;
  int bits, unit_bits;
};

// Origin, B and unit_bits from the extreme coordinates of the points. Every bound is monotone in the coordinates, so
// the extremes tell all.
Framing frame(const std::array<Integer, 3>& low, const std::array<Integer, 3>& high) {
  Framing f{};
  Integer largest = 0, extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    f.origin[k] = nearest_integer(low[k] + high[k], 2);
    largest =
        std::max({largest, Integer(abs(Integer(low[k] - f.origin[k]))), Integer(abs(Integer(high[k] - f.origin[k])))});
    extent = std::max(extent, Integer(high[k] - low[k]));
  }
  f.bits = static_cast<int>(magnitude_bits(largest));
  // The enlarged box reaches to m = largest + max(1, ceil(extent/2)); |unit| <= 1/2 asks for 2m <= 2^unit_bits, that
  // is, unit_bits = the bit length of 2m - 1.
  const Integer half = (extent + 1) / 2;
  const Integer reach = largest + std::max(Integer(1), half);
  f.unit_bits = static_cast<int>(magnitude_bits(Integer(2 * reach - 1)));
  return f;
}

}  // namespace

Grid Grid::covering(std::span<const glm::dvec3> points) {
  const Extent extent(points);
  std::array<Integer, 3> low, high;
  for (int k = 0; k < 3; ++k) {
    low[static_cast<std::size_t>(k)] = in_steps(extent.low[k], extent.exponent);
    high[static_cast<std::size_t>(k)] = in_steps(extent.high[k], extent.exponent);
  }
  const Framing f = frame(low, high);
  Grid grid;
  grid.exponent_ = extent.exponent;
  grid.origin_ = f.origin;
  grid.bits_ = f.bits;
  grid.unit_bits_ = f.unit_bits;
  return grid;
}

Grid Grid::snapped(std::span<const glm::dvec3> points, const std::string& unit) {
  Grid grid;
  grid.unit_ = parse_unit(unit);
  grid.snap_ = unit;
  const Extent extent(points);
  std::array<Integer, 3> low, high;
  for (int k = 0; k < 3; ++k) {
    low[static_cast<std::size_t>(k)] = in_units(extent.low[k], grid.unit_);
    high[static_cast<std::size_t>(k)] = in_units(extent.high[k], grid.unit_);
  }
  const Framing f = frame(low, high);
  grid.origin_ = f.origin;
  grid.bits_ = f.bits;
  grid.unit_bits_ = f.unit_bits;
  return grid;
}

GridPoint Grid::point(const glm::dvec3& world) const {
  GridPoint p;
  point(world, p);
  return p;
}

void Grid::point(const glm::dvec3& world, GridPoint& p) const {
  require_finite(world);
  p.shift = 0;
  if (!snap_.empty()) {
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      p.c[i] = in_units(world[k], unit_) - origin_[i];
    }
    return;
  }
  for (int k = 0; k < 3; ++k)
    if (world[k] != 0) p.shift = std::max(p.shift, exponent_ - dyadic(world[k]).exponent);
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    // mantissa 2^up - origin 2^shift, without the lesser of the two powers until the end.
    const Dyadic d = dyadic(world[k]);
    const int up = d.mantissa == 0 ? p.shift : d.exponent - exponent_ + p.shift, common = std::min(up, p.shift);
    const mpz_ptr c = p.c[i].get_mpz_t();
    mpz_mul_2exp(c, origin_[i].get_mpz_t(), static_cast<mp_bitcnt_t>(p.shift - common));
    if (up == common) {
      mpz_neg(c, c);
      const auto size = static_cast<unsigned long>(std::abs(d.mantissa));
      d.mantissa < 0 ? mpz_sub_ui(c, c, size) : mpz_add_ui(c, c, size);
    } else {
      mpz_set_si(c, d.mantissa);
      mpz_mul_2exp(c, c, static_cast<mp_bitcnt_t>(up - common));
      mpz_sub(c, c, origin_[i].get_mpz_t());
    }
    mpz_mul_2exp(c, c, static_cast<mp_bitcnt_t>(common));
  }
}

bool Grid::short_point(const glm::dvec3& world, std::array<std::int64_t, 3>& c) const {
  if (!snap_.empty()) return false;
  std::array<std::int64_t, 3> r{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = world[static_cast<int>(k)];
    if (!std::isfinite(x) || mpz_size(origin_[k].get_mpz_t()) > 1) return false;
    const Dyadic d = dyadic(x);
    const int shift = d.exponent - exponent_;
    if (d.mantissa != 0 && (shift < 0 || shift > 64)) return false;
    // Below 2^53 * 2^64 and 2^64: no overflow.
    const __int128 steps =
        d.mantissa == 0 ? 0 : static_cast<__int128>(d.mantissa) * (static_cast<__int128>(1) << shift);
    const auto size = static_cast<__int128>(mpz_get_ui(origin_[k].get_mpz_t()));
    const __int128 moved = sgn(origin_[k]) < 0 ? steps + size : steps - size;
    constexpr __int128 limit = static_cast<__int128>(1) << 62;
    if (moved >= limit || moved <= -limit) return false;
    r[k] = static_cast<std::int64_t>(moved);
  }
  c = r;
  return true;
}

double Grid::world(const Integer& c, int axis) const {
  const Integer sum = c + origin_[static_cast<std::size_t>(axis)];
  if (snap_.empty()) return nearest_double(sum, exponent_);
  return nearest_double(Integer(sum * unit_.get_num()), unit_.get_den());
}

double Grid::world(const Integer& numerator, const Integer& denominator, int axis) const {
  const Integer sum = numerator + origin_[static_cast<std::size_t>(axis)] * denominator;
  if (!snap_.empty()) return nearest_double(Integer(sum * unit_.get_num()), Integer(denominator * unit_.get_den()));
  if (exponent_ >= 0) return nearest_double(shifted(sum, exponent_), denominator);
  return nearest_double(sum, shifted(denominator, -exponent_));
}

glm::dvec3 Grid::unit(const glm::dvec3& world) const {
  glm::dvec3 u{0};
  const Integer unit_length = shifted(Integer(1), unit_bits_);
  for (int k = 0; k < 3; ++k) {
    const Integer& origin = origin_[static_cast<std::size_t>(k)];
    if (snap_.empty()) {
      const int exponent = std::min(exponent_, world[k] == 0 ? exponent_ : dyadic(world[k]).exponent);
      u[k] = nearest_double(Integer(in_steps(world[k], exponent) - shifted(origin, exponent_ - exponent)),
                            exponent - exponent_ - unit_bits_);
    } else {
      const mpq_class q = mpq_class(world[k]) / unit_ - origin;
      u[k] = nearest_double(q.get_num(), Integer(q.get_den() * unit_length));
    }
  }
  return u;
}

double Grid::step() const {
  return snap_.empty() ? std::ldexp(1.0, exponent_) : nearest_double(unit_.get_num(), unit_.get_den());
}

mpq_class Grid::exact_step() const {
  if (!snap_.empty()) return unit_;
  mpq_class step = 1;
  const auto bits = static_cast<mp_bitcnt_t>(std::abs(exponent_));
  if (exponent_ >= 0) {
    mpq_mul_2exp(step.get_mpq_t(), step.get_mpq_t(), bits);
  } else {
    mpq_div_2exp(step.get_mpq_t(), step.get_mpq_t(), bits);
  }
  return step;
}

}  // namespace sightline
