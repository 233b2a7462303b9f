#include "scene/camera.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <limits>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace sightline::test {
namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// All components are multiples of 2^(e-26), 2^e just above the largest: at most 26 bits each.
bool is_short(const glm::dvec3& v) {
  int e = 0;
  std::frexp(largest(v), &e);
  for (int k = 0; k < 3; ++k) {
    const double scaled = std::ldexp(v[k], 26 - e);
    if (scaled != std::floor(scaled) || std::abs(scaled) > 0x1p26) return false;
  }
  return true;
}

double component(double limit) { return *rc::gen::inRange(-1000000, 1000001) * (limit / 1000000); }

RC_GTEST_PROP(MakeCamera, VectorsAreShortAndNearlyWhatWasAskedFor, ()) {
  const glm::dvec3 eye{component(1e6), component(1e6), component(1e6)};
  const glm::dvec3 forward{component(5), component(5), component(5)}, up{component(1), component(1), component(1)};
  RC_PRE(glm::length(glm::cross(forward, up)) > 1e-3 * glm::length(forward) * glm::length(up));
  const double angle = *rc::gen::inRange(1, 1790) / 10.0, aspect = *rc::gen::inRange(1, 400) / 100.0;
  const Camera c = make_camera(eye, forward, up, angle, aspect);
  RC_ASSERT(c.eye == eye);
  RC_ASSERT(is_short(c.forward) && is_short(c.right) && is_short(c.up));
  const double height = 2 * std::tan(angle * std::acos(-1.0) / 360);
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-7; };
  RC_ASSERT(near(glm::length(c.forward), 1));
  RC_ASSERT(near(glm::length(c.up) / height, 1));
  RC_ASSERT(near(glm::length(c.right) / (height * aspect), 1));
  RC_ASSERT(near(glm::dot(glm::normalize(c.right), c.forward), 0));
  RC_ASSERT(near(glm::dot(glm::normalize(c.up), c.forward), 0));
  RC_ASSERT(near(glm::dot(glm::normalize(c.up), glm::normalize(c.right)), 0));
  RC_ASSERT(glm::dot(c.up, up) > 0);
  RC_ASSERT(near(glm::dot(c.forward, glm::normalize(forward)), 1));
  RC_ASSERT(glm::dot(glm::cross(c.right, c.up), c.forward) < 0);  // right x up points backwards
}

TEST(MakeCamera, AlongTheAxesIsExact) {
  const Camera c = make_camera({0.1, 0.2, 0.3}, {0, 0, -7}, {0, 1e-5, 3}, 90, 2);
  EXPECT_EQ(c.eye, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(c.forward, glm::dvec3(0, 0, -1));
  EXPECT_EQ(c.right, glm::dvec3(4, 0, 0));
  EXPECT_EQ(c.up, glm::dvec3(0, 2, 0));
}

TEST(MakeCamera, LengthsOfDirectionsDoNotMatter) {
  const Camera c = make_camera({0, 0, 0}, {1, 2, 3}, {0, 0, 1}, 60, 1.5);
  for (const double scale : {0x1p1000, 0x1p-1000, 0x1p-1060}) {
    const Camera s = make_camera({0, 0, 0}, scale * glm::dvec3(1, 2, 3), {0, 0, scale}, 60, 1.5);
    EXPECT_EQ(s.forward, c.forward);
    EXPECT_EQ(s.right, c.right);
    EXPECT_EQ(s.up, c.up);
  }
}

TEST(MakeCamera, RefusesWhatIsNoCamera) {
  const double inf = INFINITY, nan = NAN;
  const auto make = [](glm::dvec3 eye, glm::dvec3 forward, glm::dvec3 up, double angle, double aspect) {
    return [=] { make_camera(eye, forward, up, angle, aspect); };
  };
  const glm::dvec3 o{0, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_NO_THROW(make(o, y, z, 60, 1)());
  EXPECT_THROW(make({nan, 0, 0}, y, z, 60, 1)(), std::invalid_argument);
  EXPECT_THROW(make(o, {0, inf, 0}, z, 60, 1)(), std::invalid_argument);
  EXPECT_THROW(make(o, o, z, 60, 1)(), std::invalid_argument);
  EXPECT_THROW(make(o, y, {0, 0, nan}, 60, 1)(), std::invalid_argument);
  EXPECT_THROW(make(o, y, o, 60, 1)(), std::invalid_argument);
  EXPECT_THROW(make(o, y, y, 60, 1)(), std::invalid_argument);
  EXPECT_THROW(make(o, {1, 2, 3}, {-0.1, -0.2, -0.3}, 60, 1)(), std::invalid_argument);
  for (const double angle : {0.0, -1.0, 180.0, nan, inf, 1e-300}) {
    EXPECT_THROW(make(o, y, z, angle, 1)(), std::invalid_argument) << angle;
  }
  for (const double aspect : {0.0, -1.0, nan, inf, 1e300, 1e-300}) {
    EXPECT_THROW(make(o, y, z, 60, aspect)(), std::invalid_argument) << aspect;
  }
}

TEST(Camera, APartOfTheWindowIsSeenAlongTheSameRays) {
  const Camera camera = make_camera({1, 2, 3}, {0.3, 1, -0.2}, {0, 0, 1}, 60, 1.5);
  const Camera part = crop(camera, {0.25, 0.5}, {0.625, 1.25});
  const auto ray = [](const Camera& c, double s, double t) {
    return c.forward + (s - 0.5) * c.right + (t - 0.5) * c.up;
  };
  EXPECT_EQ(part.eye, camera.eye);
  EXPECT_EQ(ray(part, 0, 0), ray(camera, 0.25, 0.5));
  EXPECT_EQ(ray(part, 1, 0), ray(camera, 0.625, 0.5));
  EXPECT_EQ(ray(part, 0, 1), ray(camera, 0.25, 1.25));
  const Camera whole = crop(camera, {0, 0}, {1, 1});
  EXPECT_EQ(whole.forward, camera.forward);
  EXPECT_EQ(whole.right, camera.right);
  EXPECT_EQ(whole.up, camera.up);
}

TEST(Camera, APartOfTheWindowIsNeverRounded) {
  const Camera camera = make_camera({1, 2, 3}, {0.3, 1, -0.2}, {0, 0, 1}, 60, 1.5);
  EXPECT_THROW(crop(camera, {0.1, 0}, {0.7, 1}), std::invalid_argument);
  EXPECT_THROW(crop(camera, {0.5, 0}, {0.5, 1}), std::invalid_argument);
  EXPECT_THROW(crop(camera, {0, 0}, {1, std::numeric_limits<double>::infinity()}), std::invalid_argument);
  EXPECT_THROW(crop(camera, {0, std::numeric_limits<double>::quiet_NaN()}, {1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::test
