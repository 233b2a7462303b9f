// A polygon that is there very many times: time and memory grow with their number, not with its square.
#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "visibility_map/write.hpp"

#include <gtest/gtest.h>

namespace sightline {
namespace {

Scene copies(std::uint32_t count) {
  PolygonSoup soup;
  soup.vertices = {{-1, 5, -1}, {1, 5, -1}, {1, 5, 1}, {-1, 5, 1}};
  for (std::uint32_t k = 0; k < count; ++k) {
    soup.corners.insert(soup.corners.end(), {0, 1, 2, 3});
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return make_scene(std::move(soup));
}

/// The lowest index owns it, all others are named. Lists of each pair would take 20 GB here.
TEST(Copies, AHundredThousand) {
  constexpr std::uint32_t count = 100'000;
  const Scene scene = copies(count);
  const BspTree tree(scene);
  VisibilityMap map;
  Tracer(tree).trace(Camera{}, map);
  ASSERT_EQ(map.faces.size(), 2u);
  const std::string json = map_json(map, scene);
  EXPECT_NE(json.find("\"polygon\": 0, \"coincident\": [1, 2, 3, "), std::string::npos) << json.substr(0, 4000);
  EXPECT_NE(json.find(", 99998, 99999]"), std::string::npos);
}

TEST(Copies, EnginesMakeTheSameMap) {
  const Scene scene = copies(1000);
  const BspTree tree(scene);
  const Complex complex = build(scene);
  VisibilityMap map, other;
  Tracer(tree).trace(Camera{}, map);
  Tracer(scene, complex).trace(Camera{}, other);
  EXPECT_EQ(map_json(map, scene), map_json(other, scene));
}

}  // namespace
}  // namespace sightline
