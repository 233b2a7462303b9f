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
  const glm::dvec3 other = a.x <= a.y && a.x <= a.z ? glm::dvec3{1, 0, 0}
                           : a.y <= a.z             ? glm::dvec3{0, 1, 0}
                                                    : glm::dvec3{0, 0, 1};
  x_ = glm::normalize(glm::cross(z_, other));
  y_ = glm::cross(z_, x_);
  abs_x_ = glm::abs(x_);
  abs_y_ = glm::abs(y_);
  abs_z_ = glm::abs(z_);
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

/// From the ranges of the three coordinates, each by itself: a little wider than what is seen, and quick.
bool Frame::bounds(const TreeBox& box, FrameBox& out) const {
  const glm::dvec3 at = box.middle - eye_;
  const double z = glm::dot(z_, at), dz = glm::dot(abs_z_, box.half) + 2 * doubt_;
  if (z + dz < 0) return false;
  const double least = z - dz;
  if (!(least > 0)) {  // around the eye, or beyond what doubles hold
    out = FrameBox::everything();
    return true;
  }
  const double near = (1 + 0x1p-22) / least, far = (1 - 0x1p-22) / (z + dz);
  const double x = glm::dot(x_, at), dx = glm::dot(abs_x_, box.half) + 2 * doubt_;
  const double y = glm::dot(y_, at), dy = glm::dot(abs_y_, box.half) + 2 * doubt_;
  const auto low = [&](double v) { return static_cast<float>(v * (v < 0 ? near : far)); };
  out = {{low(x - dx), low(y - dy), low(-x - dx), low(-y - dy)}};
  return true;
}

}  // namespace sightline
