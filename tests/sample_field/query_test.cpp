// Laws of looking up.
#include "sample/id_buffer.hpp"
#include "tests/sample_field/scenes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace sightline::test {
namespace {

std::vector<std::uint32_t> marked(const Field& field, const Camera& camera, const FieldQueryOptions& options) {
  return FieldQuery(field, options).mark(camera).cells;
}

struct City {
  Scene scene = model_scene("city");
  FieldCells cells = grid_of(scene);
  Field field = build_field(scene, slabs_around(box_of(scene)), cells, {{6, 6, 14, 14}, 1, 3, true, 2});
  std::vector<Camera> cameras = cameras_around(scene, 5);
};

const City& city() {
  static const City one;
  return one;
}

TEST(FieldQuery, NothingIsLostByNeighbours) {
  std::size_t grew = 0;
  for (const Camera& camera : city().cameras) {
    const auto by = [&](FieldFilter filter) { return marked(city().field, camera, {.pixels = 40, .filter = filter}); };
    const auto nearest = by(FieldFilter::nearest), uv = by(FieldFilter::uv), st = by(FieldFilter::st);
    const auto both = by(FieldFilter::uvst);
    EXPECT_TRUE(within(nearest, uv));
    EXPECT_TRUE(within(nearest, st));
    EXPECT_TRUE(within(uv, both));
    EXPECT_TRUE(within(st, both));
    EXPECT_GT(nearest.size(), 10u);
    grew += both.size() - nearest.size();
  }
  EXPECT_GT(grew, 0u);
}

TEST(FieldQuery, NothingIsLostByMoreLookUps) {
  for (const Camera& camera : city().cameras) {
    std::vector<std::uint32_t> before;
    std::size_t looked_up = 0;
    for (const std::uint32_t subsample : {60u, 12u, 6u, 3u, 1u}) {
      const FieldMarks now = FieldQuery(city().field, {.pixels = 120, .subsample = subsample}).mark(camera);
      EXPECT_TRUE(within(before, now.cells)) << subsample;
      EXPECT_GT(now.looked_up, looked_up);
      before = now.cells;
      looked_up = now.looked_up;
    }
  }
}

TEST(FieldQuery, NothingIsLostByMoreIds) {
  for (const Camera& camera : city().cameras) {
    std::vector<std::uint32_t> before;
    for (const std::uint32_t ids : {1u, 2u, 4u, 30u}) {
      const Field field =
          build_field(city().scene, slabs_around(box_of(city().scene)), city().cells, {{4, 4, 8, 8}, ids, 3, false, 2});
      const auto now = marked(field, camera, {.pixels = 50});
      EXPECT_TRUE(within(before, now));
      before = now;
    }
  }
}

TEST(FieldQuery, NothingIsLostByTheMipmapAndItHelpsFromFarAway) {
  std::size_t near = 0, far = 0, with = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    const Camera close = cameras_around(city().scene, 5)[k], away = cameras_around(city().scene, 5, 30)[k];
    const FieldQueryOptions plain{.pixels = 40}, levels{.pixels = 40, .mipmap = true};
    EXPECT_TRUE(within(marked(city().field, close, plain), marked(city().field, close, levels)));
    EXPECT_TRUE(within(marked(city().field, away, plain), marked(city().field, away, levels)));
    near += marked(city().field, close, plain).size();
    far += marked(city().field, away, plain).size();
    with += marked(city().field, away, levels).size();
  }
  EXPECT_LT(far, near / 2);  // few pixels meet the scene
  EXPECT_GT(with, 2 * far);
}

TEST(FieldQuery, CellsOfViewsBeforeStayMarked) {
  const auto views = city().cameras;
  std::vector<std::vector<std::uint32_t>> alone;
  for (const Camera& camera : views) alone.push_back(marked(city().field, camera, {.pixels = 30}));
  for (const std::uint32_t keep : {0u, 1u, 3u}) {
    FieldQuery query(city().field, {.pixels = 30, .keep = keep});
    for (std::size_t k = 0; k < views.size(); ++k) {
      std::vector<std::uint32_t> expected;
      for (std::size_t i = k - std::min<std::size_t>(k, keep); i <= k; ++i) {
        expected.insert(expected.end(), alone[i].begin(), alone[i].end());
      }
      std::ranges::sort(expected);
      expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
      EXPECT_EQ(query.mark(views[k]).cells, expected);
    }
  }
}

/// What looks along the ray through the middle of a sample has that sample's cells, and no others.
void expect_samples(const Scene& scene, const std::vector<FieldSlab>& slabs, double how_far) {
  const Field field = build_field(scene, slabs, grid_of(scene), {{4, 5, 6, 7}, 4, 3, false, 2});
  std::mt19937_64 random(5);
  std::size_t something = 0;
  for (int k = 0; k < 300; ++k) {
    const std::size_t slab = random() % slabs.size();
    const std::array<std::uint32_t, 4> at{
        static_cast<std::uint32_t>(random() % 4), static_cast<std::uint32_t>(random() % 5),
        static_cast<std::uint32_t>(random() % 6), static_cast<std::uint32_t>(random() % 7)};
    std::array<double, 4> middle;
    for (std::size_t axis = 0; axis < 4; ++axis) middle[axis] = (at[axis] + 0.5) / field.levels[0].size[axis];
    const FieldRay ray = ray_of(slabs[slab], middle);
    const double step = slabs[slab].begin + how_far * (slabs[slab].end - slabs[slab].begin);
    const glm::dvec3 eye = ray.origin + (step - slabs[slab].begin) * ray.direction;
    const auto cells = marked(field, make_camera(eye, ray.direction, {0.2, 0.3, 0.9}, 40, 1), {.pixels = 1});
    const auto expected = held(field, 0, field.levels[0].place(slab, at));
    EXPECT_TRUE(within(expected, cells));
    // Each line is in one slab where uv is at infinity.
    EXPECT_TRUE(!slabs.front().infinite || cells == expected);
    something += expected.size();
  }
  EXPECT_GT(something, 20u);
}

TEST(FieldQuery, FindsTheSampleOfALine) {
  const Scene scene = model_scene("city");
  expect_samples(scene, slabs_around(box_of(scene)), 0);
  expect_samples(scene, slabs_around(box_of(scene), 1.5), 0);
  expect_samples(scene, slabs_within(FieldBox{{-2, -2, 1}, {3, 3, 4}}), 0.3);
}

TEST(FieldQuery, AFineFieldMarksWhatRaysMeet) {
  const Scene& scene = city().scene;
  const FieldCells cells = grid_of(scene, 2);
  const Field field = build_field(scene, slabs_around(box_of(scene)), cells, {{6, 6, 20, 20}, 65535, 3, false, 2});
  const RayCaster caster(scene);
  for (const Camera& camera : city().cameras) {
    const FieldMarks rays = trace_marks(caster, scene, cells, camera, 100, 2);
    const auto found = marked(field, camera, {.pixels = 100, .filter = FieldFilter::uvst});
    std::size_t missed = 0;
    for (const std::uint32_t cell : rays.cells) missed += std::ranges::binary_search(found, cell) ? 0 : 1;
    EXPECT_GT(rays.cells.size(), 30u);
    EXPECT_LE(missed, rays.cells.size() / 50);
    EXPECT_LT(found.size(), cells.count);
    EXPECT_EQ(rays.looked_up, 2500u);
  }
}

TEST(FieldQuery, TracingMarksWhatLiesUnderPixels) {
  const Scene& scene = city().scene;
  const FieldCells cells = cells_of_polygons(scene);
  const RayCaster caster(scene);
  IdBuffer buffer(scene, 60);
  for (const Camera& camera : city().cameras) {
    const auto items = buffer.draw(camera);
    std::vector<PolygonId> expected(items.begin(), items.end());
    std::erase(expected, none);
    std::ranges::sort(expected);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    EXPECT_EQ(polygons_of(cells, trace_marks(caster, scene, cells, camera, 60, 1).cells), expected);
  }
}

TEST(FieldQuery, TellsWhatItDoesNotCover) {
  const Scene& scene = city().scene;
  const Field field =
      build_field(scene, {slab_before(box_of(scene), 2, true, 1)}, city().cells, {{4, 4, 4, 4}, 1, 1, false, 1});
  const FieldBox box = box_of(scene);
  const glm::dvec3 middle = 0.5 * (box.low + box.high), above = middle + glm::dvec3(0, 0, 3 * (box.high.z - box.low.z));
  const FieldMarks down = FieldQuery(field, {.pixels = 20}).mark(make_camera(above, {0, 0, -1}, {0, 1, 0}, 20, 1));
  const FieldMarks up = FieldQuery(field, {.pixels = 20}).mark(make_camera(above, {0, 0, 1}, {0, 1, 0}, 20, 1));
  EXPECT_EQ(down.covered, down.pixels);
  EXPECT_FALSE(down.cells.empty());
  EXPECT_EQ(up.covered, 0u);
  EXPECT_TRUE(up.cells.empty());
  EXPECT_THROW(FieldQuery(field, {.pixels = 0}), std::invalid_argument);
  EXPECT_THROW(FieldQuery(field, {.pixels = 4, .subsample = 5}), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::test
