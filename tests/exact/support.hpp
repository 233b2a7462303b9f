// Random scenes with manufactured degeneracy, and a plain oracle for them in GMP integers.
#pragma once

#include "exact/types.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/vec3.hpp>
#include <random>
#include <stdexcept>
#include <vector>

namespace sightline::test {

/// Number of cases: SIGHTLINE_CASES where it is set, else the quick number for everyday runs.
inline long cases(long quick) {
  const char* const wanted = std::getenv("SIGHTLINE_CASES");
  return wanted != nullptr ? std::atol(wanted) : quick;
}

/// RapidCheck with a fixed seed, unless the environment asks for another.
inline const int fixed_seed = setenv("RC_PARAMS", "seed=20240229 max_success=150", 0);

/// Bit lengths that reach every width of the ladder.
inline constexpr std::array<int, 12> bit_lengths{8, 15, 20, 27, 30, 40, 53, 60, 75, 110, 200, 2000};

using Random = std::mt19937_64;
inline int below(Random& random, int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }

/// Points and an eye: coordinates of about `bits` bits. Points share coordinates, lie on lines and planes of others,
/// or miss them by the least step; the eye lies anywhere, in points, on edges, on planes, beside them, far away, or
/// on a finer grid than the points.
struct RandomScene {
  std::vector<glm::dvec3> points;
  glm::dvec3 eye{0};

  RandomScene(std::uint64_t seed, int bits, int count = 10) : random_(seed), bits_(bits) {
    // With 2000 bits a coordinate is below 2^(52 + 1947 + scale). Each of the seven points that follow the third, and
    // the eye, may be three times as long as the longest before it, and the eye is stretched by up to 2^39: 2^1011.
    scale_ = bits > 1000 ? -1040 : below(random_, 41) - 20;
    for (int i = 0; i < count; ++i) points.push_back(i < 3 ? fresh() : next());
    eye = next();
    switch (below(random_, 6)) {
      case 0:
        eye = points[index()];
        break;
      case 1:
        eye += glm::dvec3(std::ldexp(below(random_, 100), scale_ - 12));
        break;
      case 2:
        eye *= std::ldexp(1.0, below(random_, 40));
        break;
      default:
        break;
    }
    // GMP answers an infinite double with a signal that names nothing.
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(eye[k])) throw std::logic_error("RandomScene: a coordinate is too long for a double");
    }
  }

 private:
  double coordinate() {
    const int length = std::min(bits_, 53);
    const auto m = static_cast<std::int64_t>(random_() >> (64 - length)) - (std::int64_t{1} << (length - 1));
    return std::ldexp(static_cast<double>(m), scale_ + (bits_ > 53 ? below(random_, bits_ - 52) : 0));
  }
  glm::dvec3 fresh() {
    glm::dvec3 p;
    for (int k = 0; k < 3; ++k) p[k] = coordinate();
    return p;
  }
  std::size_t index() { return random_() % points.size(); }
  glm::dvec3 next() {
    const glm::dvec3 p = points[index()], q = points[index()], r = points[index()];
    glm::dvec3 n = fresh();
    const int k = below(random_, 3);
    switch (below(random_, 9)) {
      case 0:
        n[k] = p[k];
        break;
      case 1:
        n[k] = p[k], n[(k + 1) % 3] = q[(k + 1) % 3];
        break;
      case 2:
        n = p, n[k] = q[k];
        break;
      case 3:
        n = p + q - r;
        break;
      case 4:
        n = p + p - q;
        break;
      case 5:
        n = (p + q) * 0.5;
        break;
      case 6:
        n = below(random_, 2) == 0 ? p : p + q - r;
        n[k] = bits_ <= 53 ? n[k] + std::ldexp(1.0, scale_) : std::nextafter(n[k], 1e300);
        break;
      case 7:
        n = q, n[k] = (below(random_, 2) == 0 ? p : r)[k];
        break;
      default:
        break;
    }
    return n;
  }

  Random random_;
  int bits_;
  int scale_;
};

using Vector = std::array<mpz_class, 3>;
inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpz_class product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline mpz_class triple(const Vector& a, const Vector& b, const Vector& c) { return product(cross_product(a, b), c); }
inline bool is_zero(const Vector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
inline int sign_of_first(const Vector& n) {
  for (const mpz_class& c : n)
    if (c != 0) return sgn(c);
  return 0;
}

/// The scene once more, as integers without any change of origin, straight from the doubles.
struct Oracle {
  struct Plane {
    Vector n;
    mpz_class d;
  };
  struct Vertex {  // homogeneous
    Vector x;
    mpz_class w;
  };
  std::vector<Vector> point;
  Vector eye;
  int exponent = 0;

  explicit Oracle(const RandomScene& scene) {
    const auto least = [&](double x) {
      int e = 0;
      if (x == 0) return;
      const double m = std::frexp(x, &e);
      (void)m;
      exponent = std::min(exponent, e - 53);
    };
    for (const auto& p : scene.points)
      for (int k = 0; k < 3; ++k) least(p[k]);
    for (int k = 0; k < 3; ++k) least(scene.eye[k]);
    for (const auto& p : scene.points) point.push_back(integers(p));
    eye = integers(scene.eye);
  }
  Vector integers(const glm::dvec3& p) const { return {integer(p.x), integer(p.y), integer(p.z)}; }
  mpz_class integer(double x) const {
    int e = 0;
    mpz_class m(std::ldexp(std::frexp(x, &e), 53));  // an integer
    if (x != 0) m <<= static_cast<mp_bitcnt_t>(e - 53 - exponent);
    return m;
  }

  /// n.x = d with the first non-zero component of n positive.
  static Plane oriented(Plane p) {
    if (sign_of_first(p.n) < 0) p = {{-p.n[0], -p.n[1], -p.n[2]}, -p.d};
    return p;
  }
  Plane through(PointId a, PointId b, PointId c) const {
    const Vector n = cross_product(minus(point[b], point[a]), minus(point[c], point[a]));
    return {n, product(n, point[a])};
  }
  Plane wall(PointId a, PointId b, int axis) const {
    Vector e{0, 0, 0};
    e[static_cast<std::size_t>(axis)] = 1;
    const Vector n = cross_product(minus(point[b], point[a]), e);
    return {n, product(n, point[a])};
  }
  static Vertex meet(const Plane& a, const Plane& b, const Plane& c) {
    const Vector bc = cross_product(b.n, c.n), ca = cross_product(c.n, a.n), ab = cross_product(a.n, b.n);
    Vertex v;
    v.w = product(a.n, bc);
    for (std::size_t k = 0; k < 3; ++k) v.x[k] = bc[k] * a.d + ca[k] * b.d + ab[k] * c.d;
    return v;
  }
  static int side(const Plane& p, const Vector& x) { return sgn(mpz_class(product(p.n, x) - p.d)); }
  static int side(const Plane& p, const Vertex& v) { return sgn(v.w) * sgn(mpz_class(product(p.n, v.x) - p.d * v.w)); }
  static bool same(const Plane& a, const Plane& b) {
    return is_zero(cross_product(a.n, b.n)) && a.n[0] * b.d == b.n[0] * a.d && a.n[1] * b.d == b.n[1] * a.d &&
           a.n[2] * b.d == b.n[2] * a.d;
  }
  Vector sightline(PointId a, PointId b) const { return cross_product(minus(point[a], eye), minus(point[b], eye)); }
  Vector sightline(const Plane& p, const Plane& q) const {
    const mpz_class at_p = product(p.n, eye) - p.d, at_q = product(q.n, eye) - q.d;
    return {at_p * q.n[0] - at_q * p.n[0], at_p * q.n[1] - at_q * p.n[1], at_p * q.n[2] - at_q * p.n[2]};
  }
};

}  // namespace sightline::test
