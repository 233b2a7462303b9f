// Is the camera of a map the one that was asked for?
#include "verify/map_file.hpp"
#include "verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline::verify {

namespace {

using Vector = std::array<double, 3>;

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }
double largest(const Vector& a) { return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector scaled(const Vector& a, double k) { return {a[0] * k, a[1] * k, a[2] * k}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Every component is a multiple of 2^-26 of the power of two above the largest.
bool has_26_bits(const Vector& a) {
  int exponent = 0;
  std::frexp(largest(a), &exponent);
  for (const double x : a) {
    const double units = std::ldexp(x, 26 - exponent);
    if (units != std::floor(units)) return false;
  }
  return true;
}

}  // namespace

std::vector<CameraLine> read_cameras(const std::string& file) {
  const std::string content = load_file(file);
  std::vector<CameraLine> cameras;
  Text text(file, content);
  for (; text.more(); text.next_line()) {
    CameraLine camera;
    for (auto* vector : {&camera.eye, &camera.forward, &camera.up}) {
      for (double& x : *vector) x = text.number("a number of the camera");
    }
    camera.fov_degrees = text.number("the field of view");
    camera.aspect = text.number("the aspect");
    if (text.more_on_line()) text.fail("more than 11 numbers");
    const Vector side = cross(camera.forward, camera.up);
    if (!(length(side) > 0)) text.fail("up is along forward");
    if (!(camera.fov_degrees > 0 && camera.fov_degrees < 180)) text.fail("the field of view is not between 0 and 180");
    if (!(camera.aspect > 0)) text.fail("the aspect is not positive");
    cameras.push_back(camera);
  }
  return cameras;
}

void check_camera(const MapFile& map, const CameraLine& line, Report& report) {
  if (map.eye != line.eye) report.fault("camera", "eye", "is not the one asked for");
  const Vector forward = scaled(line.forward, 1 / length(line.forward));
  Vector right = cross(forward, line.up);
  right = scaled(right, 1 / length(right));
  const Vector up = cross(right, forward);
  const double half = 2 * std::tan(line.fov_degrees * std::numbers::pi / 360);
  const double factor = dot(map.forward, forward);  // the map's vectors may all be longer or shorter
  if (!(factor > 0)) return report.fault("camera", "forward", "is not the one asked for");
  const auto check = [&](const char* name, const Vector& has, const Vector& unit, double size) {
    const Vector wanted = scaled(unit, size * factor);
    Vector off{};
    for (std::size_t i = 0; i < 3; ++i) off[i] = has[i] - wanted[i];
    // Rounding to 26 bits moves a component by 2^-26 of the largest at most; twice that leaves room for the
    // rounding of the other steps.
    if (!(length(off) <= 0x1p-24 * length(wanted))) report.fault("camera", name, "is not the one asked for");
    if (!has_26_bits(has)) report.fault("camera", name, "has more than 26 significant bits");
  };
  check("forward", map.forward, forward, 1);
  check("right", map.right, right, half * line.aspect);
  check("up", map.up, up, half);
}

}  // namespace sightline::verify
