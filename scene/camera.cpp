#include "scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

namespace sightline {
namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// v at length 1. It is scaled by a power of two first, so that no square over- or underflows.
glm::dvec3 direction(const glm::dvec3& v, const char* name) {
  if (!finite(v)) throw std::invalid_argument(std::string(name) + " is not finite");
  if (largest(v) == 0) throw std::invalid_argument(std::string(name) + " is zero");
  int exponent = 0;
  std::frexp(largest(v), &exponent);
  return glm::normalize(glm::dvec3{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)});
}

/// Every component to the nearest multiple of 2^(e-26), ties to even, where 2^e is the power of two just above the
/// largest component.
glm::dvec3 short_vector(const glm::dvec3& v) {
  constexpr int bits = 26;
  if (!finite(v) || largest(v) < 1e-290 || largest(v) > 1e290) {
    throw std::invalid_argument("angle or aspect is beyond what can be drawn");
  }
  int exponent = 0;
  std::frexp(largest(v), &exponent);
  const auto round = [&](double x) {
    return std::ldexp(std::nearbyint(std::ldexp(x, bits - exponent)), exponent - bits);
  };
  return {round(v.x), round(v.y), round(v.z)};
}

}  // namespace

Camera make_camera(const glm::dvec3& eye, const glm::dvec3& forward, const glm::dvec3& up, double vertical_fov_degrees,
                   double aspect) {
  if (!finite(eye)) throw std::invalid_argument("eye is not finite");
  const glm::dvec3 ahead = direction(forward, "forward");
  const glm::dvec3 hint = direction(up, "up");
  if (!(vertical_fov_degrees > 0 && vertical_fov_degrees < 180)) {
    throw std::invalid_argument("angle is not between 0 and 180 degrees");
  }
  if (!(aspect > 0 && std::isfinite(aspect))) throw std::invalid_argument("aspect is not positive");
  const glm::dvec3 across = glm::cross(ahead, hint);
  // Both have length 1: below this the cross product is mostly rounding error.
  if (largest(across) < 0x1p-40) throw std::invalid_argument("up points along forward");
  const glm::dvec3 right = glm::normalize(across);
  const glm::dvec3 upright = glm::cross(right, ahead);
  const double height = 2 * std::tan(vertical_fov_degrees * (std::numbers::pi / 360));
  return {eye, short_vector(ahead), short_vector(right * (height * aspect)), short_vector(upright * height)};
}

}  // namespace sightline
