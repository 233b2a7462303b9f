#include "beam/frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

/// Gathers quotients p / z; each within (doubt + |p / z| doubt) / z of the true one. Rounding to floats and of the
/// quotient: 2^-22 of it.
struct Gatherer {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, least_z = INFINITY;

  void add(double x, double y, double z) {
    const double s = x / z, t = y / z;
    low[0] = std::min(low[0], s);
    high[0] = std::max(high[0], s);
    low[1] = std::min(low[1], t);
    high[1] = std::max(high[1], t);
    least_z = std::min(least_z, z);
  }
  FrameBox box(double doubt) const {
    FrameBox b;
    for (int k = 0; k < 2; ++k) {
      const double size = std::max(std::abs(low[k]), std::abs(high[k]));
      const double off = 2 * (doubt + size * doubt) / least_z + 0x1p-22 * size;
      b.side[k] = static_cast<float>(low[k] - off);
      b.side[k + 2] = static_cast<float>(-high[k] - off);
    }
    return b;
  }
};

}  // namespace

void Frame::set(const glm::dvec3& eye, const glm::dvec3& ahead, double doubt) {
  eye_ = eye;
  doubt_ = doubt;
  z_ = glm::normalize(ahead);
  const glm::dvec3 a = glm::abs(z_);
  const glm::dvec3 other = a.x <= a.y && a.x <= a.z ? glm::dvec3{1, 0, 0} : a.y <= a.z ? glm::dvec3{0, 1, 0} : glm::dvec3{0, 0, 1};
  x_ = glm::normalize(glm::cross(z_, other));
  y_ = glm::cross(z_, x_);
}

/// Corners are products of lines' normals, components at most 2 and within 2^-49; so are their products with the axes,
/// all but 2^-48. A corner that is not clearly ahead is somewhere.
FrameBox Frame::bounds(std::span<const RegionSide> region) const {
  constexpr double doubt = 0x1p-46;
  Gatherer all;
  for (const RegionSide& side : region) {
    const double z = glm::dot(z_, side.corner);
    if (z <= 4 * doubt) return FrameBox::everything();
    all.add(glm::dot(x_, side.corner), glm::dot(y_, side.corner), z);
  }
  return all.box(doubt);
}

bool Frame::bounds(const TreeBox& box, FrameBox& out) const {
  const glm::dvec3 at = box.low - eye_, size = box.high - box.low;
  const double z0 = glm::dot(z_, at);
  const glm::dvec3 dz = z_ * size;
  const double least = z0 + std::min(dz.x, 0.0) + std::min(dz.y, 0.0) + std::min(dz.z, 0.0);
  const double most = z0 + std::max(dz.x, 0.0) + std::max(dz.y, 0.0) + std::max(dz.z, 0.0);
  if (most < -doubt_) return false;
  out = FrameBox::everything();
  if (least <= 4 * doubt_) return true;
  const double x0 = glm::dot(x_, at), y0 = glm::dot(y_, at);
  const glm::dvec3 dx = x_ * size, dy = y_ * size;
  Gatherer all;
  for (int corner = 0; corner < 8; ++corner) {
    const double i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    all.add(x0 + i * dx.x + j * dx.y + k * dx.z, y0 + i * dy.x + j * dy.y + k * dy.z,
            z0 + i * dz.x + j * dz.y + k * dz.z);
  }
  out = all.box(doubt_);
  return true;
}

}  // namespace sightline
