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

namespace {

double exact_product(double a, double b) {
  const double p = a * b;
  if (!std::isfinite(p) || std::fma(a, b, -p) != 0)
    throw std::invalid_argument("a part of the window that is no double");
  return p;
}
/// (What Knuth's sum leaves is the error, exactly.)
double exact_sum(double a, double b) {
  const double s = a + b, t = s - a;
  if (!std::isfinite(s) || (a - (s - t)) + (b - t) != 0) {
    throw std::invalid_argument("a part of the window that is no double");
  }
  return s;
}

}  // namespace

Camera crop(const Camera& camera, const glm::dvec2& low, const glm::dvec2& high) {
  if (!(low.x < high.x && low.y < high.y)) throw std::invalid_argument("an empty part of the window");
  Camera part{camera.eye, camera.forward, camera.right, camera.up};
  const double width = exact_sum(high.x, -low.x), height = exact_sum(high.y, -low.y);
  const double s = exact_sum(exact_sum(low.x, high.x) / 2, -0.5), t = exact_sum(exact_sum(low.y, high.y) / 2, -0.5);
  for (int k = 0; k < 3; ++k) {
    const double aside = exact_sum(exact_product(s, camera.right[k]), exact_product(t, camera.up[k]));
    part.forward[k] = exact_sum(camera.forward[k], aside);
    part.right[k] = exact_product(width, camera.right[k]);
    part.up[k] = exact_product(height, camera.up[k]);
  }
  return part;
}

}  // namespace sightline
