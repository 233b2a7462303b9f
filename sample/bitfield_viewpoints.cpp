#include "sample/bitfield_viewpoints.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

namespace sightline {
namespace {

struct Ball {
  glm::dvec3 centre{0};
  double radius = 0;
  int exponent = 0;  // places are multiples of 2^exponent
};

glm::dvec3 rounded(const glm::dvec3& p, int exponent) {
  const auto round = [&](double x) { return std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent); };
  return {round(p.x), round(p.y), round(p.z)};
}

/// Of the polygons that have an area, wherever a snap has moved them.
Ball bounding_ball(const Scene& scene) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  PolygonId last = none;
  for (const Surface& s : scene.surfaces()) {
    if (s.polygon == last) continue;
    last = s.polygon;
    for (const std::uint32_t v : scene.corners(s.polygon)) {
      low = glm::min(low, scene.soup().vertices[v]);
      high = glm::max(high, scene.soup().vertices[v]);
    }
  }
  Ball ball;
  if (last == none) return ball;
  ball.radius = glm::length(high / 2.0 - low / 2.0);
  if (!scene.options().snap.empty()) ball.radius += 2 * scene.grid().step();
  std::frexp(ball.radius, &ball.exponent);
  ball.exponent -= 21;
  ball.centre = rounded(low / 2.0 + high / 2.0, ball.exponent);
  return ball;
}

std::vector<glm::dvec3> spread(unsigned count) {
  std::vector<glm::dvec3> out;
  if (count == 6 || count == 14) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double way : {1.0, -1.0}) {
        glm::dvec3 d(0);
        d[axis] = way;
        out.push_back(d);
      }
    }
    for (int k = 0; count == 14 && k < 8; ++k) {
      out.push_back(glm::dvec3((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1) / std::sqrt(3.0));
    }
    return out;
  }
  // Slices of equal height have equal shares of the sphere; the golden angle keeps neighbours of all slices apart.
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (unsigned k = 0; k < count; ++k) {
    const double z = 1 - (2.0 * k + 1) / count, r = std::sqrt(1 - z * z);
    out.emplace_back(r * std::cos(golden * k), r * std::sin(golden * k), z);
  }
  return out;
}

}  // namespace

glm::dvec3 viewing_centre(const Scene& scene) { return bounding_ball(scene).centre; }

std::vector<CameraLine> sphere_cameras(const Scene& scene, unsigned count, double fov_degrees) {
  if (count < least_viewpoints || count > most_viewpoints) {
    throw std::invalid_argument("a number of viewpoints that is not from 4 to 16384");
  }
  if (!(fov_degrees >= 1 && fov_degrees <= 150))
    throw std::invalid_argument("an angle that is not from 1 to 150 degrees");
  const Ball ball = bounding_ball(scene);
  const double radius = ball.radius > 0 ? ball.radius : 1;
  // The ball touches the sides of a window at this distance; a hundredth more is more than all rounding.
  const double distance = 1.01 * radius / std::sin(fov_degrees * (std::numbers::pi / 360));
  if (!(radius > 1e-280) || !(distance < 1e280)) throw std::invalid_argument("a scene too small or too large");
  std::vector<CameraLine> cameras;
  for (const glm::dvec3& d : spread(count)) {
    const glm::dvec3 eye = rounded(ball.centre + distance * d, ball.exponent);
    const glm::dvec3 forward = ball.centre - eye;
    const bool upright = std::abs(d.z) < 0.99;
    cameras.push_back({eye, forward, upright ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), fov_degrees, 1});
  }
  return cameras;
}

}  // namespace sightline
