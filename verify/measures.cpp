// Areas and solid angles as printed.
#include "verify/checks.hpp"

#include <cmath>

namespace sightline::verify {

namespace {

/// Places of the vertices in units of 2^-bits, rounded down.
constexpr unsigned bits = 128;

struct Place {
  Integer s, t;
};

std::vector<Place> places(const Drawing& drawing) {
  std::vector<Place> out(drawing.file().vertices.size());
  for (std::uint32_t v = 0; v < out.size(); ++v) {
    const Triple& r = drawing.vertex(v).r;
    out[v].s = (r.x << bits) / r.z;
    out[v].t = (r.y << bits) / r.z;
  }
  return out;
}

Rational fraction(const Integer& num, const Integer& den) {
  Rational out(num, den);
  out.canonicalize();
  return out;
}

bool area_right(const Drawing& drawing, const std::vector<Place>& place, const MapFace& face) {
  Integer twice;
  std::size_t terms = 0;
  for (const auto& loop : face.loops) {
    for (const std::int32_t entry : loop) {
      const Place &a = place[drawing.from(entry)], &b = place[drawing.to(entry)];
      twice += a.s * b.t - b.s * a.t;
      ++terms;
    }
  }
  const Rational tolerance(1, 1000000000000);
  const auto off = [&](const Rational& area) { return Rational(abs(area - Rational(face.area))); };
  // Places are off by less than 2^-bits and at most 1, so a term is off by less than 4 * 2^-bits.
  const Rational doubt = fraction(Integer(static_cast<unsigned long>(4 * terms)), Integer(1) << bits);
  const Rational difference = off(fraction(twice, Integer(1) << (2 * bits + 1)));
  if (difference <= tolerance - doubt) return true;
  if (difference > tolerance + doubt) return false;
  Rational exact;
  for (const auto& loop : face.loops) {
    for (const std::int32_t entry : loop) {
      const Triple &a = drawing.vertex(drawing.from(entry)).r, &b = drawing.vertex(drawing.to(entry)).r;
      exact += fraction(a.x * b.y - b.x * a.y, 2 * a.z * b.z);
    }
  }
  return off(exact) <= tolerance;
}

using Real = long double;
struct Direction {
  Real x, y, z;
};
Real dot(const Direction& a, const Direction& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Direction unit(const Direction& a) {
  const Real length = std::sqrt(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}

/// Solid angle of the triangle of three unit vectors, with its sign: A. van Oosterom, J. Strackee, IEEE Trans. Biomed.
/// Eng. 30 (1983).
Real signed_angle(const Direction& a, const Direction& b, const Direction& c) {
  const Real volume = a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  return 2 * std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

}  // namespace

void check_measures(const Drawing& drawing, const MapFile& file, Report& report) {
  const std::vector<Place> place = places(drawing);
  // Rays and angles in long double: every term of a sum is off by some 2^-62 only.
  const auto scaled = [](const Integer& x) {
    const Integer high = x >> (bits - 63);  // at most 2^63
    return std::ldexp(static_cast<Real>(mpz_get_ui(high.get_mpz_t())), -63);
  };
  const auto along = [&](Real s, Real t) {
    const auto part = [&](std::size_t i) {
      return file.forward[i] + (s - 0.5L) * file.right[i] + (t - 0.5L) * file.up[i];
    };
    return unit({part(0), part(1), part(2)});
  };
  std::vector<Direction> ray;
  for (const Place& p : place) ray.push_back(along(scaled(p.s), scaled(p.t)));
  const Direction centre = along(0.5L, 0.5L);
  // The corners of the whole window tell which way round is positive.
  const Real whole = signed_angle(centre, along(0, 0), along(1, 0));
  for (std::size_t f = 0; f < file.faces.size(); ++f) {
    const MapFace& face = file.faces[f];
    if (!area_right(drawing, place, face))
      report.fault("area", named("face", f), "is not within 1e-12 of the exact area");
    Real sum = 0;
    for (const auto& loop : face.loops) {
      for (const std::int32_t entry : loop) {
        sum += signed_angle(centre, ray[drawing.from(entry)], ray[drawing.to(entry)]);
      }
    }
    if (whole < 0) sum = -sum;
    if (!(std::abs(sum - static_cast<Real>(face.solid_angle)) <= 1e-12L)) {
      report.fault("solid angle", named("face", f), "is not within 1e-12 of " + std::to_string(sum));
    }
  }
}

}  // namespace sightline::verify
