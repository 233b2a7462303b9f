// Where a vertex is seen, rounded once.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

using Long = long double;
constexpr Long epsilon = LDBL_EPSILON / 2;  // unit roundoff; 2^-64 on x86. Where it is 2^-53, the exact path answers.

struct Long3 {
  Long x, y, z;
  Long largest() const { return std::max({std::abs(x), std::abs(y), std::abs(z)}); }
};
Long3 cross(const Long3& a, const Long3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Long dot(const Long3& a, const Long3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Two's complement words, most significant first: each step after the first that is not exact rounds once, and the
/// errors of the earlier ones are relative to it: within 2 epsilon of the whole.
Long from_words(const std::uint64_t* words, std::uint32_t count) {
  Long value = static_cast<Long>(static_cast<std::int64_t>(words[count - 1]));
  for (std::uint32_t k = count - 1; k-- > 0;) value = value * 0x1p64L + static_cast<Long>(words[k]);
  return value;
}
Long3 normal(const SightlineTable& table, SightlineId id) {
  const std::uint32_t count = words_for(table.bits(id));
  const std::uint64_t* w = table.words(id);
  return {from_words(w, count), from_words(w + count, count), from_words(w + 2 * count, count)};
}

/// The double nearest to 1/2 + q, q within `error`; NaN where that leaves a choice.
double nearest(Long q, Long error) {
  const Long value = 0.5L + q;
  const auto rounded = static_cast<double>(value);
  if (!(rounded > 0x1p-60 && rounded < 2)) return NAN;
  const double below = std::bit_cast<double>(std::bit_cast<std::uint64_t>(rounded) - 1);
  const Long room = (static_cast<Long>(rounded) - static_cast<Long>(below)) / 2;
  return std::abs(value - static_cast<Long>(rounded)) + error + 2 * epsilon < room ? rounded : NAN;
}

/// x = n_a x n_b is l (f + (s - 1/2) r + (t - 1/2) up): its products with r x up, up x f and f x r are in the ratio
/// 1 : s - 1/2 : t - 1/2.
/// With M the product of the largest components of n_a and n_b: x is at most 2 M, within 2 (2 2) + 4 = 12 eps M. The
/// vectors multiplied with are at most D = twice the product of the largest components of their factors, within 2 eps
/// D. A product is within 3 (12 + 2 2) eps M D (data) + (6 + 10) eps M D (rounding) = 64 eps M D.
glm::dvec2 filter_st(const State& s, SightlineId a, SightlineId b) {
  const auto load = [](const glm::dvec3& v) { return Long3{v.x, v.y, v.z}; };
  const Long3 f = load(s.camera->forward), r = load(s.camera->right), up = load(s.camera->up);
  const Long3 na = normal(*s.table, a), nb = normal(*s.table, b), x = cross(na, nb);
  const Long unit = 64 * epsilon * na.largest() * nb.largest();
  const Long depth = dot(x, cross(r, up)), depth_error = unit * 2 * r.largest() * up.largest();
  if (!(std::abs(depth) > 2 * depth_error)) return {NAN, NAN};
  const auto coordinate = [&](const Long3& v, const Long3& w) {
    const Long q = dot(x, cross(v, w)) / depth, error = unit * 2 * v.largest() * w.largest();
    return nearest(q, 2 * (error + std::abs(q) * depth_error) / std::abs(depth) + 2 * epsilon * std::abs(q));
  };
  return {coordinate(up, f), coordinate(f, r)};
}

std::array<Integer, 3> exact_ray(const State& s, CornerId c) {
  const Corner& corner = s.corners[c];
  const std::array<Integer, 3> a = s.table->normal(corner.low), b = s.table->normal(corner.high);
  std::array<Integer, 3> r{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const Integer factor = gcd(gcd(r[0], r[1]), r[2]);
  for (Integer& k : r) k = corner.sign * k / factor;
  return r;
}

using Rational3 = std::array<mpq_class, 3>;
mpq_class det(const Rational3& a, const Rational3& b, const Rational3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
std::array<mpq_class, 2> exact_st(const State& s, CornerId c) {
  const auto load = [](const auto& v) { return Rational3{mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])}; };
  const Rational3 x = load(exact_ray(s, c)), f = load(s.camera->forward), r = load(s.camera->right),
                  up = load(s.camera->up);
  const mpq_class depth = det(x, r, up);
  return {mpq_class(det(x, up, f) / depth), mpq_class(det(x, f, r) / depth)};
}

}  // namespace

void place_vertex(const State& s, VertexDraft& vertex) {
  const Corner& corner = s.corners[vertex.corner];
  if (!s.camera) {
    const std::array<Integer, 3> ray = exact_ray(s, vertex.corner);
    long top = 0, exponent[3];
    for (std::size_t k = 0; k < 3; ++k) {
      vertex.direction[static_cast<int>(k)] = mpz_get_d_2exp(&exponent[k], ray[k].get_mpz_t());
      if (ray[k] != 0) top = std::max(top, exponent[k]);
    }
    for (int k = 0; k < 3; ++k) {
      vertex.direction[k] = std::ldexp(vertex.direction[k], static_cast<int>(std::max(exponent[k] - top, -2000l)));
    }
    vertex.direction = glm::normalize(vertex.direction);
    vertex.st = {0, 0};
    return;
  }
  glm::dvec2 st = filter_st(s, corner.low, corner.high);
  const auto on = [&](Window::Side side) {
    return corner.low == s.border[side].id || corner.high == s.border[side].id;
  };
  if (on(Window::left)) st.x = 0;
  if (on(Window::right)) st.x = 1;
  if (on(Window::bottom)) st.y = 0;
  if (on(Window::top)) st.y = 1;
  if (std::isnan(st.x) || std::isnan(st.y)) st = s.window->st(*s.table, corner.low, corner.high);
  vertex.st = st + 0.0;  // no negative zero
  const Camera& c = *s.camera;
  vertex.direction = glm::normalize(c.forward + (st.x - 0.5) * c.right + (st.y - 0.5) * c.up);
}

Sign compare_places(const State& s, CornerId a, CornerId b) {
  if (!s.camera) {
    const std::array<Integer, 3> p = exact_ray(s, a), q = exact_ray(s, b);
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] != q[k]) return p[k] < q[k] ? -1 : 1;
    }
    return 0;
  }
  const std::array<mpq_class, 2> p = exact_st(s, a), q = exact_st(s, b);
  return p[0] != q[0] ? (p[0] < q[0] ? -1 : 1) : p[1] != q[1] ? (p[1] < q[1] ? -1 : 1) : 0;
}

}  // namespace sightline::stitching
