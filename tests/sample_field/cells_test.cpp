// Partitions of polygons.
#include "tests/sample_field/scenes.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace sightline::test {
namespace {

void expect_partition(const Scene& scene, const FieldCells& cells) {
  ASSERT_EQ(cells.of.size(), scene.polygon_count());
  std::set<std::uint32_t> used;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    EXPECT_EQ(cells.of[p] == none, scene.surfaces(p).empty());
    if (cells.of[p] != none) used.insert(cells.of[p]);
  }
  EXPECT_EQ(used.size(), cells.count);
  EXPECT_TRUE(used.empty() || *used.rbegin() == cells.count - 1);
}

TEST(Cells, ArePartitions) {
  const Scene scene = model_scene("city");
  const auto slabs = slabs_around(box_of(scene));
  std::uint32_t before = 0;
  for (const double along : {1.0, 2.0, 4.0, 8.5, 16.0}) {
    const FieldCells cells = cells_of_scene(scene, along), parts = grid_of(scene, along);
    expect_partition(scene, cells);
    expect_partition(scene, parts);
    EXPECT_GT(cells.count, before);
    EXPECT_GE(parts.count, cells.count);
    before = cells.count;
  }
  EXPECT_EQ(cells_of_scene(scene, 1).count, 1u);
  EXPECT_EQ(cells_of_polygons(scene).count, scene.polygon_count());
  for (const double samples : {0.25, 1.0, 3.0}) {
    expect_partition(scene, cells_of_octree(scene, slabs, {4, 4, 16, 16}, samples));
  }
}

TEST(Cells, OfAnObjectStayWithinIt) {
  const Scene scene = model_scene("city");
  const auto objects = field_objects(scene, FieldObjects::named);
  const FieldCells cells = grid_of(scene, 3);
  std::vector<std::uint32_t> object_of(cells.count, none);
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (cells.of[p] == none) continue;
    std::uint32_t& object = object_of[cells.of[p]];
    if (object == none) object = objects[p];
    EXPECT_EQ(object, objects[p]);
  }
}

TEST(Cells, ConnectedObjectsHaveCommonVerticesByPlace) {
  // Two squares that touch in an edge, by copies of its vertices; a third apart; a fourth without area.
  PolygonSoup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 1},
                   {2, 1, 1}, {1, 1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}};
  soup.corners = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0, 0, 1};
  soup.first = {0, 4, 8, 12, 15};
  const Scene scene = make_scene(soup);
  EXPECT_EQ(field_objects(scene, FieldObjects::connected), (std::vector<std::uint32_t>{0, 0, 1, none}));
  EXPECT_EQ(field_objects(scene, FieldObjects::named), (std::vector<std::uint32_t>{0, 0, 0, none}));
}

TEST(Cells, OfAnOctreeAreAsFineAsSamplesThere) {
  const Scene scene = model_scene("random", 400);
  const auto slabs = slabs_around(box_of(scene));
  std::uint32_t before = 0;
  for (const std::uint32_t n : {2u, 4u, 8u, 16u, 32u}) {
    const std::uint32_t count = cells_of_octree(scene, slabs, {4, 4, n, n}, 1).count;
    EXPECT_GE(count, before);
    before = count;
  }
  EXPECT_GT(before, 50u);
  EXPECT_EQ(cells_of_octree(scene, slabs, {4, 4, 16, 16}, 4096).count, 1u);
}

TEST(Cells, AreNamed) {
  EXPECT_EQ(parse_cells("polygon").kind, CellName::polygon);
  EXPECT_EQ(parse_cells("object:16").setting, 16);
  EXPECT_EQ(parse_cells("scene:2.5").setting, 2.5);
  EXPECT_EQ(parse_cells("octree:0.5").kind, CellName::octree);
  for (const char* bad :
       {"", "cube:3", "object", "object:", "object:0", "object:4097", "object:3x", "octree:nan", "scene:-1"}) {
    EXPECT_THROW(parse_cells(bad), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace sightline::test
