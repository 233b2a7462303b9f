// Laws 1, 2 and 5 of model.hpp.
#include "tests/models/integer_polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace sightline {
namespace {

using namespace models_test;

struct Case {
  const char* name;
  std::uint32_t polygons;
};

class ModelPolygons : public testing::TestWithParam<Case> {
 protected:
  const Model model = make_model(GetParam().name, {.polygons = GetParam().polygons});
};

/// Sign of the doubled area of a triangle in the plane that is left when one axis is dropped.
int turn(const Vector& a, const Vector& b, const Vector& c, int drop) {
  const Vector u = b - a, v = c - a;
  const int i = (drop + 1) % 3, j = (drop + 2) % 3;
  const Wide area = Wide(u[i]) * v[j] - Wide(u[j]) * v[i];
  return (area > 0) - (area < 0);
}

bool between(const Vector& a, const Vector& p, const Vector& b) {
  for (int k = 0; k < 3; ++k) {
    if (p[k] < std::min(a[k], b[k]) || p[k] > std::max(a[k], b[k])) return false;
  }
  return true;
}

/// Whether two closed segments of one plane have a point in common.
bool meet(const Vector& a, const Vector& b, const Vector& c, const Vector& d, int drop) {
  const int abc = turn(a, b, c, drop), abd = turn(a, b, d, drop), cda = turn(c, d, a, drop), cdb = turn(c, d, b, drop);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, c, b)) || (abd == 0 && between(a, d, b)) || (cda == 0 && between(c, a, d)) ||
         (cdb == 0 && between(c, b, d));
}

TEST_P(ModelPolygons, VerticesAreWeldedUsedAndShort) {
  const PolygonSoup& soup = model.soup;
  std::set<std::array<double, 3>> distinct;
  for (const glm::dvec3& v : soup.vertices) {
    distinct.insert({v.x, v.y, v.z});
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(v[k] * 16, std::floor(v[k] * 16));
      EXPECT_LT(std::abs(v[k] * 16), 1 << 16);
    }
  }
  EXPECT_EQ(distinct.size(), soup.vertices.size());
  std::vector<bool> used(soup.vertices.size());
  for (const std::uint32_t v : soup.corners) used.at(v) = true;
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

TEST_P(ModelPolygons, ArePlanarAndSimple) {
  for (const Polygon& polygon : whole_polygons(model.soup)) {
    const std::vector<Vector>& p = polygon.corners;
    const std::size_t n = p.size();
    ASSERT_GE(n, 3u);
    ASSERT_NE(polygon.normal, Vector(0));
    for (const Vector& corner : p) ASSERT_EQ(dot(polygon.normal, corner - p[0]), 0);
    const int drop = polygon.normal.x != 0 ? 0 : polygon.normal.y != 0 ? 1 : 2;
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_NE(turn(p[i], p[(i + 1) % n], p[(i + 2) % n], drop), 0) << "a corner that is none";
      for (std::size_t j = i + 2; j < n && j < i + n - 1; ++j) {
        ASSERT_FALSE(meet(p[i], p[i + 1], p[j], p[(j + 1) % n], drop));
      }
    }
  }
}

TEST_P(ModelPolygons, BelongToNamedObjects) {
  const PolygonSoup& soup = model.soup;
  ASSERT_EQ(soup.object_of.size(), soup.first.size() - 1);
  std::vector<bool> used(soup.objects.size());
  std::uint32_t seen = 0;
  for (const std::uint32_t object : soup.object_of) {
    ASSERT_LT(object, soup.objects.size());
    ASSERT_LE(object, seen) << "names are in order of appearance";
    seen = std::max(seen, object + 1);
    used[object] = true;
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  EXPECT_EQ(std::set<std::string>(soup.objects.begin(), soup.objects.end()).size(), soup.objects.size());
  EXPECT_FALSE(soup.source.empty());
}

INSTANTIATE_TEST_SUITE_P(Models, ModelPolygons,
                         testing::Values(Case{"rooms", 0}, Case{"maze", 0}, Case{"maze", 3000}, Case{"arena", 0},
                                         Case{"city", 0}, Case{"city", 20000}, Case{"floor", 0}, Case{"building", 100},
                                         Case{"building", 0}, Case{"building", 40000}, Case{"tower", 0},
                                         Case{"campus", 0}, Case{"random", 0}, Case{"random", 3000}),
                         [](const auto& test) {
                           return std::string(test.param.name) + "_" + std::to_string(test.param.polygons);
                         });

}  // namespace
}  // namespace sightline
