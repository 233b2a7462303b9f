// Two maps in memory that must be one: for maps of the sphere, which have no file.
#pragma once

#include <gtest/gtest.h>

#include "visibility_map/map.hpp"

namespace sightline {

inline void expect_equal(const VisibilityMap& a, const VisibilityMap& b) {
  ASSERT_EQ(a.lines, b.lines);
  ASSERT_EQ(a.loop_edges, b.loop_edges);
  ASSERT_EQ(a.first_edge, b.first_edge);
  ASSERT_EQ(a.coincident, b.coincident);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t k = 0; k < a.vertices.size(); ++k) {
    EXPECT_EQ(a.vertices[k].direction, b.vertices[k].direction);
    EXPECT_EQ(a.vertices[k].st, b.vertices[k].st);
    EXPECT_EQ(a.vertices[k].scene_vertex, b.vertices[k].scene_vertex);
  }
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t k = 0; k < a.edges.size(); ++k) {
    EXPECT_EQ(a.edges[k].line, b.edges[k].line);
    EXPECT_EQ(a.edges[k].kind, b.edges[k].kind);
    EXPECT_EQ(a.edges[k].owner, b.edges[k].owner);
  }
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (std::size_t k = 0; k < a.faces.size(); ++k) {
    EXPECT_EQ(a.faces[k].polygon, b.faces[k].polygon);
    EXPECT_EQ(a.faces[k].solid_angle, b.faces[k].solid_angle);
  }
}

}  // namespace sightline
