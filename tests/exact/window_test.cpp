// The window's laws, and its points against GMP.
#include "tables.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sightline::test {
namespace {

struct Camera {
  glm::dvec3 forward, right, up;
  static Camera random(Random& random, int bits) {
    const auto any = [&] {
      const auto m = static_cast<std::int64_t>(random() >> (64 - bits)) - (std::int64_t{1} << (bits - 1));
      return std::ldexp(static_cast<double>(m), -bits);
    };
    Camera c;
    do {
      c = {{any(), any(), any()}, {any(), any(), any()}, {any(), any(), any()}};
      if (below(random, 3) == 0) c = {{any(), 0, 0}, {0, any(), 0}, {0, 0, any()}};
    } while (is_zero_volume(c));
    return c;
  }
  static bool is_zero_volume(const Camera& c) { return triple(exact(c.right), exact(c.up), exact(c.forward)) == 0; }
  static Vector exact(const glm::dvec3& v) {  // times 2^200
    Vector r;
    for (std::size_t k = 0; k < 3; ++k) {
      int e = 0;
      const double m = std::frexp(v[static_cast<int>(k)], &e);
      r[k] = mpz_class(std::ldexp(m, 53));
      if (m != 0) r[k] <<= static_cast<mp_bitcnt_t>(147 + e);
    }
    return r;
  }
  Window window() const { return Window(forward, right, up); }
};

// A double's value; infinity, to which rounding goes from halfway beyond the largest double, stands for 2^1024.
mpq_class value_of(double x) {
  if (std::isfinite(x)) return mpq_class(x);
  const mpz_class beyond = mpz_class(1) << 1024;
  return x > 0 ? beyond : -beyond;
}

// Is `found` a nearest double of n / d? Compares the distances to both neighbours exactly; ties ask for an even one.
bool is_nearest(double found, const mpz_class& n, const mpz_class& d) {
  if (std::isnan(found)) return false;
  mpq_class truth(n * sgn(d), abs(d));
  truth.canonicalize();
  const mpq_class off = abs(value_of(found) - truth);
  for (const double to : {-INFINITY, INFINITY}) {
    const mpq_class other = abs(value_of(std::nextafter(found, to)) - truth);
    if (other < off) return false;
    if (other == off && (std::bit_cast<std::uint64_t>(found) & 1u) != 0) return false;
  }
  return true;
}

class WindowByBits : public testing::TestWithParam<int> {};

TEST_P(WindowByBits, PointsAreNearestDoubles) {
  Count count, forwards;
  std::optional<SightlineTable> table;
  for (std::uint64_t seed = 1; std::min(count.cases, forwards.cases) < cases_at(GetParam()); ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam(), 6);
    Random random(seed);
    if (!table) table.emplace(b.planes);
    table->reset(b.planes, b.grid.point(b.scene.eye));
    const Camera camera = Camera::random(random, below(random, 2) == 0 ? 26 : 4);
    const Window window = camera.window();
    const Vector f = Camera::exact(camera.forward), r = Camera::exact(camera.right), up = Camera::exact(camera.up);
    std::vector<SightlineRef> lines;
    for (const auto side : {Window::left, Window::right, Window::bottom, Window::top})
      lines.push_back(window.side(*table, side));
    for (int i = 0; i < 6; ++i) {
      const auto ref = table->of_points(static_cast<PointId>(random() % 10), static_cast<PointId>(random() % 10));
      if (ref.id != none) lines.push_back(ref);
    }
    for (const SightlineRef x : lines)
      for (const SightlineRef y : lines) {
        if (x.id == y.id) continue;
        const auto nx = table->normal(x.id), ny = table->normal(y.id);
        const Vector ray = cross_product({ny[0] * y.sign, ny[1] * y.sign, ny[2] * y.sign},
                                         {nx[0] * x.sign, nx[1] * x.sign, nx[2] * x.sign});
        const mpz_class depth = product(ray, cross_product(r, up)), volume = product(f, cross_product(r, up));
        forwards.check(window.forwardness(*table, x, y), sgn(depth) * sgn(volume));
        const glm::dvec2 st = window.st(*table, x.id, y.id);
        if (depth == 0) {
          EXPECT_TRUE(std::isnan(st.x) && std::isnan(st.y));
          continue;
        }
        const mpz_class s = depth + 2 * product(ray, cross_product(up, f)), two = 2 * depth;
        const mpz_class t = depth + 2 * product(ray, cross_product(f, r));
        const bool good = is_nearest(st.x, s, two) && is_nearest(st.y, t, two);
        count.check(good ? sgn(s) : 2, sgn(s));
      }
  }
  report_cases("st", GetParam(), count);
  report_cases("forwardness", GetParam(), forwards);
}

INSTANTIATE_TEST_SUITE_P(Bits, WindowByBits, testing::Values(8, 20, 30, 53, 60, 110, 200, 2000));

// Law 1: the corners of the window are (0,0), (1,0), (0,1), (1,1), exactly.
RC_GTEST_PROP(WindowLaws, Law1Corners, (std::uint64_t seed)) {
  Random random(seed);
  const Bench b(seed, 20, 0);
  SightlineTable table(b.planes);
  table.reset(b.planes, b.grid.point(b.scene.eye));
  const Window w = Camera::random(random, 26).window();
  const auto at = [&](Window::Side x, Window::Side y) { return w.st(table, w.side(table, x).id, w.side(table, y).id); };
  RC_ASSERT(at(Window::left, Window::bottom) == glm::dvec2(0, 0));
  RC_ASSERT(at(Window::bottom, Window::right) == glm::dvec2(1, 0));
  RC_ASSERT(at(Window::left, Window::top) == glm::dvec2(0, 1));
  RC_ASSERT(at(Window::right, Window::top) == glm::dvec2(1, 1));
}

// Law 2: every corner of the window lies on the inner side of the two other sides.
RC_GTEST_PROP(WindowLaws, Law2SidesPointInwards, (std::uint64_t seed)) {
  Random random(seed);
  const Bench b(seed, 20, 0);
  SightlineTable table(b.planes);
  const Window w = Camera::random(random, 26).window();
  const std::array<SightlineRef, 4> ccw{w.side(table, Window::bottom), w.side(table, Window::right),
                                        w.side(table, Window::top), w.side(table, Window::left)};
  for (std::size_t i = 0; i < 4; ++i) {
    const SightlineRef here = ccw[i], next = ccw[(i + 1) % 4];
    for (std::size_t k = 2; k < 4; ++k) RC_ASSERT(w.handedness() * table.order(next, here, ccw[(i + k) % 4]) == 1);
    RC_ASSERT(w.handedness() * w.forwardness(table, here, next) == 1);
  }
}

// Law 3: a common power of two in the three vectors changes nothing.
RC_GTEST_PROP(WindowLaws, Law3Scale, (std::uint64_t seed)) {
  Random random(seed);
  const Bench b(seed, 20, 0);
  SightlineTable table(b.planes);
  const Camera c = Camera::random(random, 26);
  const double scale = std::ldexp(1.0, below(random, 60) - 30);
  const Window w = c.window(), v(c.forward * scale, c.right * scale, c.up * scale);
  for (const auto side : {Window::left, Window::right, Window::bottom, Window::top})
    RC_ASSERT(w.side(table, side) == v.side(table, side));
  RC_ASSERT(w.handedness() == v.handedness());
}

// Law 4: the mirrored camera (right negated) has the other handedness, and left and right exchanged.
RC_GTEST_PROP(WindowLaws, Law4Mirror, (std::uint64_t seed)) {
  Random random(seed);
  const Bench b(seed, 20, 0);
  SightlineTable table(b.planes);
  const Camera c = Camera::random(random, 26);
  const Window w = c.window(), m(c.forward, -c.right, c.up);
  RC_ASSERT(m.handedness() == -w.handedness());
  RC_ASSERT(m.side(table, Window::left) == w.side(table, Window::right));
  RC_ASSERT(m.side(table, Window::right) == w.side(table, Window::left));
  RC_ASSERT(m.side(table, Window::top) == w.side(table, Window::top));
}

TEST(Window, RefusesDependentAndInfiniteVectors) {
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0);
  EXPECT_THROW(Window(x, y, x + y), std::invalid_argument);
  EXPECT_THROW(Window(x, y, glm::dvec3(0)), std::invalid_argument);
  EXPECT_THROW(Window(x, y, glm::dvec3(0, 0, INFINITY)), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::test
