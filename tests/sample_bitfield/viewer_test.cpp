// From a viewer to polygons.
#include "sample/bitfield_viewer.hpp"

#include "beam/trace.hpp"
#include "sample/bitfield_viewpoints.hpp"
#include "tests/sample_bitfield/bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <set>

namespace sightline {
namespace {

using testing::bumpy_ball;
using testing::cameras_of;

std::vector<Camera> some_views(const Scene& scene, unsigned count) {
  std::mt19937 random(count);
  std::normal_distribution<double> normal;
  std::vector<Camera> out;
  const glm::dvec3 centre = viewing_centre(scene);
  while (out.size() < count) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    out.push_back(make_camera(centre + 4.0 * d, -d, {0.1, 0.2, 1}, 40, 1));
  }
  return out;
}

std::vector<PolygonId> polygons(BitfieldViewer& viewer, const Camera& camera) {
  const auto seen = viewer.look(camera).polygons;
  return {seen.begin(), seen.end()};
}

BitfieldSamples taken(const Scene& scene, unsigned count, bool exact, std::uint32_t patch = 0) {
  BitfieldSampling options;
  options.exact = exact;
  options.pixels = 200;
  options.patch = patch;
  return sample_bitfields(scene, cameras_of(sphere_cameras(scene, count)), options);
}

TEST(Viewer, AtAnExactSampleSeesJustWhatTheMapHas) {
  const Scene scene = make_scene(bumpy_ball(14));
  const BspTree tree(scene);
  Tracer tracer(tree);
  const BitfieldSamples samples = taken(scene, 14, true), drawn = taken(scene, 14, false);
  for (const auto form :
       {BitfieldViewing::lists, BitfieldViewing::plain, BitfieldViewing::hierarchical, BitfieldViewing::compressed}) {
    BitfieldViewer viewer(samples, {6, form, 1}), approximate(drawn, {6, form, 1});
    for (std::uint32_t k = 0; k < samples.cameras.size(); ++k) {
      std::vector<PolygonId> seen;
      tracer.visible(samples.cameras[k], seen);
      if (!seen.empty() && seen.back() == none) seen.pop_back();
      EXPECT_EQ(polygons(viewer, samples.cameras[k]), seen);
      EXPECT_EQ(viewer.look(samples.cameras[k]).samples, std::vector<std::uint32_t>{k});
      // From a buffer it is not known to be all: the samples around it are joined.
      EXPECT_GT(approximate.look(samples.cameras[k]).samples.size(), 3u);
    }
  }
}

TEST(Viewer, MoreNeighboursNeverLoseAPolygon) {
  const Scene scene = make_scene(bumpy_ball(14));
  for (const unsigned count : {6u, 14u, 25u}) {
    const BitfieldSamples samples = taken(scene, count, false);
    std::vector<BitfieldViewer> viewers;
    for (const unsigned n : {1u, 3u, 6u}) viewers.emplace_back(samples, BitfieldViewing{n, BitfieldViewing::plain, 1});
    bool more = false;
    for (const Camera& view : some_views(scene, 40)) {
      std::vector<PolygonId> before;
      std::vector<std::uint32_t> joined;
      for (BitfieldViewer& viewer : viewers) {
        const auto& seen = viewer.look(view);
        EXPECT_TRUE(std::ranges::includes(seen.polygons, before));
        EXPECT_TRUE(std::ranges::includes(seen.samples, joined));
        more = more || seen.polygons.size() > before.size();
        before.assign(seen.polygons.begin(), seen.polygons.end());
        joined = seen.samples;
        // What is shown is the union of the samples that are named.
        IdBitfield all(scene.polygon_count());
        for (const std::uint32_t k : joined) all.join(samples.fields[k]);
        EXPECT_EQ(before, all.list());
      }
    }
    EXPECT_TRUE(more);
  }
}

TEST(Viewer, TheNearestSampleIsOneOfTheThreeAroundTheViewer) {
  const Scene scene = make_scene(bumpy_ball(8));
  const BitfieldSamples samples = taken(scene, 25, false);
  BitfieldViewer one(samples, {1, BitfieldViewing::plain, 1}), three(samples, {3, BitfieldViewing::plain, 1});
  for (const Camera& view : some_views(scene, 40)) {
    const auto nearest = one.look(view).samples, around = three.look(view).samples;
    ASSERT_EQ(nearest.size(), 1u);
    ASSERT_EQ(around.size(), 3u);
    const auto along = [&](std::uint32_t k) {
      return glm::dot(glm::normalize(samples.cameras[k].eye - samples.centre),
                      glm::normalize(view.eye - samples.centre));
    };
    for (const std::uint32_t k : around) EXPECT_GE(along(nearest[0]), along(k) - 1e-7);
    // The viewer is between the three: a combination of them with no negative part.
    const glm::dmat3 m(samples.cameras[around[0]].eye - samples.centre, samples.cameras[around[1]].eye - samples.centre,
                       samples.cameras[around[2]].eye - samples.centre);
    const glm::dvec3 parts = glm::inverse(m) * (view.eye - samples.centre);
    for (int k = 0; k < 3; ++k) EXPECT_GE(parts[k], -1e-6);
  }
}

TEST(Viewer, AllFormsAndThreadsGiveTheSame) {
  const Scene scene = make_scene(bumpy_ball(14));
  for (const std::uint32_t patch : {0u, 10u}) {
    const BitfieldSamples samples = taken(scene, 25, false, patch);
    for (const unsigned n : {3u, 6u}) {
      BitfieldViewer lists(samples, {n, BitfieldViewing::lists, 1}, &scene),
          threads(samples, {n, BitfieldViewing::lists, 3}, &scene);
      std::size_t sum = 0;
      std::set<std::uint32_t> faces;
      for (const auto form : {BitfieldViewing::plain, BitfieldViewing::hierarchical, BitfieldViewing::compressed}) {
        BitfieldViewer viewer(samples, {n, form, 1}, &scene);
        EXPECT_GT(viewer.bytes(), 0u);
        EXPECT_EQ(viewer.mean_list(), lists.mean_list());
        for (const Camera& view : some_views(scene, 40)) {
          const std::vector<PolygonId> seen = polygons(viewer, view);
          EXPECT_EQ(seen, polygons(lists, view));
          EXPECT_EQ(seen, polygons(threads, view));
          EXPECT_EQ(viewer.look(view).face, lists.look(view).face);
          faces.insert(lists.look(view).face);
          sum += seen.size();
        }
      }
      EXPECT_GT(sum, 0u);
      EXPECT_GT(faces.size(), 10u);
      EXPECT_LT(lists.mean_list(), scene.polygon_count());
    }
  }
}

TEST(Viewer, SeveralSamplesInOneDirectionAreJoined) {
  const Scene scene = make_scene(bumpy_ball(10));
  std::vector<Camera> cameras = cameras_of(sphere_cameras(scene, 6));
  const glm::dvec3 centre = viewing_centre(scene);
  Camera nearer = cameras[0];
  nearer.eye = centre + 0.5 * (nearer.eye - centre);
  cameras.push_back(nearer);
  BitfieldSampling options;
  options.pixels = 100;
  const BitfieldSamples samples = sample_bitfields(scene, cameras, options);
  BitfieldViewer viewer(samples, {1, BitfieldViewing::plain, 1});
  EXPECT_EQ(viewer.look(cameras[0]).samples, (std::vector<std::uint32_t>{0, 6}));
  EXPECT_EQ(viewer.look(cameras[1]).samples, (std::vector<std::uint32_t>{1}));
  // At the centre itself there is no direction; what is shown is some face's list.
  Camera middle = cameras[2];
  middle.eye = centre;
  EXPECT_EQ(viewer.look(middle).face, 0u);
}

TEST(Viewer, RefusesWhatItCannotAnswer) {
  const Scene scene = make_scene(bumpy_ball(6));
  const std::vector<Camera> all = cameras_of(sphere_cameras(scene, 40));
  BitfieldSampling options;
  options.pixels = 20;
  const BitfieldSamples upper = sample_bitfields(scene, std::span(all).first(15), options);
  EXPECT_THROW(BitfieldViewer(upper, {}), std::invalid_argument);
  const BitfieldSamples samples = sample_bitfields(scene, all, options);
  for (const unsigned n : {0u, 2u, 4u, 7u}) {
    EXPECT_THROW(BitfieldViewer(samples, {n, BitfieldViewing::plain, 1}), std::invalid_argument);
  }
  EXPECT_THROW(BitfieldViewer(samples, {1, BitfieldViewing::lists, 1}), std::invalid_argument);
  const BitfieldSamples patched = taken(scene, 6, false, 4);
  const Scene other = make_scene(bumpy_ball(7));
  EXPECT_THROW(BitfieldViewer(patched, {}), std::invalid_argument);
  EXPECT_THROW(BitfieldViewer(patched, {}, &other), std::invalid_argument);
  EXPECT_NO_THROW(BitfieldViewer(patched, {}, &scene));
}

}  // namespace
}  // namespace sightline
