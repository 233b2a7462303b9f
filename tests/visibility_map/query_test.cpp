#include "visibility_map/query.hpp"

#include "tests/visibility_map/sketch.hpp"

#include <gtest/gtest.h>

namespace sightline {
namespace {

using List = std::vector<std::uint32_t>;

List list(std::span<const std::uint32_t> values) { return {values.begin(), values.end()}; }

TEST(Adjacency, OfASquareBeforeAWall) {
  const VisibilityMap map = SquareBeforeWall::map();
  const MapAdjacency adjacency(map);
  EXPECT_EQ(list(adjacency.polygons()), (List{0, 1}));
  EXPECT_EQ(list(adjacency.faces_of(0)), (List{0}));
  EXPECT_EQ(list(adjacency.faces_of(1)), (List{1}));
  EXPECT_EQ(list(adjacency.faces_of(2)), List{});
  EXPECT_EQ(list(adjacency.faces_of(none)), List{});
  EXPECT_EQ(list(adjacency.edges_of(0)), (List{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(list(adjacency.edges_of(1)), (List{4, 5, 6, 7}));
  EXPECT_EQ(list(adjacency.edges_of(7)), List{});
  EXPECT_EQ(list(adjacency.neighbours(0)), (List{1}));
  EXPECT_EQ(list(adjacency.neighbours(1)), (List{0}));
  EXPECT_EQ(list(adjacency.edges_at(0)), (List{0, 3}));
  EXPECT_EQ(list(adjacency.edges_at(6)), (List{5, 6}));
}

TEST(Adjacency, NothingSeenHasFacesToo) {
  VisibilityMap map = SquareBeforeWall::map();
  map.faces[0].polygon = none;
  const MapAdjacency adjacency(map);
  EXPECT_EQ(list(adjacency.polygons()), (List{1}));
  EXPECT_EQ(list(adjacency.faces_of(none)), (List{0}));
  EXPECT_EQ(list(adjacency.faces_of(0)), List{});
  EXPECT_EQ(list(adjacency.edges_of(none)).size(), 8u);
}

TEST(Loops, EntriesKnowTheirEnds) {
  const VisibilityMap map = SquareBeforeWall::map();
  for (std::uint32_t k = 0; k + 1 < map.first_edge.size(); ++k) {
    const auto loop = map.loop(k);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(end_vertex(map, loop[i]), start_vertex(map, loop[(i + 1) % loop.size()]));
    }
  }
  EXPECT_EQ(edge_of(-1), 0u);
  EXPECT_EQ(edge_of(5), 5u);
}

}  // namespace
}  // namespace sightline
