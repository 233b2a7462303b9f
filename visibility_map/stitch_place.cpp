// Where a vertex is seen, rounded once.
#include "exact/rounding.hpp"
#include "visibility_map/seen_place.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace sightline::stitching {
namespace {

/// The double nearest to 1/2 + q, q within `error`; NaN where that leaves a choice.
[[gnu::always_inline]] inline double nearest(const Twofold& q, double error) {
  const Twofold half = two_sum(0.5, q.high);
  const Twofold value = fast_sum(half.high, half.low + q.low);
  if (!(value.high > 0x1p-40 && value.high < 2)) return NAN;
  const double below = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value.high) - 1);
  return std::abs(value.low) + error + 0x1p-104 < (value.high - below) / 2 ? value.high : NAN;
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

}  // namespace sightline::stitching
