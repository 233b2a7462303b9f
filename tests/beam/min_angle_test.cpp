// Beams too narrow to be followed: what is left out is bounded.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "beam/trace.hpp"
#include "tests/beam/turned.hpp"
#include "visibility_map/write.hpp"

namespace sightline {
namespace {

std::map<PolygonId, double> areas(const VisibilityMap& map) {
  std::map<PolygonId, double> by_polygon;
  for (const MapFace& face : map.faces) by_polygon[face.polygon] += face.area;
  return by_polygon;
}

TEST(MinAngle, WhatItLeavesOutIsBounded) {
  double left_out = 0;
  for (const auto& [name, polygons] : {std::pair{"building", 1000u}, {"city", 400u}, {"maze", 0u}, {"random", 60u}}) {
    const Turned turned(name, polygons, 17);
    const BspTree tree(*turned.scene);
    Tracer exact(tree);
    for (const double angle : {1e-12, 1e-9, 1e-4}) {
      Tracer tracer(tree, {angle});
      for (const Camera& camera : turned.cameras) {
        VisibilityMap whole, part;
        TraceStats stats;
        exact.trace(camera, whole);
        tracer.trace(camera, part, &stats);
        std::map<PolygonId, double> difference = areas(whole);
        for (const auto& [polygon, area] : areas(part)) difference[polygon] -= area;
        double lost = 0;
        for (const auto& [polygon, area] : difference) {
          if (polygon != none) {
            EXPECT_GE(area, -1e-12) << name << " " << angle;  // nothing is seen that is hidden
          }
          lost += std::abs(area) / 2;
        }
        EXPECT_LE(lost, stats.left_out + 1e-12) << name << " " << angle;
        EXPECT_LE(stats.left_out, 1e5 * angle) << name;
        left_out = std::max(left_out, stats.left_out);
        std::vector<PolygonId> all, some;
        exact.visible(camera, all);
        tracer.visible(camera, some);
        EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
      }
    }
  }
  EXPECT_GT(left_out, 0);  // there was something to leave out
}

TEST(MinAngle, NothingIsLeftOutWhereNothingIsNarrow) {
  const Turned turned("building", 1000, 0);
  const BspTree tree(*turned.scene);
  Tracer exact(tree), tracer(tree, {1e-12});
  for (const Camera& camera : turned.cameras) {
    VisibilityMap a, b;
    TraceStats stats;
    exact.trace(camera, a);
    tracer.trace(camera, b, &stats);
    EXPECT_EQ(stats.left_out, 0);
    EXPECT_EQ(map_json(a, *turned.scene), map_json(b, *turned.scene));
  }
}

TEST(MinAngle, IsRefusedOutOfRange) {
  const Turned turned("maze", 0, 0);
  const BspTree tree(*turned.scene);
  for (const double angle : {-1e-9, 0.02, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Tracer(tree, {angle}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace sightline
