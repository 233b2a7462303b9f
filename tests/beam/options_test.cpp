// What a caller may leave out, or have done by several threads.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "tests/beam/same_map.hpp"
#include "tests/beam/turned.hpp"
#include "visibility_map/write.hpp"

namespace sightline {
namespace {

TEST(Threads, ShareOneCameraAndGiveTheSameMap) {
  for (const auto& [name, polygons, degrees] : {std::tuple{"building", 1000u, 0.0},
                                                {"city", 400u, 0.0},
                                                {"random", 60u, 0.0},
                                                {"city", 200u, 17.0},
                                                {"maze", 0u, 17.0}}) {
    const Turned turned(name, polygons, degrees);
    const BspTree tree(*turned.scene);
    Tracer alone(tree);
    for (const unsigned threads : {2u, 3u}) {
      Tracer shared(tree, {.threads = threads});
      for (std::size_t k = 0; k < turned.cameras.size(); k += threads) {
        Camera camera = turned.cameras[k];
        if (k % 4 == 1) camera.right = -camera.right;
        VisibilityMap a, b;
        TraceStats stats;
        alone.trace(camera, a);
        shared.trace(camera, b, &stats);
        EXPECT_EQ(map_json(a, *turned.scene), map_json(b, *turned.scene)) << name << " " << k;
        EXPECT_GE(stats.fragments, 2 * threads);  // every strip has one
        std::vector<PolygonId> seen, seen_shared;
        alone.visible(camera, seen);
        shared.visible(camera, seen_shared);
        EXPECT_EQ(seen, seen_shared);
      }
      VisibilityMap a, b;
      alone.trace_sphere(turned.cameras[1].eye, a);
      shared.trace_sphere(turned.cameras[1].eye, b);
      expect_equal(a, b);
    }
  }
}

TEST(Threads, ShareOneCameraInCells) {
  const Turned turned("city", 200, 0);
  const Complex complex = build(*turned.scene);
  Tracer alone(*turned.scene, complex), shared(*turned.scene, complex, {.threads = 2});
  for (const Camera& camera : turned.cameras) {
    VisibilityMap a, b;
    alone.trace(camera, a);
    shared.trace(camera, b);
    EXPECT_EQ(map_json(a, *turned.scene), map_json(b, *turned.scene));
  }
}

TEST(Threads, ShareWindowsOfAllWidths) {
  const Turned turned("city", 200, 0);
  const BspTree tree(*turned.scene);
  Tracer alone(tree), shared(tree, {.threads = 4});
  for (const double degrees : {1e-9, 1e-3, 170.0, 179.9}) {
    const Camera camera = make_camera(turned.cameras[2].eye, turned.cameras[2].forward, {0, 0, 1}, degrees, 2.5);
    VisibilityMap a, b;
    alone.trace(camera, a);
    shared.trace(camera, b);
    EXPECT_EQ(map_json(a, *turned.scene), map_json(b, *turned.scene)) << degrees;
  }
}

TEST(Areas, AreThoseOfTheMapsFaces) {
  for (const auto& [name, polygons, degrees] :
       {std::tuple{"building", 1000u, 0.0}, {"campus", 0u, 0.0}, {"random", 60u, 17.0}}) {
    const Turned turned(name, polygons, degrees);
    const BspTree tree(*turned.scene);
    Tracer tracer(tree), shared(tree, {.threads = 2});
    for (std::size_t k = 0; k < turned.cameras.size(); ++k) {
      Camera camera = turned.cameras[k];
      if (k % 2 == 1) camera.up = -camera.up;  // mirrored
      VisibilityMap map;
      tracer.trace(camera, map);
      std::map<PolygonId, double> expected;
      for (const MapFace& face : map.faces) expected[face.polygon] += face.area;
      for (Tracer* const by : {&tracer, &shared}) {
        std::vector<PolygonArea> areas;
        by->areas(camera, areas);
        ASSERT_EQ(areas.size(), expected.size());
        auto at = expected.begin();
        double sum = 0;
        for (const PolygonArea& a : areas) {
          EXPECT_EQ(a.polygon, at->first);
          EXPECT_NEAR(a.area, at->second, 1e-13);
          sum += a.area;
          ++at;
        }
        EXPECT_NEAR(sum, 1, 1e-13);
      }
    }
  }
}

/// The scene with nothing left of the polygons whose bounding box is farther from the eye; they keep their places.
Scene within(const PolygonSoup& soup, const glm::dvec3& eye, double distance, int& left_out) {
  PolygonSoup near = soup;
  left_out = 0;
  for (std::size_t p = 0; p + 1 < soup.first.size(); ++p) {
    double square = 0;  // exact: the models' coordinates are short
    for (int k = 0; k < 3; ++k) {
      double low = INFINITY, high = -INFINITY;
      for (std::uint32_t c = soup.first[p]; c < soup.first[p + 1]; ++c) {
        low = std::min(low, soup.vertices[soup.corners[c]][k]);
        high = std::max(high, soup.vertices[soup.corners[c]][k]);
      }
      const double gap = std::max({low - eye[k], eye[k] - high, 0.0});
      square += gap * gap;
    }
    if (square <= distance * distance) continue;
    ++left_out;
    for (std::uint32_t c = soup.first[p]; c < soup.first[p + 1]; ++c) near.corners[c] = soup.corners[soup.first[p]];
  }
  return make_scene(near);
}

TEST(MaxDistance, IsTheMapOfWhatIsNear) {
  for (const auto& [name, polygons] : {std::pair{"building", 2000u}, {"city", 400u}, {"random", 60u}}) {
    const Turned turned(name, polygons, 0);
    const BspTree tree(*turned.scene);
    const Complex complex = build(*turned.scene);
    int left_out = 0, all = 0;
    for (const Camera& camera : turned.cameras) {
      for (const double distance : {2.0, 8.0, 40.0, 1e6}) {
        int here = 0;
        const Scene near = within(turned.soup, camera.eye, distance, here);
        left_out += here;
        all += distance == 1e6 ? here : 0;
        const BspTree near_tree(near);
        VisibilityMap expected;
        Tracer(near_tree).trace(camera, expected);
        for (Tracer tracer :
             {Tracer(tree, {.max_distance = distance}), Tracer(*turned.scene, complex, {.max_distance = distance}),
              Tracer(tree, {.max_distance = distance, .threads = 2})}) {
          VisibilityMap map;
          tracer.trace(camera, map);
          EXPECT_EQ(map_json(map, near), map_json(expected, near)) << name << " " << distance;
        }
      }
    }
    EXPECT_GT(left_out, 0);
    EXPECT_EQ(all, 0);
  }
}

/// A square at x = 3, y = 4 and up: its nearest point is 5 away from the origin.
TEST(MaxDistance, IsDecidedExactly) {
  PolygonSoup soup;
  soup.vertices = {{3, 4, 0}, {3, 8, 0}, {3, 8, 4}, {3, 4, 4}};
  soup.corners = {0, 1, 2, 3};
  soup.first = {0, 4};
  for (const char* snap : {"", "0.1"}) {
    const Scene scene = make_scene(soup, {.snap = snap});
    const BspTree tree(scene);
    const Camera camera = make_camera({0, 0, 0}, {3, 5, 0.5}, {0, 0, 1}, 60, 1);
    const auto sees = [&](double distance) {
      std::vector<PolygonId> seen;
      Tracer(tree, {.max_distance = distance}).visible(camera, seen);
      return !seen.empty();
    };
    EXPECT_TRUE(sees(5));
    EXPECT_TRUE(sees(std::nextafter(5.0, 6.0)));
    EXPECT_FALSE(sees(std::nextafter(5.0, 4.0)));
    EXPECT_FALSE(sees(1e-300));
  }
}

TEST(Options, AreRefusedOutOfRange) {
  const Turned turned("maze", 0, 0);
  const BspTree tree(*turned.scene);
  for (const double distance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Tracer(tree, {.max_distance = distance}), std::invalid_argument);
  }
  EXPECT_THROW(Tracer(tree, {.threads = 0}), std::invalid_argument);
  const Complex complex = build(*turned.scene);
  EXPECT_THROW(Tracer(*turned.scene, complex, {.min_angle = 1e-9}), std::invalid_argument);
}

}  // namespace
}  // namespace sightline
