// Which polygons are near enough to be looked at. Internal to beam/.
#pragma once

#include "bsp/tree.hpp"

namespace sightline {

/// Polygons whose bounding box (along the axes, of its vertices) is no farther from the eye than a distance, exactly.
class Reach {
 public:
  /// `distance` in the scene's units, positive; infinite: every polygon is in reach, and nothing is computed.
  Reach(const Scene& scene, double distance);
  double distance() const { return distance_; }
  /// `approx` are the eye's unit coordinates, the nearest doubles.
  void start(const GridPoint& eye, const glm::dvec3& approx);
  bool holds(PolygonId polygon) const { return everything_ || decide(polygon); }
  /// False only if no polygon with a piece in the node or below it is in reach.
  bool may_hold(const TreeNode& node) const;

 private:
  bool decide(PolygonId polygon) const;
  bool decide_exactly(PolygonId polygon) const;

  const Scene* scene_;
  double distance_;
  bool everything_;
  double in_units_ = 0;  // the distance in unit coordinates, within 2^-51 of itself
  GridPoint eye_;
  glm::dvec3 at_{0};
  double scale_ = 1;  // the larger of 1 and the eye's reach
};

}  // namespace sightline
