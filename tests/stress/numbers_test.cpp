// The same scene in other numbers: scaled, moved, turned, and windows of extreme widths.
#include <gtest/gtest.h>

#include <cmath>

#include "models/model.hpp"
#include "tests/stress/drawing.hpp"
#include "tests/stress/figures.hpp"
#include "tests/stress/judge.hpp"
#include "visibility_map/write.hpp"

namespace sightline::stress {
namespace {

/// A degenerate scene in whole numbers or eighths, which can be scaled by 1e12 and moved by 1e9 without rounding.
Case lattice_case(std::uint64_t& seed) {
  for (;; ++seed) {
    Case sample = testing::make_case(seed, 5);
    const auto coarse = [](const glm::dvec3& v) {
      return v.x * 8 == std::floor(v.x * 8) && v.y * 8 == std::floor(v.y * 8) && v.z * 8 == std::floor(v.z * 8);
    };
    if (std::ranges::all_of(sample.soup.vertices, coarse) && coarse(sample.camera.eye)) {
      ++seed;
      return sample;
    }
  }
}

std::string text(VisibilityMap map, const Camera& camera, const Scene& scene) {
  map.camera = camera;
  return map_json(map, scene);
}

// Powers of two change nothing at all.
TEST(StressNumbers, ScaledByPowersOfTwo) {
  for (std::uint64_t seed = 0; seed < times(30); ++seed) {
    const Case sample = testing::make_case(seed, 6);
    const std::string name = "seed " + std::to_string(seed);
    Court court(sample.soup, sample.options);
    const std::string expected = text(court.check(sample.camera, name), sample.camera, court.scene());
    for (const int exponent : {-900, -40, 1, 40, 900}) {
      const auto scale = [&](const glm::dvec3& v) { return v * std::ldexp(1, exponent); };
      Court other(placed(sample.soup, scale), sample.options, {.oracle = false});
      Camera camera = sample.camera;
      camera.eye = scale(camera.eye);
      for (glm::dvec3* v : {&camera.forward, &camera.right, &camera.up}) *v *= std::ldexp(1, exponent / 3);
      const VisibilityMap& map = other.check(camera, name + " times 2^" + std::to_string(exponent));
      if (text(map, sample.camera, other.scene()) != expected) other.fault("scaling by a power of two changed the map");
    }
  }
}

// Where no coordinate is rounded, the drawing stays the same.
TEST(StressNumbers, ScaledAndMovedWithoutRounding) {
  std::uint64_t seed = 0;
  for (std::uint64_t k = 0; k < times(40); ++k) {
    const Case sample = lattice_case(seed);
    const std::string name = "seed " + std::to_string(seed - 1);
    Court court(sample.soup, sample.options);
    const Drawing expected = drawing(court.scene(), court.check(sample.camera, name));
    for (const double scale : {1.0, 1e3, 1e12}) {
      const glm::dvec3 shift = scale == 1e12 ? glm::dvec3{0, 0, 0} : glm::dvec3{1e9, -1e9, 3e9};
      const auto image = [&](const glm::dvec3& v) { return v * scale + shift; };
      Court other(placed(sample.soup, image), sample.options, {.oracle = k % 4 == 0});
      Camera camera = sample.camera;
      camera.eye = image(camera.eye);
      const VisibilityMap& map = other.check(camera, name + " scaled or moved");
      const std::string different = difference(expected, drawing(other.scene(), map));
      if (!different.empty()) other.fault("scaling or moving changed the map\n" + different);
    }
  }
}

// Where coordinates are rounded it is another scene, all but degenerate wherever the first was: its map must be right.
TEST(StressNumbers, ScaledMovedAndTurnedWithRounding) {
  for (std::uint64_t seed = 0; seed < times(40); ++seed) {
    const Case sample = testing::make_case(seed, 5);
    Random random(seed);
    const Turn turn = some_turn(random);
    const auto judge = [&](const char* how, const auto& image, const auto& direction) {
      Case other = sample;
      other.soup = placed(sample.soup, image);
      other.camera = {image(sample.camera.eye), direction(sample.camera.forward), direction(sample.camera.right),
                      direction(sample.camera.up)};
      check(other, "seed " + std::to_string(seed) + " " + how);
    };
    const auto same = [](const glm::dvec3& v) { return v; };
    judge(
        "times 1e-12", [](const glm::dvec3& v) { return v * 1e-12; }, same);
    judge(
        "times 1e12 / 3", [](const glm::dvec3& v) { return v * (1e12 / 3); }, same);
    judge(
        "moved by 1e9",
        [](const glm::dvec3& v) {
          return v / 3.0 + glm::dvec3{1e9, -1e9, 1e9 / 7};
        },
        same);
    judge("turned", turn, turn);
  }
}

void in_windows(const Model& model, std::uint64_t count) {
  Court court(model.soup, {}, {.oracle = false});
  Random random(3);
  for (std::uint64_t k = 0; k < count; ++k) {
    const CameraLine& c = model.cameras[k % model.cameras.size()];
    const auto vertex = static_cast<std::size_t>(random.below(static_cast<int>(model.soup.vertices.size())));
    for (const double degrees : {1e-9, 1e-4, 179.0}) {
      // The narrow ones at a vertex, else they see nothing but the middle of a wall.
      const glm::dvec3 forward = model.soup.vertices[vertex] - c.eye;
      if (glm::length(glm::cross(forward, c.up)) < 1e-3 * glm::length(forward)) continue;
      court.check(make_camera(c.eye, forward, c.up, degrees, 1.5),
                  "camera " + std::to_string(k) + " of " + std::to_string(degrees) + " degrees");
    }
  }
}

TEST(StressNumbers, NarrowAndWideWindows) { in_windows(make_model("rooms"), times(20)); }
TEST(StressNumbers, NarrowAndWideWindowsTurned) { in_windows(make_model("rooms", {.rotate_degrees = 31}), times(8)); }

}  // namespace
}  // namespace sightline::stress
