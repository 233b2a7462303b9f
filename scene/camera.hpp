// Cameras: exact from here on.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace sightline {

/// A perspective camera: the point (s,t) of the window [0,1]^2 is seen along forward + (s-1/2) right + (t-1/2) up.
/// All four vectors are taken exactly as the doubles they are; they must be finite and the three directions linearly
/// independent.
struct Camera {
  glm::dvec3 eye{0, 0, 0};
  glm::dvec3 forward{0, 1, 0};
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 up{0, 0, 1};
};

/// The camera of a line of a cameras file: looks along `forward`, `up` is a hint; each of the three vectors of the
/// result is rounded once to 26 significant bits of its largest component. Throws std::invalid_argument saying what is
/// wrong (vector zero or not finite, up along forward, angle not within (0, 180), aspect not positive).
Camera make_camera(const glm::dvec3& eye, const glm::dvec3& forward, const glm::dvec3& up, double vertical_fov_degrees,
                   double aspect);

/// The camera that has a part of another's window, from `low` to `high` in its (s,t), for its own; the part may reach
/// beyond the window. Not rounded: throws std::invalid_argument where the part is empty, or a sum is no double, which
/// it is for cameras of make_camera and parts in multiples of 2^-20.
Camera crop(const Camera& camera, const glm::dvec2& low, const glm::dvec2& high);

}  // namespace sightline
