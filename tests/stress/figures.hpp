// Scenes that are hard on numbers, and eyes where it is hardest to be.
#pragma once

#include <array>
#include <vector>

#include "tests/oracle/scenes.hpp"

namespace sightline::stress {

using testing::Random;

/// Gathers polygons.
class Figure {
 public:
  std::uint32_t vertex(const glm::dvec3& place);
  void join(const std::vector<std::uint32_t>& corners);
  /// With vertices of its own.
  void add(const std::vector<glm::dvec3>& places);
  /// From a corner along two sides.
  void add_parallelogram(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);
  /// Six squares that share eight vertices, running counter-clockwise from outside.
  void add_box(const glm::dvec3& low, const glm::dvec3& high);
  PolygonSoup soup;
};

/// x, so many units in the last place further.
double stepped(double x, int units);
/// The soup with every vertex where `place` puts it.
template <class Place>
PolygonSoup placed(PolygonSoup soup, const Place& place) {
  for (glm::dvec3& v : soup.vertices) v = place(v);
  return soup;
}

/// A rotation, but for rounding.
struct Turn {
  std::array<glm::dvec3, 3> row;
  glm::dvec3 operator()(const glm::dvec3& v) const;
};
Turn some_turn(Random& random);

/// Polygons in a plane, some of whose corners are one unit in the last place off it.
PolygonSoup all_but_coplanar(Random& random);
/// Triangles a million million times as long as wide, among others.
PolygonSoup slivers(Random& random);
/// Such triangles, stuck through a stack of rectangles.
PolygonSoup needles(Random& random);
/// Three to six bars, each over the next; at their crossings they touch, or all but.
PolygonSoup cycle(Random& random);
/// A wall whose pieces meet in T-junctions, up to two units in the last place apart or over each other; a wall behind.
PolygonSoup cracked_wall(Random& random);
/// Few polygons, each several times: with its own vertices, turned round, begun elsewhere, with corners too many.
PolygonSoup duplicates(Random& random);
/// A box of squares that are there twice, front and back; or a box in a box, one unit in the last place between them.
PolygonSoup shell(Random& random);
/// Coordinates from 1e-300 to 1e300.
PolygonSoup mixed_exponents(Random& random);
/// Rectangles in one plane that overlap, on whole numbers from 0 to `range`.
PolygonSoup coplanar_crowd(Random& random, int count, int range);
/// Parallelograms through the origin; `sharing` it as a corner, or in their middle.
PolygonSoup crowd_through_a_point(Random& random, int count, bool sharing);
/// Parallelograms through the z-axis, or that end there.
PolygonSoup crowd_through_a_line(Random& random, int count, bool sharing);

/// A place on a vertex, an edge, its line, a plane or between some of them; half of them one unit in the last place
/// beside it in some coordinates.
glm::dvec3 hard_eye(const PolygonSoup& soup, Random& random);
/// From there towards a vertex, along an edge, or past it all.
Camera hard_camera(const PolygonSoup& soup, Random& random);

}  // namespace sightline::stress
