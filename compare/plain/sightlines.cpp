// SightlineTable without its exact stages: takes the place of exact/sightline_exact.cpp in the program that measures
// what they cost. Normals are what doubles make of them, and an undecided sign is that of the double as it stands.
#include "exact/rounding.hpp"
#include "exact/sightline_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

Sign sign_of_double(double x) { return (x > 0) - (x < 0); }

/// Times a power of two, largest component in [1/2, 1).
glm::dvec3 scaled(const glm::dvec3& n) {
  const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(largest) >> 52;
  // Coordinates are at most 1/2 and the eye's not much more: else the line is none.
  if (exponent < 100 || exponent > 1900) return glm::dvec3(0);
  return n * std::bit_cast<double>((2045 - exponent) << 52);
}

double value_at(const ApproxPlane& q, const glm::dvec3& p) { return q.n[0] * p.x + q.n[1] * p.y + q.n[2] * p.z - q.d; }

}  // namespace

// The table keeps a normal as three integers of one word: that of the double, cut off at 62 bits. Lines are one line
// where these are multiples of one another.
template <>
SightlineRef SightlineTable::intern_short<double>(const std::array<double, 3>& given) {
  const glm::dvec3 n = scaled({given[0], given[1], given[2]});
  if (n == glm::dvec3(0)) return {};
  std::uint64_t words[3];
  Normal made{words, 62, {}, n, {}};
  for (int k = 0; k < 3; ++k) {
    words[k] = static_cast<std::uint64_t>(static_cast<std::int64_t>(n[k] * 0x1p62));
    made.sign[k] = sign_of_double(n[k]);
  }
  return find_or_add(made);
}

SightlineRef SightlineTable::intern(std::uint64_t* words, std::uint32_t stride) {
  std::uint32_t bits = 0;
  for (std::uint32_t k = 0; k < 3; ++k) bits = std::max(bits, magnitude_bits(words + k * stride, stride));
  std::array<double, 3> n;
  for (std::uint32_t k = 0; k < 3; ++k) n[k] = words_to_double(words + k * stride, stride, -static_cast<int>(bits));
  return intern_short(n);
}

SightlineRef SightlineTable::of_normal(const std::array<Integer, 3>& n) {
  std::uint32_t bits = 0;
  for (const Integer& c : n) bits = std::max(bits, magnitude_bits(c));
  std::array<double, 3> doubles;
  for (std::size_t k = 0; k < 3; ++k) doubles[k] = nearest_double(n[k], -static_cast<int>(bits));
  return intern_short(doubles);
}

SightlineRef SightlineTable::of_plane(PlaneId p) {
  const ApproxPlane& q = planes_->approx(p);
  return intern_short(std::array{q.n[0], q.n[1], q.n[2]});
}

SightlineRef SightlineTable::make_of_points(PointId a, PointId b) {
  const glm::dvec3 &p = planes_->points().approx(a), &q = planes_->points().approx(b), &eye = exact_eye_.approx;
  const glm::dvec3 n = glm::cross(p - eye, q - eye);
  return intern_short(std::array{n.x, n.y, n.z});
}
SightlineRef SightlineTable::make_of_short_points(PointId a, PointId b) { return make_of_points(a, b); }

SightlineRef SightlineTable::make_of_planes(PlaneId p, PlaneId q) {
  const ApproxPlane &a = planes_->approx(p), &b = planes_->approx(q);
  const double at_a = value_at(a, exact_eye_.approx), at_b = value_at(b, exact_eye_.approx);
  return intern_short(
      std::array{at_a * b.n[0] - at_b * a.n[0], at_a * b.n[1] - at_b * a.n[1], at_a * b.n[2] - at_b * a.n[2]});
}

glm::dvec3 SightlineTable::corner(SightlineId a, SightlineId b) const {
  return scaled(glm::cross(line_[a].approx, line_[b].approx));
}

Sign SightlineTable::exact_eye_side(PlaneId p) const {
  return sign_of_double(value_at(planes_->approx(p), exact_eye_.approx));
}

Sign SightlineTable::exact_order(SightlineId a, SightlineId b, SightlineId c) {
  return sign_of_double(glm::dot(glm::cross(line_[a].approx, line_[b].approx), line_[c].approx));
}

Sign SightlineTable::exact_side(SightlineRef a, PointId p) const {
  return a.sign * sign_of_double(glm::dot(line_[a.id].approx, planes_->points().approx(p) - exact_eye_.approx));
}

bool SightlineTable::is_eye(PointId p) const { return planes_->points().approx(p) == exact_eye_.approx; }

}  // namespace sightline
