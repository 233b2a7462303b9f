// The engine `hybrid` gives the bytes of the others: of `cells` and `front-to-back`.
// SIGHTLINE_CASES=n makes n degenerate scenes instead of the usual few, SIGHTLINE_FIRST=k begins with seed k.
#include "clip/hybrid.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "bsp/build.hpp"
#include "tests/clip/shots.hpp"

namespace sightline::testing {
namespace {

std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* wanted = std::getenv(name);
  return wanted == nullptr ? usual : std::strtoull(wanted, nullptr, 10);
}

class Engines {
 public:
  explicit Engines(const Scene& scene)
      : scene_(scene), tree_(scene, {true}), front_to_back_(tree_), hybrid_(scene), coarse_(scene, 3) {}

  std::string hybrid(const Camera& camera) {
    VisibilityMap map;
    hybrid_.trace(camera, map, &stats);
    return map_json(map, scene_);
  }
  void expect_same(const Camera& camera, const std::string& what) {
    VisibilityMap one, two;
    front_to_back_.trace(camera, one);
    const std::string expected = map_json(one, scene_);
    EXPECT_EQ(hybrid(camera), expected) << what;
    coarse_.trace(camera, two);
    EXPECT_EQ(map_json(two, scene_), expected) << what;
  }
  HybridStats stats;

 private:
  const Scene& scene_;
  BspTree tree_;
  Tracer front_to_back_;
  HybridTracer hybrid_, coarse_;
};

Camera looking(const glm::dvec3& eye, const glm::dvec3& forward) {
  return make_camera(eye, forward,
                     std::abs(forward.z) > std::abs(forward.x) ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 0, 1}, 80, 1.25);
}

// Eyes in planes, on edges and vertices, polygons behind and through the eye's plane, coplanar overlaps, one-sided
// scenes, slivers: whatever the maker of scenes can think of.
TEST(Hybrid, SameBytesOnDegenerateScenes) {
  const std::uint64_t first = setting("SIGHTLINE_FIRST", 0), count = setting("SIGHTLINE_CASES", 150);
  std::size_t skies = 0, coincident = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Shot shot = degenerate(seed);
    Engines engines(shot.scene);
    const Complex complex = build(shot.scene);
    Tracer cells(shot.scene, complex);
    for (const Camera& camera : shot.cameras) {
      engines.expect_same(camera, "seed " + std::to_string(seed));
      VisibilityMap map;
      cells.trace(camera, map);
      EXPECT_EQ(engines.hybrid(camera), map_json(map, shot.scene)) << "seed " << seed;
      coincident += map.coincident.size();
      for (const MapFace& face : map.faces) skies += face.polygon == none;
    }
  }
  EXPECT_GT(skies, count);
  EXPECT_GT(coincident, 0u);
}

TEST(Hybrid, SameBytesOnTheModels) {
  for (const Shot& shot :
       {model("rooms", 9), model("maze", 30), model("city", 50), model("building", 50, 400), model("tower", 12),
        model("campus", 5), model("random", 8, 120), model("arena", 80), model("rooms", 20, 0, 17),
        model("maze", 60, 0, 17), model("tower", 24, 0, 17), model("campus", 9, 0, 17)}) {
    Engines engines(shot.scene);
    for (const Camera& camera : shot.cameras) engines.expect_same(camera, shot.scene.soup().source);
  }
}

// Windows from a billionth of a degree to all but half of the sphere, mirrored ones, and ones that are not upright.
TEST(Hybrid, SameBytesInExtremeWindows) {
  const Model made = make_model("maze");
  const Scene scene = make_scene(made.soup);
  Engines engines(scene);
  const CameraLine& c = made.cameras[7];
  for (const double degrees : {1e-9, 1e-3, 100.0, 179.0}) {
    Camera camera = make_camera(c.eye, c.forward, c.up, degrees, 1.5);
    engines.expect_same(camera, std::to_string(degrees));
    camera.right = -camera.right;
    engines.expect_same(camera, std::to_string(degrees) + " mirrored");
    camera.up += 0.7 * camera.right + 0.3 * camera.forward;
    engines.expect_same(camera, std::to_string(degrees) + " skew");
    camera.up = camera.right + 1e-13 * camera.up;  // all but dependent
    engines.expect_same(camera, std::to_string(degrees) + " thin");
    camera.forward *= 1e-200;
    camera.right *= 1e-200;
    camera.up *= 1e-200;
    engines.expect_same(camera, std::to_string(degrees) + " tiny");
  }
}

// An eye whose place in the scene's own unit is beyond the largest double.
TEST(Hybrid, SameBytesFromBeyondTheDoubles) {
  PolygonSoup soup = make_model("rooms").soup;
  for (glm::dvec3& v : soup.vertices) v *= 0x1p-500;
  const Scene scene = make_scene(soup);
  Engines engines(scene);
  for (const double far : {0x1p-400, 1.0, 0x1p600}) {
    const glm::dvec3 eye = glm::dvec3{1, 0.75, 0.5} * far;
    engines.expect_same(looking(eye, {-1, -0.75, -0.5}), std::to_string(std::log2(far)));
  }
}

// Polygons before the sky: many, so that the window is halved; some share their planes.
TEST(Hybrid, SkyBetweenManyPolygons) {
  Random random(4);
  PolygonSoup soup;
  for (int k = 0; k < 400; ++k) {
    const glm::dvec3 at{random.between(-40, 40), 60 + random.between(0, 3), random.between(-40, 40)};
    for (int corner = 0; corner < 3; ++corner) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(at + glm::dvec3{random.between(-3, 3), 0, random.between(-3, 3)});
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  const Scene scene = make_scene(soup);
  Engines engines(scene);
  for (int k = 0; k < 4; ++k) {
    Camera camera = looking({static_cast<double>(k), -1, 2}, {0.1 * k, 1, 0.05});
    engines.expect_same(camera, "camera " + std::to_string(k));
    camera.right *= -1e-9;
    camera.up *= 1e-9;
    engines.expect_same(camera, "narrow camera " + std::to_string(k));
  }
}

TEST(Hybrid, ASceneWithoutPolygonsIsEmptySky) {
  PolygonSoup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  soup.corners = {0, 1, 2};  // of no area
  soup.first = {0, 3};
  const Scene scene = make_scene(soup);
  Engines engines(scene);
  engines.expect_same(looking({5, 5, 5}, {-1, -1, 0}), "empty");
  EXPECT_EQ(engines.stats.faces, 1u);
  EXPECT_EQ(engines.stats.surfaces, 0u);
}

// Copies share the boxes and nothing else.
TEST(Hybrid, CopiesInThreads) {
  const Shot shot = model("city", 10);
  const HybridTracer prepared(shot.scene);
  std::vector<std::string> expected, found(shot.cameras.size());
  HybridTracer one(prepared);
  for (const Camera& camera : shot.cameras) {
    VisibilityMap map;
    one.trace(camera, map);
    expected.push_back(map_json(map, shot.scene));
  }
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 3; ++t)
      threads.emplace_back([&, t] {
        HybridTracer own(prepared);
        VisibilityMap map;
        for (std::size_t k = t; k < found.size(); k += 3) {
          own.trace(shot.cameras[k], map);
          found[k] = map_json(map, shot.scene);
        }
      });
  }
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace sightline::testing
