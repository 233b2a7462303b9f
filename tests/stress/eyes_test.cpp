// Eyes on planes, edges and vertices, in corners, collinear with edges, and one unit in the last place beside them.
#include <gtest/gtest.h>

#include "models/model.hpp"
#include "tests/stress/figures.hpp"
#include "tests/stress/judge.hpp"

namespace sightline::stress {
namespace {

TEST(StressEyes, InSmallScenes) {
  for (std::uint64_t seed = 0; seed < times(60); ++seed) {
    Random random(seed + 1000);
    const Case sample = testing::make_case(seed, 3 + static_cast<int>(seed % 4));
    Court court(sample.soup, sample.options);
    for (int k = 0; k < 3; ++k) {
      court.check(hard_camera(sample.soup, random), "seed " + std::to_string(seed) + " eye " + std::to_string(k));
    }
  }
}

void in_model(const std::string& name, double degrees, std::uint64_t eyes) {
  const Model model = make_model(name, {.rotate_degrees = degrees});
  Court court(model.soup, {}, {.oracle = false, .verifier = 10});
  Random random(7);
  for (std::uint64_t k = 0; k < eyes; ++k) {
    const auto& v = model.soup.vertices;
    const glm::dvec3 eye = hard_eye(model.soup, random);
    const auto corner = static_cast<std::size_t>(random.below(static_cast<int>(v.size())));
    court.check(aimed(eye, v[corner], 1.5), name + " eye " + std::to_string(k));
  }
}

TEST(StressEyes, InRooms) { in_model("rooms", 0, times(50)); }
TEST(StressEyes, InTurnedRooms) { in_model("rooms", 31, times(50)); }
TEST(StressEyes, InTheMaze) { in_model("maze", 0, times(50)); }
TEST(StressEyes, InTheCity) { in_model("city", 0, times(100)); }
TEST(StressEyes, InATurnedCity) { in_model("city", 31, times(20)); }
TEST(StressEyes, InTheBuilding) { in_model("building", 0, times(20)); }

}  // namespace
}  // namespace sightline::stress
