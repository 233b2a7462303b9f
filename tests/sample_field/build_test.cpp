// Laws of what samples hold.
#include "tests/sample_field/scenes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>

namespace sightline::test {
namespace {

constexpr std::uint32_t all_ids = 65535;

TEST(FieldBuild, IsTheSameAtAnyNumberOfThreads) {
  const Scene scene = model_scene("city", 0, 17);
  const auto slabs = slabs_around(box_of(scene));
  std::string first;
  for (const unsigned threads : {1u, 2u, 5u}) {
    std::atomic<std::size_t> steps = 0;
    const FieldOptions options{{5, 4, 6, 7}, 3, 3, true, threads};
    const Field field = build_field(scene, slabs, grid_of(scene), options, [&] { ++steps; });
    EXPECT_EQ(steps, field_steps(slabs, options));
    const std::string bytes = field_bytes(field);
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first) << threads;
  }
}

TEST(FieldBuild, SamplesHoldNoMoreThanTheirIdsAndMoreIdsHoldMore) {
  const Scene scene = model_scene("city");
  const auto slabs = slabs_within(FieldBox{{-6, -6, 1}, {6, 6, 9}});
  Field before;
  bool grew = false;
  for (const std::uint32_t ids : {1u, 2u, 5u, 20u, all_ids}) {
    Field field = build_field(scene, slabs, grid_of(scene), {{3, 3, 5, 5}, ids, 3, false, 1});
    for (std::size_t k = 0; k < field.levels[0].lists.size(); ++k) {
      const auto now = held(field, 0, k);
      EXPECT_LE(now.size(), ids);
      if (before.levels.empty()) continue;
      const auto then = held(before, 0, k);
      EXPECT_TRUE(within(then, now));
      grew = grew || now.size() > then.size();
    }
    before = std::move(field);
  }
  EXPECT_TRUE(grew);
}

/// The 81 samples of a field three times as fine that take the place of sample `at`.
std::vector<std::uint32_t> together(const Field& fine, std::size_t slab, const std::array<std::uint32_t, 4>& at) {
  std::set<std::uint32_t> cells;
  for (std::uint32_t k = 0; k < 81; ++k) {
    const std::array<std::uint32_t, 4> part{3 * at[0] + k % 3, 3 * at[1] + k / 3 % 3, 3 * at[2] + k / 9 % 3,
                                            3 * at[3] + k / 27};
    for (const std::uint32_t cell : held(fine, 0, fine.levels[0].place(slab, part))) cells.insert(cell);
  }
  return {cells.begin(), cells.end()};
}

TEST(FieldBuild, SamplesThreeTimesAsFineHoldTheSameRays) {
  for (const bool inside : {false, true}) {
    const Scene scene = model_scene("city", 0, inside ? 29 : 0);
    const auto slabs = inside ? slabs_within(FieldBox{{-3, -3, 1}, {3, 3, 5}}) : slabs_around(box_of(scene));
    const FieldCells cells = grid_of(scene);
    const Field coarse = build_field(scene, slabs, cells, {{2, 3, 4, 2}, all_ids, 3, false, 1});
    const Field fine = build_field(scene, slabs, cells, {{6, 9, 12, 6}, all_ids, 1, false, 1});
    const Field finer = build_field(scene, slabs, cells, {{6, 9, 12, 6}, all_ids, 3, false, 1});
    bool something = false;
    for (std::size_t slab = 0; slab < slabs.size(); ++slab) {
      for (std::uint32_t k = 0; k < 48; ++k) {
        const std::array<std::uint32_t, 4> at{k % 2, k / 2 % 3, k / 6 % 4, k / 24};
        const auto whole = held(coarse, 0, coarse.levels[0].place(slab, at));
        EXPECT_EQ(whole, together(fine, slab, at));
        EXPECT_TRUE(within(whole, together(finer, slab, at)));
        something = something || whole.size() > 3;
      }
    }
    EXPECT_TRUE(something);
  }
}

TEST(FieldBuild, MipmapsHoldWhatIsBelowThemAndNoMore) {
  const Scene scene = model_scene("city");
  const Field field = build_field(scene, slabs_around(box_of(scene)), grid_of(scene), {{3, 2, 5, 8}, 2, 3, true, 2});
  ASSERT_EQ(field.levels.size(), 4u);
  for (std::size_t level = 1; level < field.levels.size(); ++level) {
    const FieldLevel &above = field.levels[level], &below = field.levels[level - 1];
    std::vector<std::set<std::uint32_t>> expected(above.lists.size());
    for (std::size_t slab = 0; slab < 6; ++slab) {
      const auto [U, V, S, T] = below.size;
      for (std::uint32_t u = 0; u < U; ++u)
        for (std::uint32_t v = 0; v < V; ++v)
          for (std::uint32_t s = 0; s < S; ++s)
            for (std::uint32_t t = 0; t < T; ++t)
              for (const std::uint32_t cell : held(field, level - 1, below.place(slab, {u, v, s, t})))
                expected[above.place(slab, {u / 2, v / 2, s / 2, t / 2})].insert(cell);
    }
    for (std::size_t k = 0; k < above.lists.size(); ++k) {
      EXPECT_EQ(held(field, level, k), std::vector<std::uint32_t>(expected[k].begin(), expected[k].end()));
    }
  }
  EXPECT_EQ(field.levels.back().samples_of_slab(), 1u);
}

TEST(FieldBuild, ARaySeesTheNearestFromOutsideAndAllThatAViewerWithinMaySee) {
  // Three walls across the x axis, at 1, 2 and 3.
  PolygonSoup soup;
  for (int k = 1; k <= 3; ++k) {
    const auto base = static_cast<std::uint32_t>(soup.vertices.size());
    for (const auto& [y, z] : {std::pair{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}) soup.vertices.emplace_back(k, y, z);
    for (std::uint32_t c = 0; c < 4; ++c) soup.corners.push_back(base + c);
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  const Scene scene = make_scene(soup);
  const FieldCells cells = cells_of_polygons(scene);
  const auto first_of = [&](const std::vector<FieldSlab>& slabs) {
    const Field field = build_field(scene, {slabs[0]}, cells, {{1, 1, 1, 1}, all_ids, 1, false, 1});
    return held(field, 0, 0);
  };
  EXPECT_EQ(first_of(slabs_around(box_of(scene))), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(first_of(slabs_within(FieldBox{{0, -1, -1}, {0.5, 1, 1}})), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(first_of(slabs_within(FieldBox{{0, -1, -1}, {1.5, 1, 1}})), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(first_of(slabs_within(FieldBox{{1.5, -1, -1}, {1.8, 1, 1}})), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(first_of(slabs_within(FieldBox{{0, -1, -1}, {9, 1, 1}})), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(FieldBuild, RefusesWhatCannotBe) {
  const Scene scene = model_scene("rooms");
  const auto slabs = slabs_around(box_of(scene));
  const FieldCells cells = cells_of_polygons(scene);
  EXPECT_THROW(build_field(scene, {}, cells, {}), std::invalid_argument);
  EXPECT_THROW(build_field(scene, slabs, cells, {.samples = {0, 1, 1, 1}}), std::invalid_argument);
  EXPECT_THROW(build_field(scene, slabs, cells, {.samples = {1, 1, 1, 4097}}), std::invalid_argument);
  EXPECT_THROW(build_field(scene, slabs, cells, {.ids = 0}), std::invalid_argument);
  EXPECT_THROW(build_field(scene, slabs, cells, {.rays = 2}), std::invalid_argument);
  EXPECT_THROW(build_field(scene, slabs, cells, {.samples = {4096, 4096, 4096, 1}}), std::length_error);
}

}  // namespace
}  // namespace sightline::test
