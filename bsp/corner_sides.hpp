// On which side of a plane the corners of a piece lie.
#pragma once

#include <array>

#include "exact/edge_vertex.hpp"
#include "scene/scene.hpp"

namespace sightline {

/// A corner of a piece: a point of the scene, or where three planes meet, the first of them the piece's own. The edge
/// that follows it lies in `side`; where that is a plane that has cut the piece, `inside` is the piece's side of it.
struct PieceCorner {
  ImplicitVertex place;
  PointId point;
  PlaneId side;
  Sign inside;
};

/// Signs of corners of pieces of one surface against one plane. Where doubles cannot tell, the surface's own corners
/// mostly can, for a fraction of the price: a corner that a cut has made lies amid a side of the surface or amid the
/// surface, so that ends, or corners, on one side have it there too, and a side in the plane has it in the plane.
class CornerSides {
 public:
  /// `planes`: the scene's table, or one that goes on from it.
  CornerSides(const Scene& scene, const PlaneTable& planes, SurfaceId surface, PlaneId plane)
      : planes_(planes), edges_(scene.edges(scene.surfaces()[surface])), plane_(plane) {}

  Sign of(const PieceCorner& corner);

 private:
  Sign exact(const PieceCorner& corner);
  Sign by_side(std::size_t edge, PlaneId cut);
  Sign by_surface();
  Sign of_point(std::size_t k);

  const PlaneTable& planes_;
  std::span<const SurfaceEdge> edges_;
  PlaneId plane_;
  static constexpr std::size_t remembered = 8;
  static constexpr std::int8_t unknown = 3;
  std::array<std::int8_t, remembered> sign_{unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown};
};

}  // namespace sightline
