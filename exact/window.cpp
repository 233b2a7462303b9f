#include "exact/rounding.hpp"
#include "exact/sightline_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sightline {
namespace {

using Vector = std::array<Integer, 3>;

Vector combination(int p, const Vector& a, int q, const Vector& b) {
  return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}

}  // namespace

Window::Window(const glm::dvec3& f, const glm::dvec3& r, const glm::dvec3& u) {
  const std::array<glm::dvec3, 3> given{f, r, u};
  int least = std::numeric_limits<int>::max();
  for (const glm::dvec3& v : given)
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(v[k])) throw std::invalid_argument("a vector of the window is not finite");
      if (v[k] != 0) least = std::min(least, dyadic(v[k]).exponent);
    }
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const Dyadic d = dyadic(given[i][k]);
      if (d.mantissa != 0) vectors_[i][static_cast<std::size_t>(k)] = shifted(Integer(d.mantissa), d.exponent - least);
    }
  const Integer det = det3<0, 0, 0>(vectors_[1], vectors_[2], vectors_[0]);
  if (det == 0) throw std::invalid_argument("the vectors of the window are linearly dependent");
  handedness_ = det < 0 ? 1 : -1;
}

SightlineRef Window::side(SightlineTable& table, Side which) const {
  const auto& [f, r, up] = vectors_;
  // The side s = 0 is spanned by 2f - r and up; its normal (2f - r) x up has the product -det(r, up, f) with f,
  // positive for handedness +1. The others alike.
  Vector n;
  switch (which) {
    case left:
      n = cross<0, 0>(combination(2, f, -1, r), up);
      break;
    case right:
      n = cross<0, 0>(up, combination(2, f, 1, r));
      break;
    case bottom:
      n = cross<0, 0>(r, combination(2, f, -1, up));
      break;
    case top:
      n = cross<0, 0>(combination(2, f, 1, up), r);
      break;
  }
  const SightlineRef ref = table.of_normal(n);
  return handedness_ > 0 ? ref : -ref;
}

glm::dvec2 Window::st(const SightlineTable& table, SightlineId a, SightlineId b) const {
  // x = n_a x n_b = l (f + (s - 1/2) r + (t - 1/2) up): products with r x up, up x f and f x r are l D, l (s - 1/2) D
  // and l (t - 1/2) D, D = det(f, r, up).
  const auto& [f, r, up] = vectors_;
  const Vector x = cross<0, 0>(table.normal(a), table.normal(b));
  const Integer depth = dot<0, 0, 0>(x, cross<0, 0>(r, up));
  const Integer across = dot<0, 0, 0>(x, cross<0, 0>(up, f)), upwards = dot<0, 0, 0>(x, cross<0, 0>(f, r));
  if (depth == 0) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  return {nearest_double(Integer(depth + 2 * across), Integer(2 * depth)),
          nearest_double(Integer(depth + 2 * upwards), Integer(2 * depth))};
}

Sign Window::forwardness(const SightlineTable& table, SightlineRef a, SightlineRef b) const {
  const auto& [f, r, up] = vectors_;
  const Vector x = cross<0, 0>(table.normal(b.id), table.normal(a.id));
  // l D as above, and the sign of D = det(f, r, up) is -handedness.
  return -handedness_ * a.sign * b.sign * sgn(dot<0, 0, 0>(x, cross<0, 0>(r, up)));
}

}  // namespace sightline
