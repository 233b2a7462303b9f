// Scenes for the tests of bitfields.
#pragma once

#include "models/model.hpp"
#include "scene/scene.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace sightline::testing {

/// A ball of triangles, `rings` from pole to pole, pushed in and out so that parts of it hide others; coordinates are
/// multiples of 2^-10.
inline PolygonSoup bumpy_ball(unsigned rings, double depth = 0.3) {
  PolygonSoup soup;
  soup.source = "ball.obj";
  const unsigned around = 2 * rings;
  const auto add = [&](double polar, double turn) {
    const double r = 1 + depth * std::sin(5 * polar) * std::cos(4 * turn);
    const auto round = [](double x) { return std::nearbyint(x * 1024) / 1024; };
    soup.vertices.emplace_back(round(r * std::sin(polar) * std::cos(turn)), round(r * std::sin(polar) * std::sin(turn)),
                               round(r * std::cos(polar)));
  };
  add(0, 0);
  for (unsigned k = 1; k < rings; ++k) {
    for (unsigned j = 0; j < around; ++j) add(std::numbers::pi * k / rings, 2 * std::numbers::pi * j / around);
  }
  add(std::numbers::pi, 0);
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup.corners.insert(soup.corners.end(), {a, b, c});
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  const auto last = static_cast<std::uint32_t>(soup.vertices.size() - 1);
  const auto at = [&](unsigned ring, unsigned j) { return 1 + (ring - 1) * around + j % around; };
  for (unsigned j = 0; j < around; ++j) {
    triangle(0, at(1, j), at(1, j + 1));
    for (unsigned k = 1; k + 1 < rings; ++k) {
      triangle(at(k, j), at(k + 1, j), at(k + 1, j + 1));
      triangle(at(k, j), at(k + 1, j + 1), at(k, j + 1));
    }
    triangle(at(rings - 1, j), last, at(rings - 1, j + 1));
  }
  return soup;
}

inline Scene small_model(const std::string& name, std::uint32_t polygons = 0) {
  ModelOptions options;
  options.polygons = polygons;
  return make_scene(make_model(name, options).soup);
}

inline Camera camera_of(const CameraLine& c) {
  return make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect);
}
inline std::vector<Camera> cameras_of(std::span<const CameraLine> lines) {
  std::vector<Camera> out;
  for (const CameraLine& c : lines) out.push_back(camera_of(c));
  return out;
}

/// Is every bit of a set in b?
template <class Field>
bool within(const Field& a, const Field& b) {
  Field both = b;
  both.join(a);
  return both == b;
}

}  // namespace sightline::testing
