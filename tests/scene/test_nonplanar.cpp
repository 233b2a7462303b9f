// Polygons whose vertices do not lie in one plane, as triangles.
#include "flat_geometry.hpp"

#include "scene/triangulate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

namespace sightline::test {
namespace {

PolygonSoup soup_of(const std::vector<glm::dvec3>& loop) {
  PolygonSoup soup;
  soup.vertices = loop;
  for (std::uint32_t k = 0; k < loop.size(); ++k) soup.corners.push_back(k);
  soup.first.push_back(static_cast<std::uint32_t>(loop.size()));
  return soup;
}

/// The vertices of each triangle, ascending.
std::vector<std::set<PointId>> triangles(const Scene& scene) {
  std::vector<std::set<PointId>> result;
  for (const Surface& s : scene.surfaces(0)) {
    auto& t = result.emplace_back();
    for (const SurfaceEdge& e : scene.edges(s)) t.insert({e.a, e.b});
    EXPECT_EQ(t.size(), 3u);
  }
  return result;
}

using Sets = std::vector<std::set<PointId>>;

TEST(Nonplanar, AFanFromTheFirstVertex) {
  const Scene scene = make_scene(soup_of({{0, 0, 0}, {2, 0, 0}, {3, 2, 0.1}, {1, 3, 0}, {-1, 1, 0}}));
  EXPECT_FALSE(scene.planar(0));
  EXPECT_EQ(scene.report().nonplanar, 1u);
  EXPECT_EQ(scene.report().nonconvex, 0u);
  EXPECT_EQ(triangles(scene), (Sets{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  for (const Surface& s : scene.surfaces(0)) {
    expect_sound_surface(scene, s);
    EXPECT_EQ(s.flipped, slope_of(scene, s) < 0);  // counter-clockwise seen from above
  }
}

TEST(Nonplanar, ClockwiseIsFlipped) {
  const Scene scene = make_scene(soup_of({{0, 0, 0}, {0, 2, 0}, {2, 2, 0.5}, {2, 0, 0}}));
  ASSERT_EQ(scene.surfaces(0).size(), 2u);
  for (const Surface& s : scene.surfaces(0)) {
    expect_sound_surface(scene, s);
    EXPECT_EQ(s.flipped, slope_of(scene, s) > 0);
  }
}

TEST(Nonplanar, AFanFromAReflexVertexThatSeesAll) {
  const Scene scene = make_scene(soup_of({{1, 1, 0}, {0, 4, 0}, {0, 0, 0.1}, {4, 0, 0}}));
  EXPECT_EQ(triangles(scene), (Sets{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Nonplanar, EarsWhereTheFanFoldsOver) {
  // An arrow head whose first vertex is beside the notch: the fan's triangle 0 1 2 would lie outside.
  const Scene scene = make_scene(soup_of({{4, 0, 0}, {1, 1, 0}, {0, 4, 0.1}, {0, 0, 0}}));
  EXPECT_EQ(scene.surfaces(0).size(), 2u);
  for (const auto& t : triangles(scene)) EXPECT_TRUE(t.count(1) && t.count(3));
  for (const Surface& s : scene.surfaces(0)) expect_sound_surface(scene, s);
}

TEST(Nonplanar, AKeyholeIsCutIntoEars) {
  const Scene scene = make_scene(soup_of({{0, 0, 0},
                                          {6, 0, 0},
                                          {6, 6, 0.25},
                                          {0, 6, 0},
                                          {0, 0, 0},
                                          {2, 2, 0},
                                          {2, 4, 0},
                                          {4, 4, 0},
                                          {4, 2, 0},
                                          {2, 2, 0}}));
  mpq_class sum;
  for (const Surface& s : scene.surfaces(0)) {
    expect_sound_surface(scene, s);
    EXPECT_EQ(axis_of(scene, s), 2);
    sum += abs(twice_area(flat_corners(scene, s)));
  }
  EXPECT_EQ(sum, abs(twice_area(flat_loop(scene, 0, 2))));
}

TEST(Nonplanar, WhatCrossesItselfIsAFanAllTheSame) {
  const Scene scene = make_scene(soup_of({{0, 0, 0}, {4, 4, 0}, {5, 0, 1}, {0, 4, 0}}));
  EXPECT_EQ(triangles(scene), (Sets{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Nonplanar, TrianglesWithoutAreaAreDropped) {
  const Scene scene = make_scene(soup_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}}));
  EXPECT_EQ(triangles(scene), (Sets{{0, 2, 3}, {0, 3, 4}}));
}

/// Two components of the Newell normal are equal, or differ by a hair: along x the fan folds over, along y it does not.
/// A vertex that no polygon uses makes the grid finer and numbers longer.
TEST(Nonplanar, TheViewIsExact) {
  for (const double finest : {1.0, 0x1p-20, 0x1p-90, 0x1p-1000}) {
    for (const double hair : {0.0, 1.0}) {
      const double far = 0x1p48;
      PolygonSoup soup = soup_of({{hair, far, 0}, {0, 0, far}, {0, 0, -2 * far}, {far, 0, -far}});
      soup.vertices.emplace_back(finest, 0, 0);
      const Sets ears{{0, 1, 3}, {1, 2, 3}}, fan{{0, 1, 2}, {0, 2, 3}};
      Sets found = triangles(make_scene(soup));
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, hair == 0 ? ears : fan) << finest;
    }
  }
}

/// Star-shaped loops (simple in the view along z), lifted at random: the triangles tile the view of the loop.
RC_GTEST_PROP(Nonplanar, TrianglesTileTheView, ()) {
  const int count = *rc::gen::inRange(4, 14);
  std::vector<glm::dvec3> loop;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * 3.14159265358979 * k / count, radius = *rc::gen::inRange(200, 1000);
    loop.push_back({std::floor(radius * std::cos(angle)), std::floor(radius * std::sin(angle)),
                    static_cast<double>(*rc::gen::inRange(0, 20))});
  }
  std::rotate(loop.begin(), loop.begin() + *rc::gen::inRange(0, count), loop.end());
  const bool clockwise = *rc::gen::arbitrary<bool>();
  if (clockwise) std::reverse(loop.begin(), loop.end());
  const Scene scene = make_scene(soup_of(loop));
  if (scene.planar(0)) return;
  const FlatLoop view = flat_loop(scene, 0, 2);
  const mpq_class area = twice_area(view);
  std::vector<PointId> ids(loop.size());
  for (PointId k = 0; k < ids.size(); ++k) ids[k] = k;
  mpq_class sum;
  for (const Triangle& t : triangulate(scene.points(), ids)) {
    const mpq_class part = cross(view[t[0]], view[t[1]], view[t[2]]);
    RC_ASSERT(sgn(part) * sgn(area) >= 0);
    sum += part;
  }
  RC_ASSERT(sum == area);
  for (const Surface& s : scene.surfaces(0)) expect_sound_surface(scene, s);
}

}  // namespace
}  // namespace sightline::test
