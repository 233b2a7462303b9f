// What make_scene says of a soup as a whole.
#include "flat_geometry.hpp"
#include "scene/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sightline::test {
namespace {

PolygonSoup soup_of(std::vector<glm::dvec3> vertices, const std::vector<std::vector<std::uint32_t>>& polygons) {
  PolygonSoup soup;
  soup.vertices = std::move(vertices);
  for (const auto& p : polygons) {
    soup.corners.insert(soup.corners.end(), p.begin(), p.end());
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

const std::vector<glm::dvec3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<std::vector<std::uint32_t>> cube_faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                         {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}};

TEST(MakeScene, ACube) {
  const Scene scene = make_scene(soup_of(cube, cube_faces));
  EXPECT_EQ(scene.polygon_count(), 6u);
  EXPECT_EQ(scene.surfaces().size(), 6u);
  EXPECT_EQ(scene.planes().size(), 6u);  // the walls are the faces' planes
  for (PolygonId p = 0; p < 6; ++p) {
    ASSERT_EQ(scene.surfaces(p).size(), 1u);
    const Surface& s = scene.surfaces(p)[0];
    expect_sound_surface(scene, s);
    EXPECT_TRUE(scene.planar(p));
    EXPECT_EQ(s.flipped, p == 0 || p == 2 || p == 5);  // outward normals against +x, +y, +z
  }
  const SceneReport& r = scene.report();
  EXPECT_EQ(r.dropped + r.nonplanar + r.nonconvex + r.self_crossing + r.duplicates, 0u);
  EXPECT_EQ(r.largest_displacement, 0);
}

TEST(MakeScene, EdgesFollowTheFileUnlessFlipped) {
  const Scene scene = make_scene(soup_of(cube, cube_faces));
  const auto list = [&](PolygonId p) {
    std::vector<PointId> result;
    for (const SurfaceEdge& e : scene.edges(scene.surfaces(p)[0])) {
      result.push_back(e.a);
      EXPECT_EQ(e.corner, e.b);
    }
    return result;
  };
  EXPECT_EQ(list(1), (std::vector<PointId>{4, 5, 6, 7}));
  EXPECT_EQ(list(0), (std::vector<PointId>{1, 2, 3, 0}));
}

TEST(MakeScene, CollinearVerticesAreMergedIntoOneEdge) {
  const Scene scene = make_scene(soup_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{1, 2, 3, 4, 0}}));
  ASSERT_EQ(scene.surfaces(0).size(), 1u);
  const auto edges = scene.edges(scene.surfaces(0)[0]);
  ASSERT_EQ(edges.size(), 4u);
  for (const SurfaceEdge& e : edges) EXPECT_TRUE(e.a != 1 && e.b != 1 && e.corner != 1);
  EXPECT_EQ(scene.report().nonconvex, 0u);
}

TEST(MakeScene, DroppedPolygonsKeepTheirIndex) {
  const Scene scene = make_scene(soup_of(cube, {{0, 1, 0}, {4, 5, 6, 7}, {0, 1, 1, 0}, {0, 0, 0}, {0, 1, 2}}));
  EXPECT_EQ(scene.report().dropped, 3u);
  EXPECT_TRUE(scene.surfaces(0).empty());
  EXPECT_EQ(scene.surfaces(1).size(), 1u);
  EXPECT_EQ(scene.surfaces(1)[0].polygon, 1u);
  EXPECT_TRUE(scene.surfaces(2).empty());
  EXPECT_EQ(scene.surfaces(4)[0].polygon, 4u);
}

TEST(MakeScene, LowestTwin) {
  // 1 is used by a polygon without area only; 3 and 5 are the same place as it; 6 and 7 are used by nothing.
  const Scene scene =
      make_scene(soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, -0.0}, {9, 9, 9}, {9, 9, 9}},
                         {{0, 1, 0}, {0, 5, 2}, {0, 3, 4}}));
  EXPECT_EQ(scene.lowest_twin(0), 0u);
  EXPECT_EQ(scene.lowest_twin(1), 3u);
  EXPECT_EQ(scene.lowest_twin(3), 3u);
  EXPECT_EQ(scene.lowest_twin(5), 3u);
  EXPECT_EQ(scene.lowest_twin(6), 6u);
  EXPECT_EQ(scene.lowest_twin(7), 7u);
}

TEST(MakeScene, DuplicatesAreByPlaceNotIndex) {
  const Scene scene = make_scene(soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}},
                                         {{0, 1, 2}, {2, 1, 0}, {3, 4, 2}, {0, 1, 1, 2}, {0, 3, 1}, {3, 4, 0}}));
  EXPECT_EQ(scene.report().duplicates, 4u);
}

TEST(MakeScene, CoplanarPolygonsShareTheirPlane) {
  const Scene scene =
      make_scene(soup_of({{0.1, 0.1, 0.1}, {1.1, 0.1, 0.1}, {0.1, 1.1, 0.1}, {5, 5, 0.1}, {6, 5, 0.1}, {5, 7, 0.1}},
                         {{0, 1, 2}, {3, 5, 4}}));
  EXPECT_EQ(scene.surfaces()[0].plane, scene.surfaces()[1].plane);
  EXPECT_FALSE(scene.surfaces()[0].flipped);
  EXPECT_TRUE(scene.surfaces()[1].flipped);
}

TEST(MakeScene, SnapMakesPlanarAndReportsTheDisplacement) {
  const std::vector<glm::dvec3> vertices{{0.1, 0, 0.3}, {1.1, 0, 0.3}, {1.1, 1, 0.30000000000000004}, {0.1, 1, 0.3}};
  const Scene exact = make_scene(soup_of(vertices, {{0, 1, 2, 3}}));
  EXPECT_EQ(exact.report().nonplanar, 1u);
  const Scene snapped = make_scene(soup_of(vertices, {{0, 1, 2, 3}}), {.snap = "1e-3"});
  EXPECT_EQ(snapped.report().nonplanar, 0u);
  EXPECT_GT(snapped.report().largest_displacement, 0);
  EXPECT_LT(snapped.report().largest_displacement, 1e-15);
  const Scene coarse = make_scene(soup_of(vertices, {{0, 1, 2, 3}}), {.snap = "0.25"});
  EXPECT_NEAR(coarse.report().largest_displacement, std::hypot(0.1, 0.05), 1e-12);
  EXPECT_EQ(coarse.soup().vertices[0], vertices[0]);
  EXPECT_THROW(make_scene(soup_of(vertices, {{0, 1, 2, 3}}), {.snap = "-1"}), std::invalid_argument);
}

TEST(MakeScene, ExponentsFarApart) {
  const Scene scene = make_scene(
      soup_of({{1e-300, 0, 0}, {1e300, 0, 0}, {1e300, 1e300, 0}, {0, 1e300, 1e-300}}, {{0, 1, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(scene.report().nonplanar, 1u);
  for (const Surface& s : scene.surfaces()) expect_sound_surface(scene, s);
}

TEST(MakeScene, AnEmptySceneIsAScene) {
  const Scene scene = make_scene(PolygonSoup{});
  EXPECT_EQ(scene.polygon_count(), 0u);
  EXPECT_TRUE(scene.surfaces().empty());
}

std::string error_of(PolygonSoup soup) {
  try {
    make_scene(std::move(soup));
  } catch (const SceneError& e) {
    return e.what();
  }
  return "no error";
}

TEST(MakeScene, RefusesWhatIsNoScene) {
  std::vector<glm::dvec3> broken = cube;
  broken[5].y = NAN;
  EXPECT_EQ(error_of(soup_of(broken, cube_faces)), "vertex 5: is not finite");
  EXPECT_EQ(error_of(soup_of(cube, {{0, 1, 2}, {0, 1, 8}})), "polygon 1: vertex 8 is out of range, there are 8");
  EXPECT_EQ(error_of(soup_of(cube, {{0, 1, 2}, {0, 1}})), "polygon 1: has fewer than 3 vertices");
  PolygonSoup soup = soup_of(cube, cube_faces);
  soup.first.pop_back();
  EXPECT_EQ(error_of(soup), "scene: the polygons do not cover the list of corners");
  soup = soup_of(cube, cube_faces);
  std::swap(soup.first[2], soup.first[3]);
  EXPECT_NE(error_of(soup), "no error");
  soup = soup_of(cube, cube_faces);
  soup.object_of = {0};
  EXPECT_EQ(error_of(soup), "scene: not every polygon has an object");
  soup.object_of.assign(6, 0);
  EXPECT_EQ(error_of(soup), "polygon 0: its object is out of range");
  soup = {};
  soup.first.clear();
  EXPECT_NE(error_of(soup), "no error");
}

}  // namespace
}  // namespace sightline::test
