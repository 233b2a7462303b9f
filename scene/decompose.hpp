// Any loop in a plane as convex pieces, by the even-odd rule.
#pragma once

#include "scene/surface_list.hpp"

#include <span>
#include <vector>

namespace sightline {

/// A convex piece; its sides run counter-clockwise seen along the axis (from its positive end).
struct ConvexPiece {
  std::vector<PieceSide> sides;
  Sign turn;  // the direction in which the loop runs around the piece: +1 counter-clockwise
};

struct Decomposition {
  std::vector<ConvexPiece> pieces;  // none: the loop has no area
  bool self_crossing = false;
};

/// The interior of the loop by the even-odd rule, tiled by convex pieces each of whose sides lies on the line of one of
/// the loop's own edges. All its points lie in one plane, which is not parallel to `axis`; all is done in the view
/// along it. The loop may cross or touch itself, run back over itself (that part has no area), repeat vertices. A loop
/// crosses itself if it winds around some places more than once, or around some in either direction.
Decomposition decompose(const PointTable& points, std::span<const PointId> loop, int axis);

}  // namespace sightline
