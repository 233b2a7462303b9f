// The pieces' corners again, from the names of their sides: exact, in homogeneous integers. For this folder's own use.
#pragma once

#include <deque>

#include "clip/view.hpp"

namespace sightline {

/// n.x = d with x in grid units; or, as a point, n / d.
struct ExactRow {
  std::array<Integer, 3> n;
  Integer d;
};

class SidePlanes {
 public:
  /// Cameras and regions are those that the pieces were made with.
  SidePlanes(const Scene& scene, std::span<const Camera> cameras, std::span<const std::vector<TextureRegion>> regions);

  ExactRow surface(SurfaceId surface) const { return plane(scene_.surfaces()[surface].plane); }
  /// A plane through a side of a piece of the surface, other than the surface's own.
  ExactRow side(const ClipSide& side, SurfaceId surface);
  /// The point in which three planes meet; d > 0.
  static ExactRow meet(const ExactRow& a, const ExactRow& b, const ExactRow& c);
  static bool holds(const ExactRow& plane, const ExactRow& point);
  /// Sign of a's coordinate k less b's.
  static Sign compare(const ExactRow& a, const ExactRow& b, std::size_t k);

 private:
  ExactRow plane(PlaneId p) const;
  ExactRow through_eye(const ClipView& view, SightlineRef line) const;

  const Scene& scene_;
  std::deque<ClipView> views_;
};

}  // namespace sightline
