// The engines give the same bytes: what front-to-back sees on a tree, cells sees in the complex.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <thread>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "models/model.hpp"
#include "tests/beam/same_map.hpp"
#include "visibility_map/write.hpp"

namespace sightline {
namespace {

/// Polygons on a coarse lattice: most of them cross, many are coplanar and overlap.
PolygonSoup lattice_polygons(std::mt19937_64& random, int count, int range, bool flat) {
  PolygonSoup soup;
  const auto coordinate = [&] { return static_cast<double>(random() % static_cast<unsigned>(range + 1)); };
  for (int k = 0; k < count; ++k) {
    const int axis = static_cast<int>(random() % 3);
    const double level = coordinate();
    for (int corner = 0; corner < 3; ++corner) {
      glm::dvec3 p{coordinate(), coordinate(), coordinate()};
      if (flat) p[axis] = level;
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(p);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

class Pair {
 public:
  explicit Pair(const Scene& scene)
      : scene_(scene), complex_(build(scene)), tree_(scene, {true}), cells_(scene, complex_), front_to_back_(tree_) {}

  void expect_same(const Camera& camera, const std::string& what) {
    VisibilityMap one, two;
    cells_.trace(camera, one);
    front_to_back_.trace(camera, two);
    EXPECT_EQ(map_json(one, scene_), map_json(two, scene_)) << what;
    for (const MapFace& f : one.faces) EXPECT_TRUE(f.solid_angle >= 0 && f.solid_angle < 7) << what;
    std::set<PolygonId> seen;
    for (const MapFace& f : one.faces) seen.insert(f.polygon);
    seen.erase(none);
    for (Tracer* tracer : {&cells_, &front_to_back_}) {
      std::vector<PolygonId> found;
      tracer->visible(camera, found);
      EXPECT_TRUE(std::equal(found.begin(), found.end(), seen.begin(), seen.end())) << what;
    }
  }
  void expect_same_sphere(const glm::dvec3& eye) {
    VisibilityMap one, two;
    cells_.trace_sphere(eye, one);
    front_to_back_.trace_sphere(eye, two);
    expect_equal(one, two);
  }

 private:
  const Scene& scene_;
  Complex complex_;
  BspTree tree_;
  Tracer cells_, front_to_back_;
};

Camera looking(const glm::dvec3& eye, const glm::dvec3& forward) {
  return make_camera(eye, forward,
                     std::abs(forward.z) > std::abs(forward.x) ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 0, 1}, 80, 1.25);
}

// Eyes where everything degenerates: on vertices and edges, in planes, at the corners of others' boxes.
TEST(Engines, SameBytesOnDegenerateScenes) {
  std::mt19937_64 random(29);
  for (int round = 0; round < 120; ++round) {
    SceneOptions options;
    options.one_sided = round % 3 == 0;
    const Scene scene = make_scene(
        lattice_polygons(random, 3 + static_cast<int>(random() % 12), 2 + round % 4, round % 2 == 0), options);
    if (scene.surfaces().empty()) continue;
    Pair engines(scene);
    const auto& v = scene.soup().vertices;
    const glm::dvec3 a = v[random() % v.size()], b = v[random() % v.size()], c = v[random() % v.size()];
    for (const glm::dvec3& eye : {a, (a + b) * 0.5, (a + b + c) * 0.25, glm::dvec3{0.5, 0.25, 0.125},
                                  glm::dvec3{40, 30, 20}, glm::dvec3{1e9, 3, 2}}) {
      const glm::dvec3 target{static_cast<double>(random() % 3), static_cast<double>(random() % 3), 0.5};
      if (eye != target) engines.expect_same(looking(eye, target - eye), "round " + std::to_string(round));
    }
    engines.expect_same_sphere(a);
    engines.expect_same_sphere((a + b) * 0.5);
  }
}

TEST(Engines, SameBytesOnTheModels) {
  for (const double degrees : {0.0, 17.0}) {
    for (const char* name : {"rooms", "maze", "city", "campus"}) {
      ModelOptions options;
      options.rotate_degrees = degrees;
      const Model model = make_model(name, options);
      const Scene scene = make_scene(model.soup);
      Pair engines(scene);
      for (std::size_t k = 0; k < model.cameras.size(); k += degrees == 0 ? 9 : 33) {
        const CameraLine& c = model.cameras[k];
        engines.expect_same(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect),
                            std::string(name) + " camera " + std::to_string(k));
      }
    }
  }
}

// Windows from a billionth of a degree to all but half of the sphere, mirrored ones, and ones that are not upright.
TEST(Engines, SameBytesInExtremeWindows) {
  const Model model = make_model("maze");
  const Scene scene = make_scene(model.soup);
  Pair engines(scene);
  const CameraLine& c = model.cameras[7];
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
TEST(Engines, SameBytesFromBeyondTheDoubles) {
  PolygonSoup soup = make_model("rooms").soup;
  for (glm::dvec3& v : soup.vertices) v *= 0x1p-500;
  const Scene scene = make_scene(soup);
  Pair engines(scene);
  for (const double far : {0x1p-400, 1.0, 0x1p600}) {
    const glm::dvec3 eye = glm::dvec3{1, 0.75, 0.5} * far;
    engines.expect_same(looking(eye, {-1, -0.75, -0.5}), std::to_string(std::log2(far)));
  }
}

// A lazy tree is divided by whoever comes first; what is seen does not depend on that.
TEST(Engines, LazyTreesAreSharedByThreads) {
  const Model model = make_model("city");
  const Scene scene = make_scene(model.soup);
  std::vector<Camera> cameras;
  for (const CameraLine& c : model.cameras) {
    cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  const BspTree eager(scene), lazy(scene, {true});
  EXPECT_EQ(lazy.size().nodes, 0u);
  std::vector<std::string> expected(cameras.size()), found(cameras.size());
  const auto trace_some = [&](const BspTree& tree, std::vector<std::string>& out, std::size_t first, std::size_t step) {
    Tracer tracer(tree);
    VisibilityMap map;
    for (std::size_t k = first; k < cameras.size(); k += step) {
      tracer.trace(cameras[k], map);
      out[k] = map_json(map, scene);
    }
  };
  trace_some(eager, expected, 0, 1);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 4; ++t) threads.emplace_back([&, t] { trace_some(lazy, found, t, 4); });
  }
  EXPECT_EQ(expected, found);
  EXPECT_GT(lazy.size().nodes, 0u);
  EXPECT_LT(lazy.size().nodes, eager.size().nodes);
}

TEST(Engines, ASceneWithoutPolygonsIsEmptySky) {
  PolygonSoup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  soup.corners = {0, 1, 2};  // of no area
  soup.first = {0, 3};
  const Scene scene = make_scene(soup);
  const BspTree tree(scene);
  VisibilityMap map;
  Tracer(tree).trace(looking({5, 5, 5}, {-1, -1, 0}), map);
  ASSERT_EQ(map.faces.size(), 1u);
  EXPECT_EQ(map.faces[0].polygon, none);
}

}  // namespace
}  // namespace sightline
