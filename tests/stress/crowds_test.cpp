// Thousands of polygons in one plane, through one point, through one line. Short runs take hundreds; with
// SIGHTLINE_STRESS=10 or more there are as many as the names say.
#include <gtest/gtest.h>

#include "tests/stress/figures.hpp"
#include "tests/stress/judge.hpp"

namespace sightline::stress {
namespace {

bool whole_size() { return times(1) >= 10; }

/// From above, from aside and from near by.
void judge(const PolygonSoup& soup, const glm::dvec3& middle, double height, bool complex, const std::string& name) {
  Court court(soup, {}, {.complex = complex, .oracle = false});
  court.check(aimed(middle + glm::dvec3{0.5, 0.25, height}, middle, 2), name + " from above");
  court.check(aimed(middle + glm::dvec3{0.9, -0.7, 0.6} * height, middle, 2), name + " from aside");
  court.check(aimed(middle + glm::dvec3{0.5, 0.25, 0.125}, middle, 3), name + " from near by");
}

TEST(StressCrowds, TenThousandCoplanar) {
  Random random(1);
  const int count = whole_size() ? 10000 : 150;
  const double half = count / 2;
  judge(coplanar_crowd(random, count, count), {half, half, 0}, count, !whole_size(), "coplanar");
  const int range = whole_size() ? 200 : 25;
  judge(coplanar_crowd(random, count, range), {range / 2, range / 2, 0}, range, !whole_size(), "coplanar and dense");
}

TEST(StressCrowds, ThousandsThroughAPoint) {
  Random random(2);
  judge(crowd_through_a_point(random, whole_size() ? 100 : 15, false), {0, 0, 0}, 200, true, "crossing in a point");
  judge(crowd_through_a_point(random, whole_size() ? 1000 : 40, true), {0, 0, 0}, 200, !whole_size(),
        "with a common corner");
}

TEST(StressCrowds, ThousandsThroughALine) {
  Random random(3);
  for (const bool sharing : {false, true}) {
    const std::string name = sharing ? "with a common side" : "crossing in a line";
    judge(crowd_through_a_line(random, whole_size() ? 200 : 40, sharing), {0, 0, 0}, 1500, true, name);
    const PolygonSoup book = crowd_through_a_line(random, whole_size() ? 5000 : 100, sharing);
    Court court(book, {}, {.complex = !whole_size(), .oracle = false});
    court.check(aimed({1500, -1700, 800}, {0, 0, 100}, 1), name + ", more of them, from aside");
    court.check(aimed({0.5, 0.25, 0.125}, {0, 0, 0}, 3), name + ", more of them, from near by");
  }
}

}  // namespace
}  // namespace sightline::stress
