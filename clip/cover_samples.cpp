// Yu's variant: polygons are looked up in the buffer by samples instead of by scan conversion.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "clip/cover_buffer.hpp"
#include "exact/predicates.hpp"

namespace sightline {
namespace {

constexpr double u = 0x1p-53;   // unit roundoff
constexpr int most_steps = 64;  // along a side of a triangle

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

struct CoverBuffer::Samples {
  Linear depth;        // inverse, of the figure's plane
  double most_depth;   // what is added over a pixel, errors included
  glm::dvec3 s, t, w;  // about: ray . s / ray . w is the place of a ray in pixels
  double turn;         // the sign of det(right, up, corner)
  double doubt;        // of a side of a neighbourhood at a corner of a cell
};

// Cells between samples are parallelograms, and triangles at the far side, which tile the figure: figures' corners are
// within 2^-48 of their doubles, samples are weighted means of three and so within 2^-46 of theirs. A neighbourhood is
// a rectangle of pixels. It holds a cell if all corners of the cell are inside of the planes through the eye and the
// rectangle's sides: such a plane has the normal up x ray, or ray x right. Up to a window's width outside of the window
// rays are below 5 by component and known within 16u; `up` and `right` are at most 1: normals are below 10, within
// 2 (16u + 5u) + 10u, below 64u. As in cone(), p - e is below Q = E + 1 and within h = 2^-45 + 2^-51 Q: the product of
// the two is off by less than 3 (10h + 64uQ) and 90 uQ for its roundings, below 32h + 512 uQ.
//
// On which side of these planes the rectangle lies follows from the sign of det(right, up, corner). With R and U the
// largest components of the first two it is off by less than 200 u RU.
bool CoverBuffer::hides_by_samples(std::span<const glm::dvec3> corners, PlaneId plane) const {
  Samples samples;
  double depth_error;
  if (!(reach_ < 0x1p100) || !inverse_depth(plane, samples.depth, depth_error)) return false;
  samples.most_depth = std::max(samples.depth.x, 0.0) + std::max(samples.depth.y, 0.0) + depth_error;
  const double far = reach_ + 1, h = 0x1p-45 + 0x1p-51 * far;
  samples.doubt = 32 * h + 512 * u * far;
  samples.s = static_cast<double>(size_) * glm::cross(up_, corner_);
  samples.t = static_cast<double>(size_) * glm::cross(corner_, right_);
  samples.w = glm::cross(right_, up_);
  const double det = glm::dot(samples.w, corner_);
  if (!(std::abs(det) > 512 * u * largest(right_) * largest(up_))) return false;
  samples.turn = det > 0 ? 1 : -1;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    if (!hides_triangle(samples, corners[0], corners[k - 1], corners[k])) return false;
  }
  return true;
}

bool CoverBuffer::hides_triangle(const Samples& samples, const glm::dvec3& a, const glm::dvec3& b,
                                 const glm::dvec3& c) const {
  const auto pixel = [&](const glm::dvec3& p) {
    const glm::dvec3 ray = p - eye_;
    return glm::dvec2(glm::dot(samples.s, ray), glm::dot(samples.t, ray)) / glm::dot(samples.w, ray);
  };
  const glm::dvec2 at[] = {pixel(a), pixel(b), pixel(c)};
  const double longest =
      std::max({glm::distance(at[0], at[1]), glm::distance(at[1], at[2]), glm::distance(at[2], at[0])});
  const int steps = longest < most_steps ? std::max(1, static_cast<int>(std::ceil(longest))) : most_steps;

  const auto sample = [&](int i, int j) {
    return a + (static_cast<double>(i) / steps) * (b - a) + (static_cast<double>(j) / steps) * (c - a);
  };
  // Along an axis of the window: the plane through the eye and where pixel k begins.
  const auto line = [&](int axis, int k) {
    const double part = static_cast<double>(k) / size_;
    return axis == 0 ? glm::cross(up_, corner_ + part * right_) : glm::cross(corner_ + part * up_, right_);
  };
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; i + j < steps; ++j) {
      const glm::dvec3 cell[] = {sample(i, j), sample(i + 1, j), sample(i, j + 1),
                                 i + j + 1 < steps ? sample(i + 1, j + 1) : sample(i, j)};
      int low[2], high[2];
      for (int axis = 0; axis < 2; ++axis) {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (const glm::dvec3& p : cell) {
          const double x = pixel(p)[axis];
          least = std::min(least, x);
          most = std::max(most, x);
        }
        if (!(least > -size_ && most < 2 * size_)) return false;
        low[axis] = static_cast<int>(std::floor(least - 0.01));
        high[axis] = static_cast<int>(std::ceil(most + 0.01));
        const glm::dvec3 from = samples.turn * line(axis, low[axis]), to = -samples.turn * line(axis, high[axis]);
        for (const glm::dvec3& p : cell) {
          if (!(glm::dot(from, p - eye_) > samples.doubt && glm::dot(to, p - eye_) > samples.doubt)) return false;
        }
      }
      for (int y = std::max(low[1], 0); y < std::min(high[1], size_); ++y) {
        const float* const row = nearest_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_);
        for (int x = std::max(low[0], 0); x < std::min(high[0], size_); ++x) {
          const double depth = samples.depth.c + samples.depth.x * x + samples.depth.y * y + samples.most_depth;
          if (!(depth < static_cast<double>(row[x]))) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace sightline
