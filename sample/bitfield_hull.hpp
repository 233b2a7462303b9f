// The convex hull of directions, and the triangle of it that holds a viewer. (Meruvia and Strothotte, section 3.2.1.)
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sightline {

/// A direction as a point of the sphere of radius 2^26, each coordinate rounded once to an integer.
using ViewDirection = std::array<std::int64_t, 3>;
/// (0, 0, 0) for a vector that is zero or not finite.
ViewDirection view_direction(const glm::dvec3& v);

/// Triangles, counter-clockwise seen from outside. All signs are exact.
///
/// Laws. 1: no direction lies outside of any face. 2: every edge has one face on either side, and faces - edges +
/// corners = 2. 3: every direction is held by a face, and by several only on their common border. 4: a face holds its
/// corners.
class ViewHull {
 public:
  struct Face {
    std::array<std::uint32_t, 3> corner;     // indices of directions
    std::array<std::uint32_t, 3> neighbour;  // the face beyond the edge from corner k to corner k + 1
  };

  /// Throws std::invalid_argument, in one line, unless the origin lies strictly inside of the hull: where there are
  /// fewer than four directions, or all of them look to one side.
  explicit ViewHull(std::vector<ViewDirection> directions);

  std::span<const ViewDirection> directions() const { return directions_; }
  std::span<const Face> faces() const { return faces_; }
  /// The face that the ray from the origin along d goes through; on a border the first of those there, and face 0 for
  /// no direction at all.
  std::uint32_t face_holding(const ViewDirection& d) const;
  /// The three corners of a face, and behind them the opposite corners of its neighbours. (On a tetrahedron some of
  /// these are the same.)
  std::array<std::uint32_t, 6> around(std::uint32_t face) const;
  /// Of every direction the corner of the hull that is nearest to it by angle: mostly itself, but for one that is there
  /// twice, or that rounding has put inside of the hull.
  std::vector<std::uint32_t> nearest_corners() const;

 private:
  std::vector<ViewDirection> directions_;
  std::vector<Face> faces_;
};

}  // namespace sightline
