// Which stage decides: identity before arithmetic, filters for the generic, exact arithmetic of the right width for
// the degenerate.
#include "tables.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

// Random points of B bits and a plane through three of them; a fourth point lies in it by chance of construction.
struct Flat {
  std::vector<glm::dvec3> world;
  explicit Flat(int bits, std::uint64_t seed) {
    Random random(seed);
    const auto any = [&] {
      const auto m = static_cast<std::int64_t>(random() >> (66 - bits)) - (std::int64_t{1} << (bits - 3));
      return static_cast<double>(m);
    };
    for (int i = 0; i < 3; ++i) world.emplace_back(any(), any(), any());
    world.push_back(world[0] + world[1] - world[2]);  // coplanar
    for (int i = 0; i < 6; ++i) world.emplace_back(any(), any(), any());
  }
};

std::uint64_t exact_total(const Tally& t) {
  std::uint64_t sum = 0;
  for (const std::uint64_t n : t.exact) sum += n;
  return sum;
}

// The place in Tally::exact of the least width that holds `bits` and a sign.
std::size_t stage_of(int bits) {
  std::size_t i = 0;
  while (Tally::widths[i] != 0 && bits >= Tally::widths[i]) ++i;
  return i;
}

class Stages : public testing::TestWithParam<int> {};

TEST_P(Stages, FilterForTheGenericExactForZeros) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const Flat flat(GetParam(), seed);
    const Grid grid = Grid::covering(flat.world);
    const PointTable points(grid, flat.world);
    PlaneTable planes(points);
    const PlaneId p = planes.add_points(0, 1, 2).id;
    Tally before = tally();
    EXPECT_EQ(point_side(planes, 3, p), 0);
    Tally spent = tally() - before;
    EXPECT_EQ(spent.filter, 0u);
    const int bits =
        std::max(static_cast<int>(planes.normal_bits(p)) + points.bits() + 2, static_cast<int>(planes.offset_bits(p))) +
        1;
    EXPECT_EQ(spent.exact[stage_of(bits)], 1u);
    EXPECT_EQ(exact_total(spent), 1u);

    before = tally();
    EXPECT_NE(point_side(planes, 4, p), 0);
    spent = tally() - before;
    EXPECT_EQ(spent.filter, 1u);
    EXPECT_EQ(exact_total(spent), 0u);

    // Four planes through one point: a vertex on a plane that is none of its own.
    const PlaneId a = planes.add_points(0, 4, 5).id, b = planes.add_points(0, 6, 7).id,
                  c = planes.add_points(0, 8, 9).id;
    const ImplicitVertex v = make_vertex(planes, a, b, c);
    before = tally();
    EXPECT_EQ(vertex_side(planes, v, a), 0);
    EXPECT_EQ((tally() - before).identity, 1u);
    before = tally();
    EXPECT_EQ(vertex_side(planes, v, p), 0);
    spent = tally() - before;
    EXPECT_EQ(spent.filter + spent.identity, 0u);
    EXPECT_EQ(exact_total(spent), 1u);
    const PlaneId far = planes.add_points(4, 7, 9).id;
    before = tally();
    EXPECT_NE(vertex_side(planes, v, far), 0);
    EXPECT_EQ((tally() - before).filter, 1u);

    // Three lines through one point of the scene.
    SightlineTable table(planes);
    table.reset(planes, grid.point(flat.world[9]));
    const auto x = table.of_points(0, 4), y = table.of_points(0, 5), z = table.of_points(0, 6);
    before = tally();
    EXPECT_EQ(table.order(x, y, z), 0);
    spent = tally() - before;
    EXPECT_EQ(spent.exact[stage_of(static_cast<int>(table.bits(x.id) + table.bits(y.id) + table.bits(z.id)) + 3)], 1u);
    EXPECT_EQ(spent.filter + spent.identity, 0u);
    before = tally();
    EXPECT_NE(table.order(x, y, table.of_points(4, 7)), 0);
    EXPECT_EQ((tally() - before).filter, 1u);
  }
}

INSTANTIATE_TEST_SUITE_P(Bits, Stages, testing::Values(8, 15, 20, 27, 30, 40, 53));

// The eye's side of a plane is computed once for each reset.
TEST(Stages, EyeSideIsRemembered) {
  const Flat flat(20, 3);
  const Grid grid = Grid::covering(flat.world);
  const PointTable points(grid, flat.world);
  PlaneTable planes(points);
  const PlaneId p = planes.add_points(0, 1, 2).id;
  SightlineTable table(planes);
  table.reset(planes, grid.point(flat.world[3]));
  const Tally before = tally();
  EXPECT_EQ(table.eye_side(p), 0);
  EXPECT_EQ(exact_total(tally() - before), 1u);
  EXPECT_EQ(table.eye_side(p), 0);
  EXPECT_EQ(exact_total(tally() - before), 1u);
}

// The arbitrary end: coordinates from 1e-300 to 1e300.
TEST(Stages, AnyLength) {
  const std::vector<glm::dvec3> world{
      {1e300, 1e-300, 1}, {1, 1e300, 1e-300}, {1e-300, 1, 1e300}, {2e300, 2e-300, 2}, {0, 0, 0}};
  const Grid grid = Grid::covering(world);
  const PointTable points(grid, world);
  PlaneTable planes(points);
  const PlaneId p = planes.add_points(0, 4, 1).id;
  const Tally before = tally();
  EXPECT_EQ(point_side(planes, 3, p), 0);
  EXPECT_EQ((tally() - before).exact.back(), 1u);
  SightlineTable table(planes);
  table.reset(planes, grid.point(world[4]));
  EXPECT_EQ(table.of_points(0, 3).id, none);
  EXPECT_EQ(table.of_points(0, 1).id, table.of_points(3, 1).id);
}

}  // namespace
}  // namespace sightline::test
