// Where a plane cuts an edge between two points of the scene: named by three planes like any vertex, but told by the
// points, whose numbers are a third as long.
#pragma once

#include "exact/predicates.hpp"

namespace sightline {

/// The vertex of `face`, `wall` and `cut`, where the first two meet in the line of points a and b, and these lie
/// strictly on two sides of `cut`: that of make_vertex, within the same error.
ImplicitVertex make_edge_vertex(const PlaneTable& planes, PlaneId face, PlaneId wall, PlaneId cut, PointId a,
                                PointId b);
/// The side of q on which the place lies where `cut` parts a from b. Law: vertex_side of make_edge_vertex, for any face
/// and wall.
Sign edge_vertex_side(const PlaneTable& planes, PlaneId cut, PointId a, PointId b, PlaneId q);

}  // namespace sightline
