// Laws 3 and 4 of model.hpp, by exact rays.
#include "tests/models/integer_polygons.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sightline {
namespace {

using namespace models_test;

/// No two of them in a plane with an axis, none along a wall of any model.
constexpr std::array<std::array<std::int64_t, 3>, 6> directions{
    {{7, 3, -2}, {-5, 7, 1}, {-3, -11, 2}, {11, -2, 3}, {2, 5, 13}, {-1, 3, -17}}};

struct Case {
  const char* name;
  std::uint32_t polygons;
  bool solid;           // has an inside and an outside
  bool steps_are_free;  // the straight line from each eye to the next is free
};

class ModelCameras : public testing::TestWithParam<Case> {
 protected:
  const Model model = make_model(GetParam().name, {.polygons = GetParam().polygons});
  const std::vector<Polygon> polygons = whole_polygons(model.soup);
};

TEST_P(ModelCameras, AreWhatTheyShouldBe) {
  for (const CameraLine& camera : model.cameras) {
    EXPECT_EQ(camera.vertical_fov_degrees, 60);
    EXPECT_EQ(camera.aspect, 4.0 / 3.0);
    const glm::dvec3 f = camera.forward;
    EXPECT_NEAR(f.x * f.x + f.y * f.y + f.z * f.z, 1, 1e-5);
    EXPECT_LT(std::abs(f.z), 0.95);  // far from straight up
    EXPECT_EQ(camera.up, glm::dvec3(0, 0, 1));
    EXPECT_NO_THROW(whole(camera.eye));
  }
}

TEST_P(ModelCameras, EyesAreInFreeSpace) {
  for (std::size_t c = 0; c < model.cameras.size(); ++c) {
    const Vector eye = whole(model.cameras[c].eye);
    for (const auto& [x, y, z] : directions) {
      Hit nearest;
      for (const Polygon& polygon : polygons) {
        const Hit found = hit(polygon, eye, {x, y, z});
        if (!found.any || found.along < 0) continue;
        ASSERT_NE(found.along, 0) << "eye " << c << " lies on a polygon";
        if (!nearest.any || found.along * nearest.of < nearest.along * found.of) nearest = found;
      }
      if (!GetParam().solid || !nearest.any) continue;
      ASSERT_TRUE(nearest.from_front) << "eye " << c << " is within a wall";
      if (polygons.size() > 5000) break;  // one ray tells; more of them also look for holes in walls
    }
  }
}

TEST_P(ModelCameras, WalksCrossNothing) {
  if (!GetParam().steps_are_free) return;
  for (std::size_t c = 1; c < model.cameras.size(); ++c) {
    const Vector from = whole(model.cameras[c - 1].eye), to = whole(model.cameras[c].eye);
    ASSERT_NE(from, to);
    for (const Polygon& polygon : polygons) {
      const Hit found = hit(polygon, from, to - from);
      ASSERT_FALSE(found.any && found.along >= 0 && found.along <= found.of) << "step to eye " << c;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, ModelCameras,
    testing::Values(Case{"rooms", 0, false, true}, Case{"maze", 0, false, true}, Case{"arena", 0, true, true},
                    Case{"city", 0, true, true}, Case{"city", 11, true, true}, Case{"city", 300, true, true},
                    Case{"city", 10000, true, true}, Case{"floor", 0, true, false}, Case{"building", 0, true, false},
                    Case{"building", 60, true, true}, Case{"building", 800, true, false},
                    Case{"building", 30000, true, false}, Case{"tower", 0, true, false}, Case{"campus", 0, true, false},
                    Case{"random", 0, false, false}),
    [](const auto& test) { return std::string(test.param.name) + "_" + std::to_string(test.param.polygons); });

/// The ray test itself: a wall seen from behind, and one that is crossed, are noticed.
TEST(ExactRays, NoticeWhatIsWrong) {
  const Polygon square{{{64, -10, -10}, {64, 10, -10}, {64, 10, 10}, {64, -10, 10}}, {400, 0, 0}};
  const Hit behind = hit(square, {0, 0, 0}, {7, 0, 0});
  EXPECT_TRUE(behind.any);
  EXPECT_FALSE(behind.from_front);
  EXPECT_TRUE(behind.along * 7 == behind.of * 64);
  EXPECT_TRUE(hit(square, {128, 0, 0}, {-7, 1, 0}).from_front);
  EXPECT_FALSE(hit(square, {0, 0, 0}, {7, 2, 0}).any);
}

}  // namespace
}  // namespace sightline
