// Thousands of polygons in one plane, through one point, through one line. Short runs take hundreds; with
// SIGHTLINE_STRESS=10 or more there are as many as the names say.
#include <gtest/gtest.h>

#include "tests/stress/figures.hpp"
#include "tests/stress/judge.hpp"

namespace sightline::stress {
namespace {

bool whole_size() { return times(1) >= 10; }

void judge(const PolygonSoup& soup, const Judges& judges, const std::string& name) {
  Court court(soup, {}, judges);
  const glm::dvec3 middle = soup.vertices[0];
  court.check(aimed(middle + glm::dvec3{90, -70, 130}, middle, 2), name + " from outside");
  court.check(aimed(middle, middle + glm::dvec3{1, 2, -1}, 2), name + " from a corner");
  court.check(aimed(middle + glm::dvec3{0.5, 0.25, 0.125}, middle, 3), name + " from near by");
}

TEST(StressCrowds, TenThousandCoplanar) {
  Random random(1);
  const int count = whole_size() ? 10000 : 100;
  judge(coplanar_crowd(random, count, count), {.complex = !whole_size(), .oracle = false}, "coplanar");
  const PolygonSoup dense = coplanar_crowd(random, count, whole_size() ? 200 : 20);
  judge(dense, {.complex = !whole_size(), .oracle = false}, "coplanar and dense");
}

TEST(StressCrowds, ThousandsThroughAPoint) {
  Random random(2);
  judge(crowd_through_a_point(random, whole_size() ? 100 : 12, false), {.oracle = false}, "crossing in a point");
  judge(crowd_through_a_point(random, whole_size() ? 200 : 12, true), {.oracle = false}, "with a common corner");
}

TEST(StressCrowds, ThousandsThroughALine) {
  Random random(3);
  const int count = whole_size() ? 2000 : 60;
  judge(crowd_through_a_line(random, count, false), {.complex = !whole_size(), .oracle = false}, "crossing in a line");
  judge(crowd_through_a_line(random, count, true), {.complex = !whole_size(), .oracle = false}, "with a common side");
}

}  // namespace
}  // namespace sightline::stress
