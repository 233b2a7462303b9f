// Laws of the tracer as a whole: what the map may depend on, and what not.
#include "beam/trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "bsp/build.hpp"
#include "models/model.hpp"
#include "visibility_map/write.hpp"

namespace sightline {
namespace {

PolygonSoup random_triangles(std::mt19937_64& random, int count, int range) {
  PolygonSoup soup;
  const auto coordinate = [&] {
    return static_cast<double>(random() % static_cast<unsigned>(2 * range + 1)) - static_cast<double>(range);
  };
  for (int k = 0; k < 3 * count; ++k) {
    soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
    soup.vertices.push_back({coordinate(), coordinate(), coordinate()});
    if (k % 3 == 2) soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

Camera looking(const glm::dvec3& eye, const glm::dvec3& forward) {
  return make_camera(eye, forward,
                     std::abs(forward.z) > std::abs(forward.x) ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 0, 1}, 70, 1.25);
}

std::string trace_json(const Scene& scene, const Complex& complex, const Camera& camera) {
  Tracer tracer(scene, complex);
  VisibilityMap map;
  tracer.trace(camera, map);
  return map_json(map, scene);
}

double total_area(const VisibilityMap& map) {
  double sum = 0;
  for (const MapFace& f : map.faces) sum += f.area;
  return sum;
}

double total_angle(const VisibilityMap& map) {
  double sum = 0;
  for (const MapFace& f : map.faces) sum += f.solid_angle;
  return sum;
}

const BuildOptions other_cuts{{0.5, 0.1, 4.0, 0.0}};
const BuildOptions many_splits{{0.0, 5.0, 0.0, 3.0}};

// The map follows from the drawing alone: another complex of the same scene gives the same bytes. Eyes are put where
// everything degenerates: on vertices, on edges, in planes.
TEST(Trace, SameBytesFromEveryComplex) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 40; ++round) {
    const Scene scene = make_scene(random_triangles(random, 3 + static_cast<int>(random() % 7), 2 + round % 4));
    const Complex one = build(scene), two = build(scene, other_cuts), three = build(scene, many_splits);
    const auto& v = scene.soup().vertices;
    const glm::dvec3 a = v[random() % v.size()], b = v[random() % v.size()], c = v[random() % v.size()];
    const glm::dvec3 eyes[] = {a, (a + b) * 0.5, (a + b + c) * 0.25, {0.5, 0.25, 0.125}, {40, 30, 20}};
    for (const glm::dvec3& eye : eyes) {
      const glm::dvec3 target{static_cast<double>(random() % 5) - 2, static_cast<double>(random() % 5) - 2, 0.5};
      if (eye == target) continue;
      const Camera camera = looking(eye, target - eye);
      const std::string expected = trace_json(scene, one, camera);
      EXPECT_EQ(expected, trace_json(scene, two, camera)) << "round " << round;
      EXPECT_EQ(expected, trace_json(scene, three, camera)) << "round " << round;
    }
  }
}

TEST(Trace, ModelsGiveTheSameBytesFromEveryComplex) {
  for (const char* name : {"rooms", "maze", "city"}) {
    const Model model = make_model(name);
    const Scene scene = make_scene(model.soup);
    const Complex one = build(scene), two = build(scene, other_cuts);
    for (std::size_t k = 0; k < model.cameras.size(); k += 17) {
      const CameraLine& c = model.cameras[k];
      const Camera camera = make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect);
      EXPECT_EQ(trace_json(scene, one, camera), trace_json(scene, two, camera)) << name << " camera " << k;
    }
  }
}

TEST(Trace, AreasOfTheWindowAddUp) {
  const Model model = make_model("maze");
  const Scene scene = make_scene(model.soup);
  const Complex complex = build(scene);
  Tracer tracer(scene, complex);
  VisibilityMap map;
  for (const CameraLine& c : model.cameras) {
    tracer.trace(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect), map);
    EXPECT_NEAR(total_area(map), 1.0, 1e-12);
  }
}

// The six faces of a cube around the eye see together what the sphere sees, under the same solid angles.
TEST(Trace, AWindowIsTheSumOfItsParts) {
  const Model model = make_model("city", {.polygons = 400});
  const Scene scene = make_scene(model.soup);
  const BspTree tree(scene);
  Tracer tracer(tree);
  for (std::size_t k = 0; k < model.cameras.size(); k += 20) {
    const auto& c = model.cameras[k];
    const Camera camera = make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect);
    VisibilityMap map;
    std::map<PolygonId, double> sum;
    tracer.trace(camera, map);
    for (const MapFace& face : map.faces) sum[face.polygon] += face.area;
    for (const glm::dvec2& low : {glm::dvec2{0, 0}, {0.375, 0}, {0, 0.25}, {0.375, 0.25}}) {
      const glm::dvec2 high{low.x == 0 ? 0.375 : 1, low.y == 0 ? 0.25 : 1};
      tracer.trace(crop(camera, low, high), map);
      const double part = (high.x - low.x) * (high.y - low.y);
      for (const MapFace& face : map.faces) sum[face.polygon] -= face.area * part;
    }
    for (const auto& [polygon, left] : sum) EXPECT_NEAR(left, 0, 1e-12) << polygon;
  }
}

TEST(Trace, SphereIsTheSumOfSixWindows) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 12; ++round) {
    const Scene scene = make_scene(random_triangles(random, 8, 6));
    const Complex complex = build(scene);
    Tracer tracer(scene, complex);
    const glm::dvec3 eye = round % 3 == 0 ? scene.soup().vertices[4] : glm::dvec3{0.5, 0.25, -0.125};
    VisibilityMap sphere, window;
    tracer.trace_sphere(eye, sphere);
    EXPECT_NEAR(total_angle(sphere), 4 * std::numbers::pi, 1e-9);
    std::map<PolygonId, double> by_sphere, by_windows;
    for (const MapFace& f : sphere.faces) by_sphere[f.polygon] += f.solid_angle;
    for (int k = 0; k < 6; ++k) {
      glm::dvec3 forward{0, 0, 0}, right{0, 0, 0};
      forward[k / 2] = k % 2 ? 1 : -1;
      right[(k / 2 + 1) % 3] = 2;
      const glm::dvec3 up{right.y * forward.z - right.z * forward.y, right.z * forward.x - right.x * forward.z,
                          right.x * forward.y - right.y * forward.x};
      tracer.trace({eye, forward, right, up}, window);
      for (const MapFace& f : window.faces) by_windows[f.polygon] += f.solid_angle;
    }
    ASSERT_EQ(by_sphere.size(), by_windows.size());
    for (const auto& [polygon, angle] : by_sphere) EXPECT_NEAR(angle, by_windows[polygon], 1e-9);
  }
}

TEST(Trace, MirroredCameraSeesTheMirroredMap) {
  const Model model = make_model("rooms");
  const Scene scene = make_scene(model.soup);
  const Complex complex = build(scene);
  Tracer tracer(scene, complex);
  const CameraLine& c = model.cameras[3];
  Camera camera = make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect);
  VisibilityMap map, mirrored;
  tracer.trace(camera, map);
  camera.right = -camera.right;
  tracer.trace(camera, mirrored);
  ASSERT_EQ(map.faces.size(), mirrored.faces.size());
  ASSERT_EQ(map.vertices.size(), mirrored.vertices.size());
  std::multiset<std::pair<double, double>> points, images;
  for (const MapVertex& v : map.vertices) points.insert({1 - v.st.x, v.st.y});
  for (const MapVertex& v : mirrored.vertices) images.insert({v.st.x, v.st.y});
  auto image = images.begin();
  for (const auto& p : points) {
    EXPECT_NEAR(p.first, image->first, 1e-15);
    EXPECT_NEAR(p.second, image->second, 1e-15);
    ++image;
  }
}

TEST(Trace, LookingAwayFromEverythingSeesNothing) {
  const Scene scene = make_scene(make_model("rooms").soup);
  const Complex complex = build(scene);
  Tracer tracer(scene, complex);
  VisibilityMap map;
  tracer.trace(looking({1e6, 0, 0}, {1, 0.25, 0}), map);
  ASSERT_EQ(map.faces.size(), 1u);
  EXPECT_EQ(map.faces[0].polygon, none);
  EXPECT_EQ(map.edges.size(), 4u);
}

TEST(Trace, RefusesDependentVectors) {
  const Scene scene = make_scene(make_model("rooms").soup);
  const Complex complex = build(scene);
  Tracer tracer(scene, complex);
  VisibilityMap map;
  EXPECT_THROW(tracer.trace({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}}, map), std::invalid_argument);
}

// One-sided: from the back a polygon is as if it were not there.
TEST(Trace, OneSidedPolygonsAreSeenThroughFromBehind) {
  PolygonSoup soup;
  soup.vertices = {{-1, 2, -1}, {1, 2, -1}, {0, 2, 1}, {-9, 5, -9}, {9, 5, -9}, {0, 5, 9}};
  soup.corners = {0, 2, 1, 3, 4, 5};  // the first turned away from an eye at the origin, the second towards it
  soup.first = {0, 3, 6};
  SceneOptions options;
  options.one_sided = true;
  for (const bool one_sided : {false, true}) {
    options.one_sided = one_sided;
    const Scene scene = make_scene(soup, options);
    const Complex complex = build(scene);
    Tracer tracer(scene, complex);
    VisibilityMap map;
    tracer.trace(looking({0, 0, 0}, {0, 1, 0}), map);
    std::set<PolygonId> seen;
    for (const MapFace& f : map.faces) seen.insert(f.polygon);
    EXPECT_EQ(seen.count(0), one_sided ? 0u : 1u);
    EXPECT_EQ(seen.count(1), 1u);
  }
}

}  // namespace
}  // namespace sightline
