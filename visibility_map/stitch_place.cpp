// Where a vertex is seen, rounded once.
#include "exact/rounding.hpp"
#include "visibility_map/stitch_state.hpp"
#include "visibility_map/stitch_twofold.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace sightline::stitching {
namespace {

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
  return fast_sum(static_cast<double>(upper) * 0x1p-53,
                  static_cast<double>(static_cast<std::int64_t>(lower)) * 0x1p-106);
}

/// The same of one word, which loses nothing, and of two; both halves of what is summed are exact.
[[gnu::always_inline]] inline Twofold from_word(std::uint64_t word, double power) {
  const auto x = static_cast<std::int64_t>(word);
  return fast_sum(static_cast<double>(x >> 10) * (0x1p10 * power), static_cast<double>(x & 1023) * power);
}
[[gnu::always_inline]] inline Twofold from_two_words(std::uint64_t low, std::uint64_t high, std::uint32_t bits) {
  // Moved up, so that the sign is followed by the first bit.
  const std::uint64_t top = (high << (127 - bits)) | (low >> 1 >> (bits - 64)), rest = low << (127 - bits);
  const auto upper = static_cast<std::int64_t>(top) >> 10;
  const auto lower = static_cast<std::int64_t>((top & 1023) << 43 | rest >> 21);
  return fast_sum(static_cast<double>(upper) * 0x1p-53, static_cast<double>(lower) * 0x1p-106);
}

struct Normal {
  Twofold x, y, z;
};
[[gnu::always_inline]] inline Normal normal(const SightlineTable& table, SightlineId id) {
  const std::uint32_t bits = table.bits(id);
  const std::uint64_t* const w = table.words(id);
  if (bits < 64) {
    const auto power = std::bit_cast<double>(std::uint64_t{1023 - bits} << 52);
    return {from_word(w[0], power), from_word(w[1], power), from_word(w[2], power)};
  }
  if (bits < 128) {
    return {from_two_words(w[0], w[1], bits), from_two_words(w[2], w[3], bits), from_two_words(w[4], w[5], bits)};
  }
  const std::uint32_t count = words_for(bits);
  return {from_words(w, count, bits), from_words(w + count, count, bits), from_words(w + 2 * count, count, bits)};
}

/// With u = 2^-53, v = u^2, F the largest component of f: normals are at most 1, within v. Products and the sums of
/// their upper parts lose nothing; what they leave is at most 3 (1 + 1) uF and (2 + 3) uF, 11 uF in all, and is put
/// together with three products and seven sums: 3 vF + 77 vF. With the data's 3 vF: within 96 vF.
template <bool fused>
[[gnu::always_inline]] inline Twofold dot(const Normal& n, const glm::dvec3& f) {
  const Twofold x = two_product<fused>(n.x.high, f.x), y = two_product<fused>(n.y.high, f.y),
                z = two_product<fused>(n.z.high, f.z);
  const Twofold xy = two_sum(x.high, y.high), xyz = two_sum(xy.high, z.high);
  const double low = (x.low + n.x.low * f.x) + (y.low + n.y.low * f.y) + (z.low + n.z.low * f.z);
  return two_sum(xyz.high, low + (xy.low + xyz.low));
}

/// a b - c d. Where neither product is above D: what the upper parts leave is 2 uD + 2 uD, the four products of an
/// upper and a lower part uD each, 8 uD in all, put together with four products and seven sums: 4 vD + 56 vD; two
/// products of lower parts are left out: within 64 vD.
template <bool fused>
[[gnu::always_inline]] inline Twofold minor(const Twofold& a, const Twofold& b, const Twofold& c, const Twofold& d) {
  const Twofold p = two_product<fused>(a.high, b.high), q = two_product<fused>(c.high, d.high);
  const Twofold s = two_sum(p.high, -q.high);
  const double low = (a.high * b.low + a.low * b.high) - (c.high * d.low + c.low * d.high);
  return two_sum(s.high, s.low + ((p.low - q.low) + low));
}

/// a / b, within 2^-100 of it: the difference from the first quotient's product is exact in its upper part (Sterbenz),
/// at most 5 u |a| in all, and four roundings of that, and of its quotient, are below 64 v.
template <bool fused>
[[gnu::always_inline]] inline Twofold quotient(const Twofold& a, const Twofold& b) {
  const double first = a.high / b.high;
  const Twofold p = two_product<fused>(first, b.high);
  return fast_sum(first, (((a.high - p.high) - p.low) + (a.low - first * b.low)) / b.high);
}

/// The double nearest to 1/2 + q, q within `error`; NaN where that leaves a choice.
[[gnu::always_inline]] inline double nearest(const Twofold& q, double error) {
  const Twofold half = two_sum(0.5, q.high);
  const Twofold value = fast_sum(half.high, half.low + q.low);
  if (!(value.high > 0x1p-40 && value.high < 2)) return NAN;
  const double below = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value.high) - 1);
  return std::abs(value.low) + error + 0x1p-104 < (value.high - below) / 2 ? value.high : NAN;
}

/// A line is l_f + (s - 1/2) l_r + (t - 1/2) l_u = 0 in the window, with l_f, l_r, l_u its normal's products with
/// forward, right and up. Two lines a, b meet where
///   (s - 1/2) : (t - 1/2) : 1 = a_u b_f - a_f b_u : a_f b_r - a_r b_f : a_r b_u - a_u b_r.
/// With F, R, U the largest components of the three vectors, products are at most 3 F, within 96 vF (see dot), and so
/// on. In the last minor no product is above 9 RU: with the data's 2 2 3 96 vRU and its own 64 9 vRU it is within 2^11
/// vRU = 2^-95 RU. The others alike: State::place_error.
struct SeenPlace {
  Twofold s{0, 0}, t{0, 0};                       // s - 1/2, t - 1/2
  double s_error = HUGE_VAL, t_error = HUGE_VAL;  // what they are within
};
template <bool fused>
[[gnu::always_inline]] inline SeenPlace seen_place(const State& s, const WindowLine& a, const WindowLine& b) {
  const Twofold depth = minor<fused>(a.right, b.up, a.up, b.right);
  const double depth_error = s.place_error[0], size_of_depth = std::abs(depth.high);
  if (!(size_of_depth > 2 * depth_error)) return {};
  SeenPlace place;
  const auto set = [&](Twofold & q, double& within, const Twofold& x, double error) __attribute__((always_inline)) {
    q = quotient<fused>(x, depth);
    const double size = std::abs(q.high);
    within = 4 * (error + size * depth_error) / size_of_depth + 0x1p-100 * size;
  };
  set(place.s, place.s_error, minor<fused>(a.up, b.forward, a.forward, b.up), s.place_error[1]);
  set(place.t, place.t_error, minor<fused>(a.forward, b.right, a.right, b.forward), s.place_error[2]);
  return place;
}

template <bool fused>
[[gnu::always_inline]] inline const WindowLine& window_line(State& s, SightlineId id) {
  std::uint32_t& at = s.window_line_of[id];
  if (at == none) {
    at = static_cast<std::uint32_t>(s.window_lines.size());
    const Normal n = normal(*s.table, id);
    s.window_lines.push_back({dot<fused>(n, s.frame[0]), dot<fused>(n, s.frame[1]), dot<fused>(n, s.frame[2])});
  }
  return s.window_lines[at];
}

template <bool fused>
[[gnu::always_inline]] inline void filter_places(State& s) {
  s.window_lines.clear();
  s.window_lines.reserve(s.table->size());
  s.window_line_of.assign(s.table->size(), none);
  for (VertexDraft& vertex : s.vertices) {
    const Corner& corner = s.corners[vertex.corner];
    const SeenPlace place = seen_place<fused>(s, window_line<fused>(s, corner.low), window_line<fused>(s, corner.high));
    vertex.st = {nearest(place.s, place.s_error), nearest(place.t, place.t_error)};
  }
}
#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("fma")]] void filter_places_fused(State& s) { filter_places<true>(s); }
bool has_fused() {
  static const bool has = __builtin_cpu_supports("fma");
  return has;
}
#elif defined(__FP_FAST_FMA)
void filter_places_fused(State& s) { filter_places<true>(s); }
constexpr bool has_fused() { return true; }
#else
void filter_places_fused(State& s) { filter_places<false>(s); }
constexpr bool has_fused() { return false; }
#endif

std::array<Integer, 3> exact_ray(const State& s, CornerId c) {
  const Corner& corner = s.corners[c];
  const std::array<Integer, 3> a = s.table->normal(corner.low), b = s.table->normal(corner.high);
  std::array<Integer, 3> r{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const Integer factor = gcd(gcd(r[0], r[1]), r[2]);
  for (Integer& k : r) k = corner.sign * k / factor;
  return r;
}

using Integer3 = std::array<Integer, 3>;
Integer det(const Integer3& a, const Integer3& b, const Integer3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Forward, right and up, times one power of two.
void find_exact_frame(State& s) {
  const glm::dvec3* const given[3] = {&s.camera->forward, &s.camera->right, &s.camera->up};
  int least = std::numeric_limits<int>::max();
  for (std::size_t k = 0; k < 9; ++k) {
    const double x = (*given[k / 3])[static_cast<int>(k % 3)];
    if (x != 0) least = std::min(least, dyadic(x).exponent);
  }
  for (std::size_t k = 0; k < 9; ++k) {
    const Dyadic d = dyadic((*given[k / 3])[static_cast<int>(k % 3)]);
    s.exact_frame[k / 3][k % 3] = d.mantissa == 0 ? Integer(0) : shifted(Integer(d.mantissa), d.exponent - least);
  }
  s.has_exact_frame = true;
}

/// s - 1/2, t - 1/2 as numerators over a common denominator, which comes last.
Integer3 exact_st(State& s, CornerId c) {
  if (!s.has_exact_frame) find_exact_frame(s);
  const Corner& corner = s.corners[c];
  const Integer3 a = s.table->normal(corner.low), b = s.table->normal(corner.high);
  const Integer3 x{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const auto& [forward, right, up] = s.exact_frame;
  return {det(x, up, forward), det(x, forward, right), det(x, right, up)};
}

}  // namespace

void set_frame(State& s) {
  const auto largest = [](const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  s.has_exact_frame = false;
  const Camera& c = *s.camera;
  const glm::dvec3* const given[3] = {&c.forward, &c.right, &c.up};
  int exponent = 0;
  std::frexp(std::max({largest(c.forward), largest(c.right), largest(c.up)}), &exponent);
  double size[3];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) s.frame[i][k] = std::ldexp((*given[i])[k], -exponent);
    size[i] = largest(s.frame[i]);
    // So that lower parts are far above the least double.
    if (size[i] < 0x1p-400) size[i] = HUGE_VAL;
  }
  s.place_error[0] = 0x1p-95 * size[1] * size[2];
  s.place_error[1] = 0x1p-95 * size[2] * size[0];
  s.place_error[2] = 0x1p-95 * size[0] * size[1];
}

namespace {

void place_on_sphere(const State& s, VertexDraft& vertex) {
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
}

/// What the filter left open, and the sides of the window, which are exact.
void finish_place(const State& s, VertexDraft& vertex) {
  const Corner& corner = s.corners[vertex.corner];
  glm::dvec2 st = vertex.st;
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

/// As compare_places, by places twice as long as doubles; uncertain where they agree. After place_vertices, which has
/// left the lines of all vertices behind.
Sign compare_seen(const State& s, CornerId a, CornerId b) {
  const auto line = [&](SightlineId id) -> const WindowLine& { return s.window_lines[s.window_line_of[id]]; };
  const auto place = [&](CornerId id) {
    return seen_place<false>(s, line(s.corners[id].low), line(s.corners[id].high));
  };
  const SeenPlace p = place(a), q = place(b);
  // The difference of two twofold numbers is rounded three times, by u of what is left and u^2 of the numbers.
  const Twofold upper = two_sum(p.s.high, -q.s.high);
  const double difference = upper.high + (upper.low + (p.s.low - q.s.low));
  const double bound = 2 * (p.s_error + q.s_error) + 0x1p-100 * (std::abs(p.s.high) + std::abs(q.s.high));
  return difference > bound ? 1 : difference < -bound ? -1 : uncertain;
}

}  // namespace

void place_vertices(State& s) {
  if (!s.camera) {
    for (VertexDraft& vertex : s.vertices) place_on_sphere(s, vertex);
    return;
  }
  if (has_fused()) {
    filter_places_fused(s);
  } else {
    filter_places<false>(s);
  }
  for (VertexDraft& vertex : s.vertices) finish_place(s, vertex);
}

Sign compare_places(State& s, CornerId a, CornerId b) {
  if (!s.camera) {
    const std::array<Integer, 3> p = exact_ray(s, a), q = exact_ray(s, b);
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] != q[k]) return p[k] < q[k] ? -1 : 1;
    }
    return 0;
  }
  if (const Sign seen = compare_seen(s, a, b); seen != uncertain) return seen;
  const Integer3 p = exact_st(s, a), q = exact_st(s, b);
  const Sign denominators = sgn(p[2]) * sgn(q[2]);
  for (std::size_t k = 0; k < 2; ++k) {
    const Integer difference = p[k] * q[2] - q[k] * p[2];
    if (difference != 0) return sgn(difference) * denominators;
  }
  return 0;
}

}  // namespace sightline::stitching
