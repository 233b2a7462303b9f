#include "verify/window.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sightline::verify {

View::View(const Scene& scene, const std::array<double, 3>& eye, const std::array<double, 3>& forward,
           const std::array<double, 3>& right, const std::array<double, 3>& up)
    : scene_(scene) {
  unsigned eye_bits = 0;
  eye_ = scene.place(eye, eye_bits);
  const unsigned grid = std::max(scene.grid(), eye_bits);
  lift_ = grid - scene.grid();
  eye_ = shifted(eye_, grid - eye_bits);
  near_eye_ = {nearest_double(eye_.x, Integer(1) << grid), nearest_double(eye_.y, Integer(1) << grid),
               nearest_double(eye_.z, Integer(1) << grid)};

  unsigned bits = 0;
  for (const auto* v : {&forward, &right, &up}) {
    for (const double x : *v) bits = std::max(bits, fraction_bits(x));
  }
  const auto vector = [&](const std::array<double, 3>& v) {
    return Triple{scaled_integer(v[0], bits), scaled_integer(v[1], bits), scaled_integer(v[2], bits)};
  };
  const Triple f = vector(forward), r = vector(right), u = vector(up);
  right_ = r + r;
  up_ = u + u;
  corner_ = f + f - r - u;
  const long camera_bits = static_cast<long>(bits) - 1;  // right_ and the others are twice the camera's vectors

  // Cramer's rule for ray = X right + Y up + Z corner, times the absolute determinant.
  to_x_ = cross(up_, corner_);
  to_y_ = cross(corner_, right_);
  to_z_ = cross(right_, up_);
  Integer determinant = dot(to_x_, right_);
  if (determinant == 0) throw std::invalid_argument("forward, right and up are linearly dependent");
  if (determinant < 0) {
    determinant = -determinant;
    negate(to_x_);
    negate(to_y_);
    negate(to_z_);
  }
  const auto doubles = [&](const Triple& t) {
    return std::array<double, 3>{rough(t.x, -2 * camera_bits), rough(t.y, -2 * camera_bits),
                                 rough(t.z, -2 * camera_bits)};
  };
  near_x_ = doubles(to_x_);
  near_y_ = doubles(to_y_);
  near_z_ = doubles(to_z_);
  factor_ = rough(determinant, -3 * camera_bits);
  // A form has the camera's scale, a height the scene's: their ratio in the scale of factor_ / Near::z.
  depth_shift_ = static_cast<long>(grid) - camera_bits;

  border_ = {make_line({1, 0, 0}), make_line({-1, 0, 1}), make_line({0, 1, 0}), make_line({0, -1, 1})};
  square_.corners = {make_point({0, 0, 1}), make_point({1, 0, 1}), make_point({1, 1, 1}), make_point({0, 1, 1})};
  square_.sides = {&border_[2], &border_[1], &border_[3], &border_[0]};
}

Triple View::ray(const Corner& corner) const { return shifted(corner.p, lift_) - corner.w * eye_; }
Triple View::ray(std::uint32_t vertex) const { return shifted(scene_.point(vertex), lift_) - eye_; }
Triple View::line(const Triple& n) const { return {dot(n, right_), dot(n, up_), dot(n, corner_)}; }
Triple View::window(const Triple& q) const { return {dot(q, to_x_), dot(q, to_y_), dot(q, to_z_)}; }

std::optional<Depth> View::depth(const Surface& surface) const {
  Depth depth;
  depth.height = (surface.offset << lift_) - dot(surface.normal, eye_);
  if (depth.height == 0) return std::nullopt;
  depth.form = line(surface.normal);
  depth.front = depth.height < 0;
  if (depth.front) {
    depth.height = -depth.height;
    negate(depth.form);
  }
  depth.a = rough_ratio(depth.form.x, depth.height, depth_shift_);
  depth.b = rough_ratio(depth.form.y, depth.height, depth_shift_);
  depth.c = rough_ratio(depth.form.z, depth.height, depth_shift_);
  depth.scale = std::max({std::abs(depth.a), std::abs(depth.b), std::abs(depth.c)});
  return depth;
}

std::deque<Line> View::sides(const Piece& piece, bool front) const {
  std::vector<Triple> rays;
  for (const Corner& corner : piece) rays.push_back(ray(corner));
  std::deque<Line> out;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    // For a plane at positive height (seen from behind) a x b points inwards where the chain runs counter-clockwise.
    Triple n = cross(rays[i], rays[(i + 1) % rays.size()]);
    if (front) negate(n);
    out.push_back(make_line(line(n)));
  }
  return out;
}

View::Near View::near(std::uint32_t vertex) const {
  const auto& p = scene_.near(vertex);
  // The difference is rounded once; snapped coordinates are rounded before as well.
  std::array<double, 3> q{}, off{};
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = p[i] - near_eye_[i];
    off[i] = std::abs(q[i]) * 0x1p-52;
    if (scene_.snapped()) off[i] += (std::abs(p[i]) + std::abs(near_eye_[i])) * 0x1p-52;
  }
  // Coefficients are off by 2^-52, products and sums of three by 3 * 2^-53, relative to the sum of magnitudes.
  double error = 0;
  const auto apply = [&](const std::array<double, 3>& k) {
    double sum = 0, bound = 0x1p-1000;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += k[i] * q[i];
      bound += std::abs(k[i]) * (std::abs(q[i]) * 0x1p-50 + off[i] * 1.01);
    }
    error = std::max(error, bound);
    return sum;
  };
  Near near{apply(near_x_), apply(near_y_), apply(near_z_), 0};
  // NaN would be lost in max(): it must spoil the bound.
  near.error = std::isfinite(near.x + near.y + near.z) ? error : HUGE_VAL;
  return near;
}

}  // namespace sightline::verify
