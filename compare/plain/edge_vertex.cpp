// Where an edge is cut, without exact stages: takes the place of exact/edge_vertex.cpp in the program that measures
// what they cost.
#include "exact/edge_vertex.hpp"

#include <glm/geometric.hpp>

namespace sightline {
namespace {

double value_at(const PlaneTable& planes, PlaneId q, const glm::dvec3& p) {
  const ApproxPlane& a = planes.approx(q);
  return a.n[0] * p.x + a.n[1] * p.y + a.n[2] * p.z - a.d;
}

glm::dvec3 meeting(const PlaneTable& planes, PlaneId cut, PointId a, PointId b) {
  const glm::dvec3 &p = planes.points().approx(a), &q = planes.points().approx(b);
  const double at_a = value_at(planes, cut, p), at_b = value_at(planes, cut, q);
  return (at_a * q - at_b * p) / (at_a - at_b);
}

}  // namespace

Sign edge_vertex_side(const PlaneTable& planes, PlaneId cut, PointId a, PointId b, PlaneId q) {
  const double value = value_at(planes, q, meeting(planes, cut, a, b));
  return (value > 0) - (value < 0);
}

ImplicitVertex make_edge_vertex(const PlaneTable& planes, PlaneId face, PlaneId wall, PlaneId cut, PointId a,
                                PointId b) {
  return {{face, wall, cut}, 0, meeting(planes, cut, a, b)};
}

}  // namespace sightline
