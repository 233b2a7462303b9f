#include "beam/reach.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "exact/tally.hpp"

namespace sightline {

Reach::Reach(const Scene& scene, double distance)
    : scene_(&scene), distance_(distance), everything_(std::isinf(distance)) {
  if (everything_) return;
  int exponent = 0, step_exponent = 0;
  const double part = std::frexp(distance, &exponent) / std::frexp(scene.grid().step(), &step_exponent);
  in_units_ = std::ldexp(part, exponent - step_exponent - scene.grid().unit_bits());
}

void Reach::start(const GridPoint& eye, const glm::dvec3& approx) {
  if (everything_) return;
  eye_ = eye;
  at_ = approx;
  scale_ = std::max({1.0, std::abs(at_.x), std::abs(at_.y), std::abs(at_.z)});
}

/// With S the scale and u = 2^-53: points are within u / 2, the eye within u S, so that each of the three gaps between
/// the eye and the box, below 2 S, is within 4 u S; their squares are within 17 u S^2 each, the sum within 64 u S^2.
bool Reach::decide(PolygonId polygon) const {
  glm::dvec3 low{INFINITY}, high{-INFINITY};
  for (const PointId corner : scene_->corners(polygon)) {
    low = glm::min(low, scene_->points().approx(corner));
    high = glm::max(high, scene_->points().approx(corner));
  }
  const glm::dvec3 gap = glm::max(glm::max(low - at_, at_ - high), glm::dvec3(0));
  const double square = glm::dot(gap, gap), limit = in_units_ * in_units_;
  if (std::abs(square - limit) > 0x1p-47 * scale_ * scale_ + 0x1p-49 * limit) {
    ++tally().filter;
    return square < limit;
  }
  return decide_exactly(polygon);
}

bool Reach::decide_exactly(PolygonId polygon) const {
  Integer square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Integer low, high;
    bool first = true;
    for (const PointId corner : scene_->corners(polygon)) {
      const Integer at = scene_->points().point(corner)[k];
      if (first || at < low) low = at;
      if (first || at > high) high = at;
      first = false;
    }
    low <<= static_cast<mp_bitcnt_t>(eye_.shift);
    high <<= static_cast<mp_bitcnt_t>(eye_.shift);
    const Integer gap = eye_.c[k] < low ? Integer(low - eye_.c[k]) : eye_.c[k] > high ? Integer(eye_.c[k] - high) : 0;
    square += gap * gap;
  }
  ++tally().exact.back();
  mpq_class step = scene_->grid().exact_step();
  mpq_div_2exp(step.get_mpq_t(), step.get_mpq_t(), static_cast<mp_bitcnt_t>(eye_.shift));
  const mpq_class limit = distance_;
  return square * (step * step) <= limit * limit;
}

bool Reach::may_hold(const TreeNode& node) const {
  if (everything_) return true;
  const glm::dvec3 gap = glm::max(glm::abs(node.box.middle - at_) - node.box.half, glm::dvec3(0));
  return glm::length(gap) <= in_units_ * (1 + 0x1p-40) + node.spread + 0x1p-40 * scale_;
}

}  // namespace sightline
