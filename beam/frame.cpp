#include "beam/frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sightline {

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

/// A corner is at most 2 and within 2^-49 by component; so are its products with the axes, all but 2^-48: each quotient
/// p / z is within (1 + |p / z|) 2^-47 / z. Rounding to floats and of the quotient: 2^-22 of it.
FrameBox Frame::bounds(const glm::dvec3& corner) const {
  constexpr double doubt = 0x1p-46;
  const double z = glm::dot(z_, corner);
  if (z <= 4 * doubt) return FrameBox::everything();
  const double part = 1 / z, x = glm::dot(x_, corner) * part, y = glm::dot(y_, corner) * part;
  const double size_x = std::abs(x), size_y = std::abs(y);
  const double off_x = 2 * doubt * part * (1 + size_x) + 0x1p-22 * size_x;
  const double off_y = 2 * doubt * part * (1 + size_y) + 0x1p-22 * size_y;
  return {{static_cast<float>(x - off_x), static_cast<float>(y - off_y), static_cast<float>(-x - off_x),
           static_cast<float>(-y - off_y)}};
}

namespace {

/// For products with the axes that are within `doubt`.
void place_within(const glm::dvec3& p, double doubt, glm::dvec2& at, double& error) {
  const double part = 1 / p.z;
  at = {p.x * part, p.y * part};
  error = 2 * doubt * part * (1 + std::max(std::abs(at.x), std::abs(at.y)));
}

}  // namespace

/// As in `bounds`, without the rounding to floats.
bool Frame::place_corner(const glm::dvec3& corner, glm::dvec2& at, double& error) const {
  constexpr double doubt = 0x1p-46;
  const double z = glm::dot(z_, corner);
  if (!(z > 4 * doubt)) return false;
  place_within({glm::dot(x_, corner), glm::dot(y_, corner), z}, doubt, at, error);
  return true;
}

/// The axes are what they are as doubles; products with a direction are within `doubt_`, those with a corner within
/// less.
bool Frame::place(const glm::dvec3& ray, glm::dvec2& at, double& error) const {
  const double z = glm::dot(z_, ray);
  if (!(z > 0x1p20 * doubt_)) return false;
  place_within({glm::dot(x_, ray), glm::dot(y_, ray), z}, doubt_, at, error);
  return true;
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
