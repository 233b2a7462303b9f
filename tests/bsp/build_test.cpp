// The builder on scenes of every kind, each complex proved by check().
#include "bsp/build.hpp"

#include <gtest/gtest.h>

#include <random>

#include "models/model.hpp"
#include "winged_pair/check.hpp"

namespace sightline {
namespace {

using Points = std::vector<glm::dvec3>;

PolygonSoup soup_of(const std::vector<Points>& polygons) {
  PolygonSoup soup;
  for (const Points& polygon : polygons) {
    for (const glm::dvec3& p : polygon) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(p);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

void expect_right(const PolygonSoup& soup, const std::string& what) {
  const Scene scene = make_scene(soup);
  const Complex complex = build(scene);
  const auto faults = check(complex, scene);
  EXPECT_TRUE(faults.empty()) << what << ": " << (faults.empty() ? "" : faults.front());
}

TEST(Build, OnePolygonMakesTwoCells) {
  const Scene scene = make_scene(soup_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
  const Complex complex = build(scene);
  EXPECT_EQ(complex.cells.size(), 2u);
  std::size_t opaque = 0;
  for (const Face& f : complex.faces) opaque += f.label != 0;
  EXPECT_EQ(opaque, 1u);
  EXPECT_TRUE(check(complex, scene).empty());
}

TEST(Build, EmptySceneIsOneCell) {
  PolygonSoup soup = soup_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});  // zero area: dropped
  const Scene scene = make_scene(soup);
  const Complex complex = build(scene);
  EXPECT_EQ(complex.cells.size(), 1u);
  EXPECT_TRUE(check(complex, scene).empty());
}

TEST(Build, CoplanarOverlapsAndDuplicatesShareFaces) {
  const Points square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const Points shifted{{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  const Scene scene = make_scene(soup_of({square, shifted, square}));
  const Complex complex = build(scene);
  EXPECT_TRUE(check(complex, scene).empty());
  bool all_three = false;
  for (const Face& f : complex.faces) all_three |= complex.surfaces_on(f).size() == 3;
  EXPECT_TRUE(all_three);
}

TEST(Build, NamesTheEdgesOfPolygons) {
  const Scene scene = make_scene(soup_of({{{0, 0, 0}, {3, 1, 0}, {1, 4, 2}}}));
  const Complex complex = build(scene);
  std::size_t named = 0;
  for (const Edge& e : complex.edges) named += e.a != none;
  EXPECT_GE(named, 3u);
}

TEST(Build, InterpenetratingTriangles) {
  expect_right(soup_of({{{-2, 0, -1}, {2, 0, -1}, {0, 0, 3}},
                        {{0, -2, -1}, {0, 2, -1}, {0, 0, 2}},
                        {{-2, -1, 0}, {2, -1, 0.5}, {0, 3, 0.25}}}),
               "three through each other");
}

TEST(Build, CyclicOverlap) {
  expect_right(
      soup_of(
          {{{0, 0, 0}, {4, 1, 2}, {0, 1, 0}}, {{4, 0, 0}, {4, 4, 2}, {3, 4, 0}}, {{4, 4, 0}, {0, 3, 2}, {0, 4, 0}}}),
      "cycle");
}

TEST(Build, NearlyCoplanarByOneUlp) {
  const double z = std::nextafter(1.0, 2.0);
  expect_right(soup_of({{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                        {{0.25, 0.25, 1}, {0.75, 0.25, z}, {0.5, 0.75, 1}},
                        {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}}),
               "one ulp apart");
}

TEST(Build, NonConvexAndNonPlanarPolygons) {
  expect_right(
      soup_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}, {{0, 0, 1}, {1, 0, 2}, {1, 1, 1}, {0, 1, 2}}}),
      "arrow and saddle");
}

TEST(Build, ManyThroughOnePoint) {
  std::vector<Points> polygons;
  for (int k = 0; k < 12; ++k) {
    const double x = k - 5.5, y = (k * 7) % 12 - 5.5;
    polygons.push_back({{x, y, 1}, {-x, -y, -1}, {y, -x, 2}});
  }
  expect_right(soup_of(polygons), "triangles through the origin's neighbourhood");
}

TEST(Build, RandomSmallScenes) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 60; ++round) {
    std::vector<Points> polygons;
    const auto range = static_cast<int>(2 + random() % 6);
    const auto coordinate = [&] {
      return static_cast<double>(random() % static_cast<unsigned>(2 * range + 1)) - range;
    };
    for (int k = 0, n = 3 + static_cast<int>(random() % 8); k < n; ++k) {
      polygons.push_back({{coordinate(), coordinate(), coordinate()},
                          {coordinate(), coordinate(), coordinate()},
                          {coordinate(), coordinate(), coordinate()}});
    }
    expect_right(soup_of(polygons), "round " + std::to_string(round));
  }
}

// The floor is cut first, and its faces wait to be named until walls above and below have cut them too.
TEST(Build, ManyPolygonsInOnePlane) {
  std::mt19937_64 random(5);
  std::vector<Points> polygons{{{0, 0, 0}, {24, 0, 0}, {24, 24, 0}, {0, 24, 0}}};
  const auto at = [&](unsigned range) { return static_cast<double>(random() % range); };
  for (int k = 0; k < 120; ++k) {  // tiles and rhombs, apart, side by side, one over the other
    const double x = at(23), y = at(23), w = 1 + at(2);
    if (k % 4 != 0) {
      polygons.push_back({{x, y, 0}, {x + w, y, 0}, {x + w, y + 1, 0}, {x, y + 1, 0}});
    } else {
      polygons.push_back({{x + 1, y, 0}, {x + 2, y + 1, 0}, {x + 1, y + 2, 0}, {x, y + 1, 0}});
    }
  }
  for (int k = 0; k < 24; ++k) {
    const double x = at(24), y = at(20), z = k % 2 == 0 ? 3 : -3;
    polygons.push_back({{x, y, 0}, {x, y + 3, 0}, {x, y + 3, z}, {x, y, z}});
  }
  expect_right(soup_of(polygons), "a floor of tiles");
}

TEST(Build, ModelsAreRightAndOfPaperSize) {
  for (const char* name : {"rooms", "maze", "arena", "city", "floor"}) {
    const Model model = make_model(name);
    const Scene scene = make_scene(model.soup);
    const Complex complex = build(scene);
    EXPECT_TRUE(check(complex, scene).empty()) << name;
    const double n = scene.polygon_count();
    EXPECT_LE(static_cast<double>(complex.cells.size()), n) << name;
    EXPECT_LE(static_cast<double>(complex.faces.size()), 6 * n) << name;
  }
}

TEST(Build, IsDeterministic) {
  const Scene scene = make_scene(make_model("random").soup);
  const Complex a = build(scene), b = build(scene);
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (std::size_t k = 0; k < a.pairs.size(); ++k) {
    EXPECT_EQ(a.pairs[k].edge, b.pairs[k].edge);
    EXPECT_EQ(a.pairs[k].spin[1], b.pairs[k].spin[1]);
  }
}

}  // namespace
}  // namespace sightline
