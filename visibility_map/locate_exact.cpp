#include "visibility_map/locate_exact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sightline {

namespace {

using Vector = std::array<Integer, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
bool is_zero(const Vector& a) { return sgn(a[0]) == 0 && sgn(a[1]) == 0 && sgn(a[2]) == 0; }

/// value * 2^-exponent, where exponent is at most last_bit(value).
Integer scaled(double value, int exponent) {
  if (value == 0) return 0;
  int e = 0;
  Integer result(std::ldexp(std::frexp(value, &e), 53));
  mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(e - 53 - exponent));
  return result;
}

/// Exponent of the last bit of the 53 that a double may use.
int last_bit(double value) {
  int e = 0;
  std::frexp(value, &e);
  return value == 0 ? 0 : e - 53;
}

}  // namespace

Sign exact_orientation(const WindowPoint& a, const WindowPoint& b, const WindowPoint& c) {
  return sgn(dot(cross(a, b), c));
}

Sign exact_compare(const WindowPoint& a, const WindowPoint& b, std::size_t coordinate) {
  return sgn(Integer(a[coordinate] * b[0] - b[coordinate] * a[0]));
}

WindowPoint exact_point(const glm::dvec2& st) {
  const int exponent = std::min({last_bit(st.x), last_bit(st.y), -1});
  WindowPoint p{1, scaled(st.x, exponent), scaled(st.y, exponent)};
  mpz_mul_2exp(p[0].get_mpz_t(), p[0].get_mpz_t(), static_cast<mp_bitcnt_t>(-exponent));
  const Integer half = p[0] / 2;
  p[1] -= half;
  p[2] -= half;
  return p;
}

glm::dvec2 rounded(const WindowPoint& p) {
  const auto coordinate = [&](std::size_t k) {
    mpq_class q(p[0] + 2 * p[k], 2 * p[0]);
    q.canonicalize();
    return q.get_d();  // rounds towards zero: within an ulp, 2^-53 up to 1
  };
  return {coordinate(1), coordinate(2)};
}

ExactWindow::ExactWindow(const VisibilityMap& map, const Scene& scene) : map_(map), scene_(scene) {
  if (map.sphere) throw std::invalid_argument("a map of the whole sphere has no window");
  eye_ = scene.grid().point(map.camera.eye);
  const glm::dvec3 vectors[3] = {map.camera.forward, map.camera.right, map.camera.up};
  int exponent = 0;
  for (const glm::dvec3& v : vectors) {
    exponent = std::min({exponent, last_bit(v.x), last_bit(v.y), last_bit(v.z)});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    vectors_[k] = {scaled(vectors[k].x, exponent), scaled(vectors[k].y, exponent), scaled(vectors[k].z, exponent)};
  }
}

std::array<Integer, 3> ExactWindow::relative(PointId p) const {
  Vector v = scene_.points().point(p);
  for (std::size_t k = 0; k < 3; ++k) {
    mpz_mul_2exp(v[k].get_mpz_t(), v[k].get_mpz_t(), static_cast<mp_bitcnt_t>(eye_.shift));
    v[k] -= eye_.c[k];
  }
  return v;
}

std::array<Integer, 3> ExactWindow::normal(const MapLine& line) const {
  const auto count = line.kind == MapLine::edge ? 2 : 6;
  for (int k = 0; k < count; ++k) {
    if (line.v[k] >= scene_.points().size()) throw std::invalid_argument("the map is not one of this scene");
  }
  Vector n;
  if (line.kind == MapLine::edge) {
    n = cross(relative(line.v[0]), relative(line.v[1]));
  } else {
    // The eye is the origin here: n_p.x = d_p with d_p = n_p.a; the plane through the line of p and q that contains
    // the origin is d_q n_p - d_p n_q.
    Vector plane[2];
    Integer offset[2];
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector a = relative(line.v[3 * k]);
      plane[k] = cross(minus(relative(line.v[3 * k + 1]), a), minus(relative(line.v[3 * k + 2]), a));
      offset[k] = dot(plane[k], a);
    }
    for (std::size_t k = 0; k < 3; ++k) n[k] = offset[1] * plane[0][k] - offset[0] * plane[1][k];
  }
  if (is_zero(n)) throw std::invalid_argument("the map is not one of this scene: a line of it is none");
  return n;
}

WindowLine ExactWindow::line(const std::array<Integer, 3>& normal) const {
  return {dot(normal, vectors_[0]), dot(normal, vectors_[1]), dot(normal, vectors_[2])};
}

WindowLine ExactWindow::line(const MapLine& line) const {
  if (line.kind != MapLine::window) return this->line(normal(line));
  switch (line.v[0]) {  // w + 2x = 2ws and so on
    case Window::left:
      return {1, 2, 0};
    case Window::right:
      return {1, -2, 0};
    case Window::bottom:
      return {1, 0, 2};
    default:
      return {1, 0, -2};
  }
}

WindowPoint ExactWindow::meet(const WindowLine& a, const WindowLine& b) {
  WindowPoint p = cross(a, b);
  if (sgn(p[0]) == 0) throw std::invalid_argument("the map is not one of this scene: lines of a vertex do not meet");
  if (sgn(p[0]) < 0) p = {-p[0], -p[1], -p[2]};
  return p;
}

WindowPoint ExactWindow::vertex(std::uint32_t v) const {
  const MapVertex& vertex = map_.vertices[v];
  return meet(line(map_.lines[vertex.line[0]]), line(map_.lines[vertex.line[1]]));
}

}  // namespace sightline
