// Where a vertex is seen, rounded once.
#include "visibility_map/stitch_state.hpp"
#include "visibility_map/stitch_twofold.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

Twofold3 cross(const Twofold3& a, const Twofold3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Twofold dot(const Twofold3& a, const Twofold3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Twofold3 exact_cross(const glm::dvec3& a, const glm::dvec3& b) {
  return cross({{a.x, 0}, {a.y, 0}, {a.z, 0}}, {{b.x, 0}, {b.y, 0}, {b.z, 0}});
}

/// Two's complement words times 2^-bits, |.| <= 1, rounded down to a multiple of 2^-106.
Twofold from_words(const std::uint64_t* words, std::uint32_t count, std::uint32_t bits) {
  // The words at and above bit `bits - 106`, as one number of at most 107 bits and a sign.
  const int low = static_cast<int>(bits) - 106;
  const auto word = [&](int k) -> std::uint64_t {
    if (k < 0) return 0;
    if (k >= static_cast<int>(count)) return words[count - 1] >> 63 ? ~std::uint64_t{0} : 0;
    return words[k];
  };
  const int first = low >> 6, shift = low & 63;
  std::uint64_t part[2];
  for (int k = 0; k < 2; ++k) {
    part[k] = word(first + k) >> shift;
    if (shift != 0) part[k] |= word(first + k + 1) << (64 - shift);
  }
  // Upper and lower part of 53 bits; the upper one keeps the sign.
  const auto upper = static_cast<std::int64_t>(part[1] << 11 | part[0] >> 53);
  const std::uint64_t lower = part[0] & ((std::uint64_t{1} << 53) - 1);
  return two_sum(static_cast<double>(upper) * 0x1p-53, static_cast<double>(lower) * 0x1p-106);
}
Twofold3 normal(const SightlineTable& table, SightlineId id) {
  const std::uint32_t bits = table.bits(id), count = words_for(bits);
  const std::uint64_t* w = table.words(id);
  return {from_words(w, count, bits), from_words(w + count, count, bits), from_words(w + 2 * count, count, bits)};
}

/// The double nearest to 1/2 + q, q within `error`; NaN where that leaves a choice.
double nearest(const Twofold& q, double error) {
  const Twofold half = two_sum(0.5, q.high);
  const Twofold value = fast_sum(half.high, half.low + q.low);
  if (!(value.high > 0x1p-40 && value.high < 2)) return NAN;
  const double below = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value.high) - 1);
  return std::abs(value.low) + error + 0x1p-104 < (value.high - below) / 2 ? value.high : NAN;
}

/// x = n_a x n_b is l (f + (s - 1/2) r + (t - 1/2) up): its products with r x up, up x f and f x r are in the ratio
/// 1 : s - 1/2 : t - 1/2.
/// With v = 2^-106: normals are at most 1, within v. x is at most 2, within 2 (2 + 8) + 16 < 48 v. The vectors
/// multiplied with are at most D = twice the product of the largest components of their factors, within 32 v D. A
/// product is within 3 (48 + 2 32 + 16) v D (terms) + 8 (2 + 4 + 2 + 2) v D (sums) < 2^9 v D = 2^-97 D.
glm::dvec2 filter_st(const State& s, SightlineId a, SightlineId b) {
  const Twofold3 x = cross(normal(*s.table, a), normal(*s.table, b));
  const Twofold depth = dot(x, s.axes[0].vector);
  if (!(std::abs(depth.high) > 2 * s.axes[0].error)) return {NAN, NAN};
  const auto coordinate = [&](const Axis& axis) {
    const Twofold q = dot(x, axis.vector) / depth;
    const double size = std::abs(q.high);
    return nearest(q, 4 * (axis.error + size * s.axes[0].error) / std::abs(depth.high) + 0x1p-100 * size);
  };
  return {coordinate(s.axes[1]), coordinate(s.axes[2])};
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

void set_axes(State& s) {
  const auto largest = [](const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  const auto axis = [&](const glm::dvec3& v, const glm::dvec3& w) {
    return Axis{exact_cross(v, w), 0x1p-96 * largest(v) * largest(w)};
  };
  const Camera& c = *s.camera;
  int exponent = 0;
  std::frexp(std::max({largest(c.forward), largest(c.right), largest(c.up)}), &exponent);
  const glm::dvec3* const given[3] = {&c.forward, &c.right, &c.up};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) s.frame[i][k] = std::ldexp((*given[i])[k], -exponent);
  }
  const auto& [forward, right, up] = s.frame;
  s.axes[0] = axis(right, up);
  s.axes[1] = axis(up, forward);
  s.axes[2] = axis(forward, right);
}

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
  vertex.direction = glm::normalize(s.frame[0] + (st.x - 0.5) * s.frame[1] + (st.y - 0.5) * s.frame[2]);
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
