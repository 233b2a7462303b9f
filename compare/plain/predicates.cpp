// Predicates without exact stages: takes the place of exact/predicates.cpp in the program that measures what they cost.
// Undecided signs are those of the doubles as they stand, once the scene has been read.
#include "exact/predicates.hpp"

#include "compare/plain/predicates.hpp"
#include "exact/rounding.hpp"

#include <glm/geometric.hpp>

namespace sightline {

bool comparison::reads_scene = true;

namespace {

Sign sign_of_double(double x) { return (x > 0) - (x < 0); }
glm::dvec3 normal_of(const ApproxPlane& q) { return {q.n[0], q.n[1], q.n[2]}; }

}  // namespace

Sign point_side(const PlaneTable& planes, PointId p, PlaneId q) {
  if (comparison::reads_scene) {
    const std::array<Integer, 3> at = planes.points().point(p);
    return sgn(Integer(planes.integer(q, 0) * at[0] + planes.integer(q, 1) * at[1] + planes.integer(q, 2) * at[2] -
                       planes.integer(q, 3)));
  }
  return sign_of_double(glm::dot(normal_of(planes.approx(q)), planes.points().approx(p)) - planes.approx(q).d);
}

Sign vertex_side(const PlaneTable& planes, const ImplicitVertex& v, PlaneId q) {
  for (const PlaneId p : v.plane) {
    if (p == q) return 0;
  }
  return sign_of_double(glm::dot(normal_of(planes.approx(q)), v.approx) - planes.approx(q).d);
}

ImplicitVertex make_vertex(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c) {
  const ApproxPlane &p = planes.approx(a), &q = planes.approx(b), &r = planes.approx(c);
  const glm::dvec3 np = normal_of(p), nq = normal_of(q), nr = normal_of(r);
  const glm::dvec3 at = p.d * glm::cross(nq, nr) + q.d * glm::cross(nr, np) + r.d * glm::cross(np, nq);
  return {{a, b, c}, 0, at / glm::dot(np, glm::cross(nq, nr))};
}

Sign planes_orientation(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c) {
  return sign_of_double(
      glm::dot(normal_of(planes.approx(a)), glm::cross(normal_of(planes.approx(b)), normal_of(planes.approx(c)))));
}

bool parallel(const PlaneTable& planes, PlaneId a, PlaneId b) {
  return glm::cross(normal_of(planes.approx(a)), normal_of(planes.approx(b))) == glm::dvec3(0);
}

bool same_vertex(const PlaneTable&, const ImplicitVertex& a, const ImplicitVertex& b) { return a.approx == b.approx; }

Sign orientation(const PointTable& points, PointId a, PointId b, PointId c, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  if (comparison::reads_scene) {
    const std::array<Integer, 3> p = points.point(a), q = points.point(b), r = points.point(c);
    const auto x = static_cast<std::size_t>(i), y = static_cast<std::size_t>(j);
    return sgn(Integer((q[x] - p[x]) * (r[y] - p[y]) - (q[y] - p[y]) * (r[x] - p[x])));
  }
  const glm::dvec3 q = points.approx(b) - points.approx(a), r = points.approx(c) - points.approx(a);
  return sign_of_double(q[i] * r[j] - q[j] * r[i]);
}

/// Unit coordinates are correctly rounded from what one grid holds: where they differ, so do the points, the same way.
Sign compare(const PointTable& points, PointId a, PointId b, int axis) {
  const Sign s = sign_of_double(points.approx(a)[axis] - points.approx(b)[axis]);
  if (s != 0 || !comparison::reads_scene) return s;
  return sgn(
      Integer(points.point(a)[static_cast<std::size_t>(axis)] - points.point(b)[static_cast<std::size_t>(axis)]));
}

}  // namespace sightline
