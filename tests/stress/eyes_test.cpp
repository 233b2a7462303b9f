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

/// Half of the eyes are the model's own, moved into planes that its vertices share: they see more.
void in_model(const std::string& name, const ModelOptions& options, std::uint64_t eyes) {
  const Model model = make_model(name, options);
  Court court(model.soup, {}, {.oracle = false, .verifier = 10});
  Random random(7);
  const auto vertex = [&] {
    return model.soup.vertices[static_cast<std::size_t>(random.below(static_cast<int>(model.soup.vertices.size())))];
  };
  for (std::uint64_t k = 0; k < eyes; ++k) {
    const std::string what = name + " eye " + std::to_string(k);
    if (k % 2 == 0) {
      const glm::dvec3 eye = hard_eye(model.soup, random);
      court.check(aimed(eye, vertex(), 1.5), what);
      continue;
    }
    const CameraLine& c = model.cameras[k / 2 % model.cameras.size()];
    glm::dvec3 eye = c.eye;
    const int axis = random.below(3);
    eye[axis] = stepped(vertex()[axis], random.between(-1, 1));
    if (random.once_in(2)) eye[(axis + 1) % 3] = vertex()[(axis + 1) % 3];
    court.check(make_camera(eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect), what);
  }
}

TEST(StressEyes, InRooms) { in_model("rooms", {}, times(40)); }
TEST(StressEyes, InTurnedRooms) { in_model("rooms", {.rotate_degrees = 31}, times(40)); }
TEST(StressEyes, InTheMaze) { in_model("maze", {}, times(40)); }
TEST(StressEyes, InTheCity) { in_model("city", {}, times(60)); }
TEST(StressEyes, InATurnedCity) { in_model("city", {.polygons = 150, .rotate_degrees = 31}, times(20)); }
TEST(StressEyes, InTheBuilding) { in_model("building", {}, times(20)); }
TEST(StressEyes, AmongRandomPolygons) { in_model("random", {.polygons = 150}, times(40)); }

}  // namespace
}  // namespace sightline::stress
