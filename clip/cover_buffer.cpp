#include "clip/cover_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "exact/predicates.hpp"

namespace sightline {
namespace {

constexpr double u = 0x1p-53;  // unit roundoff
constexpr int block = 16;      // rows that are passed over together

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Cuts [first, last) down to the integers x with a + b x >= 0, as this sum is rounded: it rises or falls with x.
void keep(double a, double b, int& first, int& last) {
  const auto inside = [&](int x) { return a + b * x >= 0; };
  if (first >= last) return;
  const bool at_first = inside(first), at_last = inside(last - 1);
  if (at_first && at_last) return;
  if (!at_first && !at_last) {
    last = first;
    return;
  }
  int x = static_cast<int>(std::clamp(-a / b, static_cast<double>(first), static_cast<double>(last - 1)));
  if (at_last) {
    while (x > first && inside(x - 1)) --x;
    while (!inside(x)) ++x;
    first = x;
  } else {
    while (x + 1 < last && inside(x + 1)) ++x;
    while (!inside(x)) --x;
    last = x + 1;
  }
}

}  // namespace

int chosen_size(std::size_t surfaces, std::size_t cameras) {
  const double wanted = 8 * std::sqrt(static_cast<double>(surfaces));
  const double most = std::sqrt(0x1p28 / sizeof(float) / static_cast<double>(cameras));
  int size = 64;
  while (size < wanted && 2 * size <= most && size < 512) size *= 2;
  return size;
}

CoverBuffer::CoverBuffer(const Scene& scene, const Camera& camera, std::span<const SurfaceId> surfaces, int size)
    : scene_(scene), size_(size), nearest_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0f) {
  eye_ = scene.grid().unit(camera.eye);
  reach_ = largest(eye_);
  int exponent = 0;
  std::frexp(std::max({largest(camera.forward), largest(camera.right), largest(camera.up)}), &exponent);
  const auto scaled = [&](const glm::dvec3& v) {
    return glm::dvec3{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
  };
  right_ = scaled(camera.right);
  up_ = scaled(camera.up);
  corner_ = scaled(camera.forward) - 0.5 * right_ - 0.5 * up_;
  if (!(reach_ < 0x1p100)) return;  // nothing is proven from there

  std::vector<glm::dvec3> corners;
  std::vector<Linear> sides;
  for (const SurfaceId id : surfaces) {
    const Surface& s = scene.surfaces()[id];
    corners.clear();
    for (const SurfaceEdge& e : scene.edges(s)) {
      if (e.corner == none) break;
      corners.push_back(scene.points().approx(e.corner));
    }
    if (corners.size() < s.edge_count) continue;
    const ApproxPlane& p = scene.planes().approx(s.plane);
    const bool front = p.n[0] * eye_.x + p.n[1] * eye_.y + p.n[2] * eye_.z > p.d;
    if (scene.options().one_sided && front == s.flipped) continue;
    cover(corners, s.plane, sides);
  }
}

// n.ray over the pixels; ray = corner_ + x / size right_ + y / size up_.
CoverBuffer::Linear CoverBuffer::over_pixels(const glm::dvec3& normal) const {
  return {glm::dot(normal, corner_), glm::dot(normal, right_) / size_, glm::dot(normal, up_) / size_};
}

// A ray meets the plane n.x = d at the depth (d - n.e) / n.ray. With E the reach of the eye, d - n.e is off by less
// than q = u (24 E + 4 |d| + 2), as in SightlineTable::eye_side. Components of rays are below 4 (three vectors, each up
// to 1, the outer two at most once), known within 4u: n.ray is off by less than 3 (4u + 4u), with the roundings of
// three products and their sums, and of the evaluation, of numbers up to 12 each: below 256u in all; itself it is
// below 12. Divided by D = |d - n.e|, where q/D < 2^-20: off by less than (256u + 12 (1.01 q/D + 2u)) / D.
bool CoverBuffer::inverse_depth(PlaneId plane, Linear& w, double& error) const {
  const ApproxPlane& p = scene_.planes().approx(plane);
  const glm::dvec3 n(p.n[0], p.n[1], p.n[2]);
  const double distance = p.d - glm::dot(n, eye_), doubt = u * (24 * reach_ + 4 * std::abs(p.d) + 2);
  const double size = std::abs(distance);
  if (!(doubt < 0x1p-20 * size)) return false;
  w = over_pixels(n);
  w = {w.c / distance, w.x / distance, w.y / distance};
  error = (300 * u + 16 * doubt / size) / size;
  return true;
}

// The plane of the eye and two corners p, q has the normal (p - e) x (q - e). Corners are within 2^-46; with Q = E + 1
// the differences are below Q and off by less than h = 2^-45 + 2^-51 Q. A component of the normal, two products: off by
// less than 4Qh + 4uQQ < 5Qh, and below 2QQ. Its product with a ray (components below 4, off by 4u): 3 (4 5Qh + 2QQ 4u)
// and roundings of terms up to 8QQ, nine of them and the evaluation, 4u each: below 60Qh + 6Qh + 300uQQ < 150Qh, since
// uQ < h/4.
void CoverBuffer::cone(std::span<const glm::dvec3> corners, double turn, std::vector<Linear>& sides,
                       double& error) const {
  sides.clear();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3 p = corners[k] - eye_, q = corners[k + 1 == corners.size() ? 0 : k + 1] - eye_;
    sides.push_back(over_pixels(turn * glm::cross(p, q)));
  }
  const double far = reach_ + 1;
  error = 160 * far * (0x1p-45 + 0x1p-51 * far);
}

// A pixel is covered where all sides of the cone are positive at its four corners: each side is least at one of them.
void CoverBuffer::cover(std::span<const glm::dvec3> corners, PlaneId plane, std::vector<Linear>& sides) {
  Linear w;
  double depth_error, side_error;
  if (!inverse_depth(plane, w, depth_error)) return;
  const ApproxPlane& p = scene_.planes().approx(plane);
  // Seen from the front they run counter-clockwise, and (a - eye) x (b - eye) points outwards.
  const bool front = p.n[0] * eye_.x + p.n[1] * eye_.y + p.n[2] * eye_.z > p.d;
  cone(corners, front ? -1 : 1, sides, side_error);
  const double w_least = w.c + std::min(w.x, 0.0) + std::min(w.y, 0.0) - depth_error;
  const auto range = [&](int y, int rows, int& first, int& last, bool any) {
    first = 0;
    last = size_;
    for (const Linear& side : sides) {
      const double worst = any ? std::max(side.x, 0.0) + std::max(side.y * y, side.y * (y + rows))
                               : std::min(side.x, 0.0) + std::min(side.y * y, side.y * (y + rows));
      keep(side.c + worst - side_error, side.x, first, last);
    }
  };
  int first, last;
  range(0, size_, first, last, true);
  if (first >= last) return;
  for (int from = 0; from < size_; from += block) {
    const int rows = std::min(block, size_ - from);
    range(from, rows, first, last, true);
    if (first >= last) continue;
    for (int y = from; y < from + rows; ++y) {
      range(y, 1, first, last, false);
      float* const row = nearest_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_);
      const double base = w_least + w.y * y;
      for (int x = first; x < last; ++x) {
        // Rounded to a float it grows by a factor of 1 + 2^-24 at most.
        const auto least = static_cast<float>((base + w.x * x) * (1 - 0x1p-22));
        row[x] = row[x] > least ? row[x] : least;
      }
    }
  }
}

bool CoverBuffer::hides(std::span<const glm::dvec3> corners, PlaneId plane, bool backwards) const {
  Linear w;
  double depth_error, side_error;
  if (!(reach_ < 0x1p100) || !inverse_depth(plane, w, depth_error)) return false;
  const ApproxPlane& p = scene_.planes().approx(plane);
  const bool front = p.n[0] * eye_.x + p.n[1] * eye_.y + p.n[2] * eye_.z > p.d;
  thread_local std::vector<Linear> sides;
  cone(corners, front == backwards ? 1 : -1, sides, side_error);
  const double w_most = w.c + std::max(w.x, 0.0) + std::max(w.y, 0.0) + depth_error;
  // A pixel may be touched where every side is positive at one of its corners at least.
  const auto range = [&](int y, int rows, int& first, int& last) {
    first = 0;
    last = size_;
    for (const Linear& side : sides) {
      const double most = std::max(side.x, 0.0) + std::max(side.y * y, side.y * (y + rows));
      keep(side.c + most + side_error, side.x, first, last);
    }
  };
  int first, last;
  range(0, size_, first, last);
  if (first >= last) return true;
  for (int from = 0; from < size_; from += block) {
    const int rows = std::min(block, size_ - from);
    range(from, rows, first, last);
    if (first >= last) continue;
    for (int y = from; y < from + rows; ++y) {
      range(y, 1, first, last);
      const float* const row = nearest_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_);
      const double base = w_most + w.y * y;
      int open = 0;
      for (int x = first; x < last; ++x) open |= !(base + w.x * x < static_cast<double>(row[x]));
      if (open) return false;
    }
  }
  return true;
}

}  // namespace sightline
