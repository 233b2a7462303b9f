// Sightlines against GMP: every decision of many degenerate scenes and eyes.
#include "support.hpp"
#include "tables.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

class SightlinesByBits : public testing::TestWithParam<int> {
 protected:
  static long wanted() { return cases_at(GetParam()); }
  static void report(const char* what, const Count& c) { report_cases(what, GetParam(), c); }
};

// Lines of one scene and eye, with the oracle's normals.
struct Lines {
  SightlineTable& table;
  std::vector<SightlineRef> ref;
  std::vector<Vector> normal;

  Lines(const Bench& b, SightlineTable& t, std::uint64_t seed) : table(t) {
    table.reset(b.planes, b.grid.point(b.scene.eye));
    Random random(seed);
    const auto any = [&] { return static_cast<PointId>(random() % b.points.size()); };
    for (int i = 0; i < 10; ++i) {
      const PointId p = any(), q = any();
      add(table.of_points(p, q), b.oracle.sightline(p, q));
      if (b.ids.size() < 2) continue;
      const PlaneId f = b.ids[random() % b.ids.size()], g = b.ids[random() % b.ids.size()];
      if (i % 2 == 0) add(table.of_planes(f, g), b.oracle.sightline(b.exact[f], b.exact[g]));
      if (Oracle::side(b.exact[f], b.oracle.eye) == 0) add(table.of_plane(f), b.exact[f].n);
    }
  }
  void add(SightlineRef r, const Vector& n) {
    EXPECT_EQ(r.id == none, is_zero(n));
    if (r.id == none) return;
    ref.push_back(r);
    normal.push_back(n);
  }
};

TEST_P(SightlinesByBits, OrderAndIdentity) {
  Count orders, equals;
  std::optional<SightlineTable> table;
  for (std::uint64_t seed = 1; std::min(orders.cases, equals.cases) < wanted(); ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam(), 6);
    if (!table) table.emplace(b.planes);
    const Lines lines(b, *table, seed);
    const std::size_t n = lines.ref.size();
    Random random(seed);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const bool one = is_zero(cross_product(lines.normal[i], lines.normal[j]));
        equals.check(lines.ref[i].id == lines.ref[j].id ? 0 : 1, one ? 0 : 1);
        if (one) {
          const int along = sgn(product(lines.normal[i], lines.normal[j]));
          EXPECT_EQ(lines.ref[i].sign * lines.ref[j].sign, along);
        }
      }
    for (int i = 0; n > 0 && i < 100; ++i) {
      const std::size_t x = random() % n, y = random() % n, z = random() % n;
      orders.check(table->order(lines.ref[x], lines.ref[y], lines.ref[z]),
                   sgn(triple(lines.normal[x], lines.normal[y], lines.normal[z])));
    }
  }
  report("order", orders);
  report("equal lines", equals);
}

TEST_P(SightlinesByBits, Sides) {
  Count sides, eyes, eye_points;
  std::optional<SightlineTable> table;
  for (std::uint64_t seed = 1; std::min({sides.cases, eyes.cases, eye_points.cases}) < wanted(); ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam(), 8);
    if (!table) table.emplace(b.planes);
    const Lines lines(b, *table, seed);
    for (int again = 0; again < 2; ++again)
      for (const PlaneId q : b.ids) eyes.check(table->eye_side(q), Oracle::side(b.exact[q], b.oracle.eye));
    for (PointId p = 0; p < b.points.size(); ++p) {
      const Vector ray = minus(b.oracle.point[p], b.oracle.eye);
      eye_points.check(table->is_eye(p) ? 0 : 1, is_zero(ray) ? 0 : 1);
      for (std::size_t i = 0; i < lines.ref.size(); ++i)
        sides.check(table->side(lines.ref[i], p), sgn(product(lines.normal[i], ray)));
    }
  }
  report("side", sides);
  report("eye_side", eyes);
  report("is_eye", eye_points);
}

INSTANTIATE_TEST_SUITE_P(Bits, SightlinesByBits, testing::ValuesIn(bit_lengths));

}  // namespace
}  // namespace sightline::test
