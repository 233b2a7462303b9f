// Predicates without exact stages: takes the place of exact/predicates.cpp in the program that measures what they cost.
// Undecided signs are those of the doubles as they stand, once scene and tree have been made.
#include "exact/predicates.hpp"

#include "compare/plain/predicates.hpp"
#include "exact/plane_row.hpp"

#include <glm/geometric.hpp>

namespace sightline {

bool comparison::prepares = true;

namespace {

Sign sign_of_double(double x) { return (x > 0) - (x < 0); }
glm::dvec3 normal_of(const ApproxPlane& q) { return {q.n[0], q.n[1], q.n[2]}; }
std::array<Integer, 3> normal_of(const PlaneTable& planes, PlaneId p) {
  return {planes.integer(p, 0), planes.integer(p, 1), planes.integer(p, 2)};
}

}  // namespace

Sign point_side(const PlaneTable& planes, PointId p, PlaneId q) {
  const double value = glm::dot(normal_of(planes.approx(q)), planes.points().approx(p)) - planes.approx(q).d;
  constexpr double bound = 32 * 0x1p-53;  // of the filter in exact/predicates.cpp
  if (!comparison::prepares || value > bound || value < -bound) return sign_of_double(value);
  const Integer exact = dot<0, 0, 0>(normal_of(planes, q), planes.points().point(p)) - planes.integer(q, 3);
  return sgn(exact);
}

Sign orientation(const PointTable& points, PointId a, PointId b, PointId c, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  if (comparison::prepares) {
    const std::array<Integer, 3> p = points.point(a), q = points.point(b), r = points.point(c);
    const auto x = static_cast<std::size_t>(i), y = static_cast<std::size_t>(j);
    const Integer exact = (q[x] - p[x]) * (r[y] - p[y]) - (q[y] - p[y]) * (r[x] - p[x]);
    return sgn(exact);
  }
  const glm::dvec3 q = points.approx(b) - points.approx(a), r = points.approx(c) - points.approx(a);
  return sign_of_double(q[i] * r[j] - q[j] * r[i]);
}

/// Unit coordinates are rounded from what one grid holds: where they differ, so do the points, the same way.
Sign compare(const PointTable& points, PointId a, PointId b, int axis) {
  const Sign s = sign_of_double(points.approx(a)[axis] - points.approx(b)[axis]);
  if (s != 0 || !comparison::prepares) return s;
  const auto k = static_cast<std::size_t>(axis);
  const Integer exact = points.point(a)[k] - points.point(b)[k];
  return sgn(exact);
}

// Of trees alone: exact.
Sign planes_orientation(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c) {
  return exact_normals_orientation(PlaneRow(planes, a), PlaneRow(planes, b), PlaneRow(planes, c));
}

bool parallel(const PlaneTable& planes, PlaneId a, PlaneId b) {
  const std::array<Integer, 3> n = cross<0, 0>(normal_of(planes, a), normal_of(planes, b));
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

}  // namespace sightline
