// Decisions about points, planes and the vertices in which three planes meet. Each is the sign of a polynomial in the
// input doubles, and always the right sign.
//
// Laws. 1: the defining points of a plane lie on it. 2: vertex_side does not depend on the order of the vertex's
// planes. 3: it is zero, by identity, for them. 4: a vertex that is a point of the scene lies where the point lies.
// 5: planes_orientation changes sign with every exchange. 6: it is zero with every third plane for parallel ones.
// 7: a vertex is within its error, and that is below 2^-48 in the unit box. 8: orientation changes sign with every
// exchange. 9: compare is the order of the doubles.
#pragma once

#include "exact/plane_table.hpp"

namespace sightline {

/// A point named by three planes that meet in just it, with its unit coordinates. Each coordinate is within `error` of
/// the exact one; error is finite as long as the coordinates are within the range of doubles, and below 2^-48 for every
/// vertex in the unit box.
struct ImplicitVertex {
  PlaneId plane[3];
  double error;
  glm::dvec3 approx;
};

/// Sign of n.p - d for a point of the scene. +1: in front.
Sign point_side(const PlaneTable& planes, PointId p, PlaneId q);
/// Sign of n.v - d for the vertex v. Zero at once when q is one of its planes (identity), then by filter, then exactly.
Sign vertex_side(const PlaneTable& planes, const ImplicitVertex& v, PlaneId q);
/// The vertex of three planes, with proven error. Throws std::invalid_argument if they do not meet in one point.
ImplicitVertex make_vertex(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c);
/// Sign of det(n_a, n_b, n_c). Zero: the planes do not meet in one point.
Sign planes_orientation(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c);
/// Do the planes have parallel normals?
bool parallel(const PlaneTable& planes, PlaneId a, PlaneId b);
/// Are two vertices the same point?
bool same_vertex(const PlaneTable& planes, const ImplicitVertex& a, const ImplicitVertex& b);
/// Orientation of three points of the scene seen along an axis (the sign of the axis's component of (b-a) x (c-a)).
Sign orientation(const PointTable& points, PointId a, PointId b, PointId c, int axis);
/// Sign of the comparison of coordinate `axis` of two points: -1 if a is below b.
Sign compare(const PointTable& points, PointId a, PointId b, int axis);

}  // namespace sightline
