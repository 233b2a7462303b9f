#include "tests/visibility_map/sketch.hpp"
#include "visibility_map/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sightline {
namespace {

TEST(Visible, ASquareBeforeAWall) {
  const Scene scene = make_scene(SquareBeforeWall::polygons());
  const auto seen = visible_polygons(SquareBeforeWall::map(), scene);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].polygon, 0u);
  EXPECT_FALSE(seen[0].full);
  EXPECT_EQ(seen[0].area, 0.75);
  EXPECT_EQ(seen[0].fraction, 0.75);
  EXPECT_EQ(seen[1].polygon, 1u);
  EXPECT_TRUE(seen[1].full);
  EXPECT_EQ(seen[1].area, 0.25);
  EXPECT_EQ(seen[1].fraction, 1);
  EXPECT_EQ(map_csv(SquareBeforeWall::map(), scene, 7), "7,0,partial,0.75,0.75\n7,1,full,0.25,1\n");
}

/// A wall at y = 2 on the left up to x = `end`, and a nearer one at y = 1 on the right from s = 1/4 on.
struct TwoWalls {
  explicit TwoWalls(double end)
      : scene(make_scene(soup(
            {{-2, 2, -2}, {end, 2, -2}, {end, 2, 2}, {-2, 2, 2}, {-0.25, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-0.25, 1, 1}},
            {{0, 1, 2, 3}, {4, 5, 6, 7}}))) {
    Sketch sketch;
    const std::uint32_t near = sketch.line(4, 7);
    sketch.vertex({0, 0}, 0, 2);
    sketch.vertex({0.25, 0}, near, 2);
    sketch.vertex({1, 0}, 1, 2);
    sketch.vertex({1, 1}, 1, 3);
    sketch.vertex({0.25, 1}, near, 3);
    sketch.vertex({0, 1}, 0, 3);
    const std::uint32_t border[6] = {2, 2, 1, 3, 3, 0};
    for (std::uint32_t k = 0; k < 6; ++k) sketch.edge(k, (k + 1) % 6, border[k], EdgeKind::window);
    sketch.edge(1, 4, near, EdgeKind::silhouette, 1);
    sketch.face(0, {{0, 1, 4, 5}}, 0.25, 0);
    sketch.face(1, {{1, 2, 3, 4}}, 0.75, 0);
    map = sketch.result;
  }
  VisibilityMap map;
  Scene scene;
};

TEST(Visible, FullWhereItEndsJustBehindTheEdgeOfSomethingNearer) {
  const TwoWalls walls(-0.5);  // ends at s = 1/4
  const auto seen = visible_polygons(walls.map, walls.scene);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_TRUE(seen[0].full);
  EXPECT_TRUE(seen[1].full);
}

TEST(Visible, PartialWhereTheLeastOfItIsHidden) {
  const TwoWalls walls(std::nextafter(-0.5, 0));  // a hair beyond
  const auto seen = visible_polygons(walls.map, walls.scene);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_FALSE(seen[0].full);
  EXPECT_NEAR(seen[0].fraction, 1, 1e-12);
  EXPECT_TRUE(seen[1].full);
  EXPECT_NEAR(visible_polygons(TwoWalls(0.5).map, TwoWalls(0.5).scene)[0].fraction, 1.0 / 3, 1e-15);
}

TEST(Visible, AMirroredCameraSeesTheSame) {
  TwoWalls walls(-0.5);
  walls.map.camera.forward = {0, 1, 0};
  walls.map.camera.up = {0, 0, -1};
  for (MapVertex& v : walls.map.vertices) v.st.y = 1 - v.st.y;
  for (MapLine& line : walls.map.lines) {
    if (line.kind == MapLine::window && line.v[0] >= 2) line.v[0] = 5 - line.v[0];
  }
  for (MapEdge& e : walls.map.edges) std::swap(e.left, e.right);
  for (std::int32_t& e : walls.map.loop_edges) e = -e - 1;
  for (std::uint32_t k = 0; k < 2; ++k) {
    std::reverse(walls.map.loop_edges.begin() + walls.map.first_edge[k],
                 walls.map.loop_edges.begin() + walls.map.first_edge[k + 1]);
  }
  const auto seen = visible_polygons(walls.map, walls.scene);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_TRUE(seen[0].full);
  EXPECT_TRUE(seen[1].full);
}

/// A polygon of two triangles, ABC and, behind it, ACD, which lies within ABC as seen from the eye; polygon 1 hides
/// everything from s = 1/2 on if `hidden`.
struct Folded {
  explicit Folded(bool hidden)
      : scene(make_scene(soup({{-0.25, 1, -0.25},
                               {0.25, 1, -0.25},
                               {0.25, 1, 0.25},
                               {0.25, 2, -0.25},
                               {0, 0.5, -1},
                               {1, 0.5, -1},
                               {1, 0.5, 1},
                               {0, 0.5, 1}},
                              {{0, 1, 2, 3}, {4, 5, 6, 7}}))) {
    Sketch sketch;
    const std::uint32_t low = sketch.line(0, 1), right = sketch.line(1, 2), slope = sketch.line(0, 2),
                        screen = sketch.line(4, 7);
    const EdgeKind silhouette = EdgeKind::silhouette;
    if (!hidden) {
      for (const double t : {0.0, 1.0}) {
        for (const double s : {t, 1 - t}) sketch.vertex({s, t}, s == 0 ? 0 : 1, t == 0 ? 2 : 3);
      }
      sketch.vertex({0.25, 0.25}, low, slope, 0);
      sketch.vertex({0.75, 0.25}, low, right, 1);
      sketch.vertex({0.75, 0.75}, right, slope, 2);
      const std::uint32_t border[4] = {2, 1, 3, 0}, sides[3] = {low, right, slope};
      for (std::uint32_t k = 0; k < 4; ++k) sketch.edge(k, (k + 1) % 4, border[k], EdgeKind::window);
      for (std::uint32_t k = 0; k < 3; ++k) sketch.edge(4 + k, 4 + (k + 1) % 3, sides[k], silhouette, 0);
      sketch.face(none, {{0, 1, 2, 3}, {4, 6, 5}}, 0.875, 0);
      sketch.face(0, {{4, 5, 6}}, 0.125, 0);
    } else {
      sketch.vertex({0, 0}, 0, 2);
      sketch.vertex({0.5, 0}, screen, 2);
      sketch.vertex({1, 0}, 1, 2);
      sketch.vertex({1, 1}, 1, 3);
      sketch.vertex({0.5, 1}, screen, 3);
      sketch.vertex({0, 1}, 0, 3);
      const std::uint32_t border[6] = {2, 2, 1, 3, 3, 0};
      for (std::uint32_t k = 0; k < 6; ++k) sketch.edge(k, (k + 1) % 6, border[k], EdgeKind::window);
      sketch.vertex({0.5, 0.25}, low, screen);
      sketch.vertex({0.5, 0.5}, slope, screen);
      sketch.vertex({0.25, 0.25}, low, slope, 0);
      sketch.edge(1, 6, screen, silhouette, 1);
      sketch.edge(6, 7, screen, silhouette, 1);
      sketch.edge(7, 4, screen, silhouette, 1);
      sketch.edge(8, 6, low, silhouette, 0);
      sketch.edge(7, 8, slope, silhouette, 0);
      sketch.face(none, {{0, 1, 6, 8, 7, 4, 5}}, 0.5 - 0.03125, 0);
      sketch.face(0, {{8, 6, 7}}, 0.03125, 0);
      sketch.face(1, {{1, 2, 3, 4, 7, 6}}, 0.5, 0);
    }
    map = sketch.result;
  }
  VisibilityMap map;
  Scene scene;
};

TEST(Visible, PartsOfAFoldedPolygonMayHideEachOther) {
  const Folded open(false);
  ASSERT_FALSE(open.scene.planar(0));
  const auto seen = visible_polygons(open.map, open.scene);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_TRUE(seen[0].full);
  EXPECT_EQ(seen[0].area, 0.125);
  EXPECT_EQ(seen[0].fraction, 1);
}

TEST(Visible, AFoldedPolygonsProjectionIsTheUnion) {
  const Folded folded(true);
  const auto seen = visible_polygons(folded.map, folded.scene);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_FALSE(seen[0].full);
  EXPECT_EQ(seen[0].area, 0.03125);
  EXPECT_DOUBLE_EQ(seen[0].fraction, 0.25);
  EXPECT_TRUE(seen[1].full);
}

}  // namespace
}  // namespace sightline
