#include "models/walk.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::models {
namespace {

double length(const glm::dvec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

glm::dvec3 rounded(const glm::dvec3& v, double per_unit) {
  return {std::round(v.x * per_unit) / per_unit, std::round(v.y * per_unit) / per_unit,
          std::round(v.z * per_unit) / per_unit};
}

CameraLine camera(const glm::dvec3& eye, const glm::dvec3& direction) {
  const double size = length(direction);
  const glm::dvec3 unit(direction.x / size, direction.y / size, direction.z / size);
  return {rounded(eye, 64), rounded(unit, 1 << 20), {0, 0, 1}, camera_fov_degrees, camera_aspect};
}

/// Like a sine of period 1, of parabolas.
double wave(double u) {
  const double v = u - std::floor(u);
  return v < 0.5 ? 16 * v * (0.5 - v) : -16 * (v - 0.5) * (1 - v);
}

/// A polyline with its length up to each point.
struct Path {
  std::vector<Waypoint> points;
  std::vector<double> travelled;

  void add(const Waypoint& w) {
    if (points.empty()) {
      travelled.push_back(0);
    } else {
      const double step = length(w.at - points.back().at);
      if (step == 0) return;
      travelled.push_back(travelled.back() + step);
    }
    points.push_back(w);
  }

  Waypoint at(double s) const {
    const auto after = std::upper_bound(travelled.begin() + 1, travelled.end() - 1, s);
    const auto i = static_cast<std::size_t>(after - travelled.begin());
    const double t = std::clamp((s - travelled[i - 1]) / (travelled[i] - travelled[i - 1]), 0.0, 1.0);
    const Waypoint &a = points[i - 1], &b = points[i];
    return {a.at + (b.at - a.at) * t, a.pitch + (b.pitch - a.pitch) * t};
  }
};

/// Each corner becomes a parabola between points on its two sides.
Path rounded_path(std::span<const Waypoint> way, double corner) {
  Path path;
  path.add(way.front());
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const glm::dvec3 before = way[i - 1].at - way[i].at, after = way[i + 1].at - way[i].at;
    const double before_length = length(before), after_length = length(after);
    if (before_length == 0 || after_length == 0) continue;
    const glm::dvec3 from = way[i].at + before * std::min(corner / before_length, 0.5);
    const glm::dvec3 to = way[i].at + after * std::min(corner / after_length, 0.5);
    constexpr int steps = 8;
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      path.add({from * ((1 - t) * (1 - t)) + way[i].at * (2 * t * (1 - t)) + to * (t * t), way[i].pitch});
    }
  }
  path.add(way.back());
  return path;
}

}  // namespace

std::vector<CameraLine> walk(std::span<const Waypoint> way, int count, const WalkStyle& style) {
  const Path path = rounded_path(way, style.corner);
  const double total = path.travelled.back();
  std::vector<CameraLine> cameras;
  for (int k = 0; k < count; ++k) {
    const double u = (k + 0.5) / count;
    const Waypoint here = path.at(u * total);
    const glm::dvec3 tangent = path.at(u * total + style.ahead).at - path.at(u * total - style.behind).at;
    // A turn by twice the angle of tangent t, without sines.
    const double t = style.yaw * wave(style.yaw_waves * u);
    const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    const double level = std::sqrt(tangent.x * tangent.x + tangent.y * tangent.y);
    const double slope = here.pitch + style.pitch * wave(0.6 * style.yaw_waves * u);
    cameras.push_back(camera(here.at, {c * tangent.x - s * tangent.y, s * tangent.x + c * tangent.y, slope * level}));
  }
  return cameras;
}

CameraLine look_at(const glm::dvec3& eye, const glm::dvec3& target) { return camera(eye, target - eye); }

}  // namespace sightline::models
