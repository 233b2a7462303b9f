// The laws of exact/grid.hpp, by their numbers, and of the point table.
#include "tables.hpp"

#include "exact/rounding.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sightline::test {
namespace {

RandomScene any_scene(std::uint64_t seed) { return RandomScene(seed, bit_lengths[seed % bit_lengths.size()]); }

// Law 1: world(point(p)) = p for the grid's points; they need no refinement.
RC_GTEST_PROP(GridLaws, Law1RoundTrip, (std::uint64_t seed)) {
  const RandomScene scene = any_scene(seed);
  const Grid grid = Grid::covering(scene.points);
  for (const glm::dvec3& p : scene.points) {
    const GridPoint g = grid.point(p);
    RC_ASSERT(g.shift == 0);
    for (int k = 0; k < 3; ++k) RC_ASSERT(grid.world(g.c[static_cast<std::size_t>(k)], k) == p[k]);
    std::array<std::int64_t, 3> quick;
    if (grid.short_point(p, quick))
      for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(Integer(quick[k]) == g.c[k]);
  }
}

// Law 2: differences of points are those of the doubles, in steps, whatever the origin; also for finer points.
RC_GTEST_PROP(GridLaws, Law2Differences, (std::uint64_t seed)) {
  const RandomScene scene = any_scene(seed);
  const Grid grid = Grid::covering(scene.points);
  const GridPoint a = grid.point(scene.points[0]), b = grid.point(scene.eye);
  const mpq_class step(grid.step());
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<int>(k);
    const mpq_class difference = mpq_class(scene.eye[i]) - mpq_class(scene.points[0][i]);
    const mpq_class fine = mpq_class(b.c[k], Integer(1) << static_cast<unsigned>(b.shift));
    mpq_class canonical = fine;
    canonical.canonicalize();
    RC_ASSERT((canonical - mpq_class(a.c[k])) * step == difference);
  }
}

// Law 3: bits() is the length of the longest coordinate; unit coordinates of the enlarged box are at most 1/2.
RC_GTEST_PROP(GridLaws, Law3Bounds, (std::uint64_t seed)) {
  const RandomScene scene = any_scene(seed);
  const Grid grid = Grid::covering(scene.points);
  std::uint32_t longest = 0;
  std::array<Integer, 3> low, high;
  bool first = true;
  for (const glm::dvec3& p : scene.points) {
    const GridPoint g = grid.point(p);
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, magnitude_bits(g.c[k]));
      low[k] = first ? g.c[k] : std::min(low[k], g.c[k]);
      high[k] = first ? g.c[k] : std::max(high[k], g.c[k]);
    }
    first = false;
  }
  RC_ASSERT(static_cast<int>(longest) == grid.bits());
  Integer extent = 0;
  for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, Integer(high[k] - low[k]));
  const Integer margin = std::max(Integer(1), Integer((extent + 1) / 2)),
                half = Integer(1) << static_cast<unsigned>(grid.unit_bits() - 1);
  for (std::size_t k = 0; k < 3; ++k) {
    RC_ASSERT(high[k] + margin <= half);
    RC_ASSERT(margin - low[k] <= half);
  }
}

// Law 4: a snap takes the nearest multiple (ties to even), and snapping a snapped point changes nothing.
RC_GTEST_PROP(GridLaws, Law4Snap, (std::uint64_t seed)) {
  const RandomScene scene(seed, 30);
  Random random(seed);
  const char* const units[] = {"1", "0.25", "1e-6", "3", ".1", "2.5e3", "7e-2"};
  const char* const text = units[random() % std::size(units)];
  const Grid grid = Grid::snapped(scene.points, text);
  RC_ASSERT(grid.snap() == text);
  const mpq_class unit[] = {mpq_class(1),     mpq_class(1, 4),    mpq_class(1, 1000000), mpq_class(3),
                            mpq_class(1, 10), mpq_class(2500, 1), mpq_class(7, 100)};
  std::size_t which = 0;
  while (units[which] != text) ++which;
  for (const glm::dvec3& p : scene.points) {
    const GridPoint g = grid.point(p);
    RC_ASSERT(g.shift == 0);
    glm::dvec3 moved;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<int>(k);
      const mpq_class off = abs((mpq_class(g.c[k]) + mpq_class(grid.origin()[k])) - mpq_class(p[i]) / unit[which]);
      RC_ASSERT(off <= mpq_class(1, 2));
      RC_ASSERT(grid.world(Integer(-7 * g.c[k]), -7, i) == grid.world(g.c[k], i));
      const Integer whole = g.c[k] + grid.origin()[k];
      RC_ASSERT(off < mpq_class(1, 2) || mpz_even_p(whole.get_mpz_t()) != 0);
      moved[i] = grid.world(g.c[k], i);
    }
    RC_ASSERT(grid.point(moved).c == g.c);
  }
}

// Law 5 (of the point table): points are equal just if their doubles are; approximations are within 2^-54.
RC_GTEST_PROP(GridLaws, Law5PointTable, (std::uint64_t seed)) {
  const RandomScene scene = any_scene(seed);
  const Grid grid = Grid::covering(scene.points);
  const PointTable points(grid, scene.points);
  const mpq_class unit(Integer(1) << static_cast<unsigned>(grid.unit_bits())), tolerance(0x1p-54);
  for (PointId a = 0; a < points.size(); ++a) {
    RC_ASSERT(points.point(a) == grid.point(scene.points[a]).c);
    for (int k = 0; k < 3; ++k) {
      const mpq_class exact = mpq_class(points.point(a)[static_cast<std::size_t>(k)]) / unit;
      RC_ASSERT(abs(mpq_class(points.approx(a)[k]) - exact) <= tolerance);
      RC_ASSERT(points.coordinate(a, k).bits <= static_cast<std::uint32_t>(grid.bits()));
    }
    for (PointId b = 0; b < points.size(); ++b) RC_ASSERT(points.equal(a, b) == (scene.points[a] == scene.points[b]));
  }
}

TEST(Grid, Ends) {
  const Grid empty = Grid::covering({});
  EXPECT_EQ(empty.bits(), 0);
  EXPECT_EQ(empty.step(), 1.0);
  EXPECT_EQ(empty.world(Integer(5), 0), 5.0);
  const std::vector<glm::dvec3> one{{1e300, 1e-300, -0.0}};
  const Grid grid = Grid::covering(one);
  EXPECT_EQ(grid.bits(), 0);
  const std::vector<glm::dvec3> wide{{1e300, -1e300, 5e-324}, {1e-300, 1, 0}};
  const Grid mixed = Grid::covering(wide);
  EXPECT_GT(mixed.bits(), 2000);
  for (const auto& p : wide)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(mixed.world(mixed.point(p).c[static_cast<std::size_t>(k)], k), p[k]);
  EXPECT_EQ(mixed.unit(wide[1]).x, nearest_double(mixed.point(wide[1]).c[0], -mixed.unit_bits()));
}

TEST(Grid, Refuses) {
  const std::vector<glm::dvec3> good{{1, 2, 3}}, nan{{1, NAN, 0}}, infinite{{0, 0, INFINITY}};
  EXPECT_THROW((void)Grid::covering(nan), std::invalid_argument);
  EXPECT_THROW((void)Grid::covering(infinite), std::invalid_argument);
  for (const char* unit : {"", "0", "-1", "1e", "e5", "1.2.3", "0x10", "nan", "1e99999", " 1", "0.000", "."})
    EXPECT_THROW((void)Grid::snapped(good, unit), std::invalid_argument) << unit;
  const std::vector<glm::dvec3> other{{1, 2, 3.5}}, far{{1e6, 0, 0}};
  EXPECT_THROW(PointTable(Grid::covering(good), other), std::invalid_argument);
  EXPECT_THROW(PointTable(Grid::covering(good), far), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::test
