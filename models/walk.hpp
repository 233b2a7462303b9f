// Camera paths.
#pragma once

#include "scene/read.hpp"

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sightline::models {

struct Waypoint {
  glm::dvec3 at;     // metres
  double pitch = 0;  // upward slope of the view there; in between it changes linearly
};

struct WalkStyle {
  double corner = 1;             // corners are rounded from this distance before to this distance after them, in metres
  double behind = 1, ahead = 1;  // the view goes along the line between the points of the path that far away, in metres
  double yaw = 0.3;              // the view swings to both sides of the path; tangent of half the largest angle
  double yaw_waves = 9;          // how often it does on the whole way
  double pitch = 0.08;           // and up and down: largest slope added
};

inline constexpr double camera_fov_degrees = 60;
inline constexpr double camera_aspect = 4.0 / 3.0;

/// `count` cameras at equal distances along the way, looking along it. Every eye lies in the hull of some corner's two
/// rounded sides or on a segment between, to 1/128: it is in free space if the way is, a corner's hull included.
/// Needs two different waypoints at least. Nothing here depends on the mathematical library but square roots, which
/// are exactly rounded everywhere.
std::vector<CameraLine> walk(std::span<const Waypoint> way, int count, const WalkStyle& style = {});

/// A camera that looks at a point; eye and direction are rounded as those of a walk.
CameraLine look_at(const glm::dvec3& eye, const glm::dvec3& target);

}  // namespace sightline::models
