// Where the convex pieces of polygons are collected, each with its walls.
#pragma once

#include "scene/scene.hpp"

namespace sightline {

/// A side of a convex piece on the line of points a and b, in the direction from a to b; `corner` is the scene point
/// where it ends and the next side begins, or `none`.
struct PieceSide {
  PointId a, b, corner;
};

/// The axis in which the plane is steepest: of the largest component of its normal, ties to the lowest axis. Decided on
/// the rounded normal, which is enough: that component is far from zero, and the choice is the same everywhere.
int steepest_axis(const ApproxPlane& plane);

/// Builds Surface and SurfaceEdge lists; makes each wall once.
class SurfaceList {
 public:
  /// `representative`: of each point the lowest index of an equal point. The lists have room for this many surfaces and
  /// edges at once, and grow beyond.
  SurfaceList(PlaneTable& planes, std::span<const PointId> representative, std::size_t surface_count,
              std::size_t edge_count);

  /// A convex piece of `polygon` with its corners in order. `flipped`: seen from the front of the plane they run
  /// clockwise.
  void add(PolygonId polygon, PlaneTable::Interned plane, std::span<const PointId> corners);
  /// The same by sides; `reversed`: they run clockwise seen from the front of the plane. `flipped` is the piece's own.
  void add(PolygonId polygon, PlaneId plane, std::span<const PieceSide> sides, bool reversed, bool flipped);

  std::vector<Surface> surfaces;
  std::vector<SurfaceEdge> edges;

 private:
  struct Wall {
    std::uint64_t points = 0;  // the two representatives, the lower one first
    PlaneId plane = none;      // none: a free slot
    std::int8_t axis = 0;
    bool flipped = false;
  };
  PlaneTable::Interned wall(PointId a, PointId b, int axis);
  void grow();
  void add_edge(PointId a, PointId b, PointId corner, int axis, Sign slope);

  PlaneTable& planes_;
  std::span<const PointId> representative_;
  std::vector<Wall> walls_;
  std::size_t wall_count_ = 0;
};

}  // namespace sightline
