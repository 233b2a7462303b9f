// Samples beside exact maps; viewpoints on a sphere.
#include "sample/bitfield_samples.hpp"

#include "beam/trace.hpp"
#include "sample/bitfield_patches.hpp"
#include "sample/bitfield_viewpoints.hpp"
#include "tests/sample_bitfield/bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <mutex>

namespace sightline {
namespace {

using testing::bumpy_ball;
using testing::cameras_of;
using testing::within;

IdBitfield of_map(const Scene& scene, const Camera& camera) {
  const BspTree tree(scene);
  VisibilityMap map;
  Tracer(tree).trace(camera, map);
  IdBitfield field(scene.polygon_count());
  for (const MapFace& f : map.faces) {
    if (f.polygon != none) field.set(f.polygon);
  }
  return field;
}

TEST(Viewpoints, LieOnASphereWithTheWholeSceneInTheWindow) {
  for (const Scene& scene :
       {make_scene(bumpy_ball(8)), testing::small_model("city"), make_scene(bumpy_ball(6), {"0.125", false})}) {
    const glm::dvec3 centre = viewing_centre(scene);
    for (const unsigned count : {4u, 5u, 6u, 7u, 14u, 25u, 55u, 200u}) {
      const std::vector<Camera> cameras = cameras_of(sphere_cameras(scene, count));
      ASSERT_EQ(cameras.size(), count);
      double nearest = 1e300, farthest = 0, closest = 4;
      for (std::size_t k = 0; k < cameras.size(); ++k) {
        const Camera& c = cameras[k];
        const glm::dmat3 frame = glm::inverse(glm::dmat3(c.forward, c.right, c.up));
        for (const Surface& s : scene.surfaces()) {
          for (const std::uint32_t v : scene.corners(s.polygon)) {
            const glm::dvec3 p = frame * (scene.soup().vertices[v] - c.eye);
            ASSERT_TRUE(p.x > 0 && std::abs(p.y) <= p.x / 2 && std::abs(p.z) <= p.x / 2) << count << ' ' << k;
          }
        }
        nearest = std::min(nearest, glm::distance(c.eye, centre));
        farthest = std::max(farthest, glm::distance(c.eye, centre));
        for (std::size_t j = 0; j < k; ++j) {
          closest =
              std::min(closest, glm::distance(glm::normalize(c.eye - centre), glm::normalize(cameras[j].eye - centre)));
        }
      }
      EXPECT_NEAR(nearest, farthest, 1e-5 * farthest);
      // Evenly: caps around the viewpoints that do not overlap cover at least a third of the sphere.
      EXPECT_GT(count * closest * closest / 16, 1.0 / 3) << count;
    }
  }
  EXPECT_THROW(sphere_cameras(make_scene(bumpy_ball(5)), 3), std::invalid_argument);
  EXPECT_THROW(sphere_cameras(make_scene(bumpy_ball(5)), 16385), std::invalid_argument);
  EXPECT_THROW(sphere_cameras(make_scene(bumpy_ball(5)), 6, 0.5), std::invalid_argument);
}

TEST(Samples, ExactOnesAreThePolygonsOfTheMap) {
  for (const Scene& scene : {make_scene(bumpy_ball(14)), testing::small_model("city", 400)}) {
    const std::vector<Camera> cameras = cameras_of(sphere_cameras(scene, 6));
    BitfieldSampling options;
    options.exact = true;
    const BitfieldSamples samples = sample_bitfields(scene, cameras, options);
    ASSERT_EQ(samples.fields.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(samples.fields[k], of_map(scene, cameras[k]));
    // Those of buffers see no more, and with more pixels not much less.
    options.exact = false;
    std::uint32_t missed_before = ~0u;
    for (const unsigned pixels : {20u, 100u, 500u}) {
      options.pixels = pixels;
      const BitfieldSamples seen = sample_bitfields(scene, cameras, options);
      std::uint32_t missed = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_TRUE(within(seen.fields[k], samples.fields[k])) << pixels;
        missed += samples.fields[k].count() - seen.fields[k].count();
      }
      EXPECT_LT(missed, missed_before);
      missed_before = missed;
    }
  }
}

TEST(Samples, FillingInAndPatchesGiveSupersets) {
  const Scene scene = make_scene(bumpy_ball(14));
  const std::vector<Camera> cameras = cameras_of(sphere_cameras(scene, 14));
  BitfieldSampling options;
  options.pixels = 60;
  const BitfieldSamples plain = sample_bitfields(scene, cameras, options);
  BitfieldSamples before = plain;
  for (const unsigned rounds : {1u, 2u, 1000u}) {
    options.fill_rounds = rounds;
    const BitfieldSamples filled = sample_bitfields(scene, cameras, options);
    std::uint32_t more = 0;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      EXPECT_TRUE(within(before.fields[k], filled.fields[k]));
      more += filled.fields[k].count() - before.fields[k].count();
    }
    EXPECT_GT(more, 0u);
    before = filled;
  }
  options.fill_rounds = 0;
  for (const std::uint32_t most : {1u, 8u, 50u}) {
    options.patch = most;
    const PolygonPatches patches(scene, most);
    const BitfieldSamples patched = sample_bitfields(scene, cameras, options);
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      EXPECT_EQ(patched.fields[k].size(), patches.size());
      EXPECT_TRUE(within(plain.fields[k], patches.polygons(patched.fields[k])));
      EXPECT_EQ(patched.fields[k], patches.patches(plain.fields[k]));
    }
  }
}

TEST(Samples, TransparentPolygonsAreSetAndHideNothing) {
  const PolygonSoup ball = bumpy_ball(10, 0.1);
  PolygonSoup with_glass = ball;  // and a pane before it, the first polygon
  for (auto& c : with_glass.corners) c += 4;
  for (auto& f : with_glass.first) f += 4;
  with_glass.first.insert(with_glass.first.begin(), 0);
  with_glass.corners.insert(with_glass.corners.begin(), {0, 1, 2, 3});
  const std::vector<glm::dvec3> pane{{1.5, -2, -2}, {1.5, 2, -2}, {1.5, 2, 2}, {1.5, -2, 2}};
  with_glass.vertices.insert(with_glass.vertices.begin(), pane.begin(), pane.end());
  const Scene scene = make_scene(with_glass), without = make_scene(ball);
  const std::vector<Camera> cameras = cameras_of(sphere_cameras(scene, 6));
  for (const bool exact : {false, true}) {
    BitfieldSampling options;
    options.exact = exact;
    options.pixels = 300;
    options.fill_rounds = exact ? 0 : 1;
    const BitfieldSamples opaque = sample_bitfields(scene, cameras, options);
    const BitfieldSamples bare = sample_bitfields(without, cameras, options);
    options.transparent = {0};
    const BitfieldSamples clear = sample_bitfields(scene, cameras, options);
    std::uint32_t more = 0;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      IdBitfield expected(scene.polygon_count());
      expected.set(0);
      for (const PolygonId p : bare.fields[k].list()) expected.set(p + 1);
      EXPECT_EQ(clear.fields[k], expected);
      EXPECT_TRUE(within(opaque.fields[k], clear.fields[k]));
      more += clear.fields[k].count() - opaque.fields[k].count();
    }
    EXPECT_GT(more, 50u);  // behind the pane
    // Everything transparent: all is set, and nothing else is looked at.
    options.transparent.clear();
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) options.transparent.push_back(p);
    for (const IdBitfield& f : sample_bitfields(scene, cameras, options).fields) {
      EXPECT_EQ(f.count(), scene.polygon_count());
    }
  }
}

TEST(Samples, AreTheSameInAnyNumberOfThreads) {
  const Scene scene = testing::small_model("city", 300);
  const std::vector<Camera> cameras = cameras_of(sphere_cameras(scene, 20));
  for (const bool exact : {false, true}) {
    BitfieldSampling options;
    options.exact = exact;
    options.pixels = 100;
    options.fill_rounds = 1;
    std::mutex mutex;
    std::size_t steps = 0;
    options.step = [&] {
      const std::lock_guard lock(mutex);
      ++steps;
    };
    const BitfieldSamples one = sample_bitfields(scene, cameras, options);
    EXPECT_EQ(steps, cameras.size());
    options.threads = 3;
    EXPECT_EQ(sample_bitfields(scene, cameras, options), one);
  }
}

TEST(SceneNumber, TellsScenesApart) {
  const PolygonSoup soup = bumpy_ball(5);
  PolygonSoup moved = soup, turned = soup;
  moved.vertices[3].x += 0x1p-30;
  std::swap(turned.corners[0], turned.corners[1]);
  const std::uint64_t number = scene_number(make_scene(soup));
  EXPECT_EQ(scene_number(make_scene(soup)), number);
  EXPECT_NE(scene_number(make_scene(moved)), number);
  EXPECT_NE(scene_number(make_scene(turned)), number);
  EXPECT_NE(scene_number(make_scene(soup, {"", true})), number);
  EXPECT_NE(scene_number(make_scene(soup, {"0.0001", false})), number);
}

}  // namespace
}  // namespace sightline
