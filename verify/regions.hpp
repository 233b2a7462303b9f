// Convex regions of the window against the faces of a map, and the surfaces that faces see.
#pragma once

#include "verify/drawing.hpp"

namespace sightline::verify {

/// A surface as the camera sees it: `hull` bounds it from outside, `outside` are the convex parts of the hull that do
/// not belong to it, each by its sides.
struct SeenSurface {
  const Surface* surface = nullptr;
  Depth depth;
  std::deque<Line> hull;
  std::vector<std::deque<Line>> outside;
};
/// The surfaces of a polygon whose planes do not contain the eye (and that show it their front, if `one_sided`).
std::vector<SeenSurface> see(const View& view, std::uint32_t polygon, bool one_sided);

/// Which of several surfaces is nearest just beside a point, a little in the direction (x, y, 0); null where none is
/// there. The direction must not lead along a side of any, and no two may be at equal depth there.
const SeenSurface* nearest_beside(const std::vector<SeenSurface>& seen, const Point& p, const Triple& direction);

std::vector<const Line*> pointers(const std::deque<Line>& lines);

/// Is the box certainly outside of the open region where all lines are positive?
bool outside(std::span<const Line* const> lines, const Box& box);

/// The part of a region on the positive sides of lines; false where it has no area.
bool clip_all(const Convex& region, std::span<const Line* const> lines, Convex& out);

/// Takes the closed convex region of `lines` out of pieces; negated lines are kept in `pool`.
std::vector<Convex> subtract(const std::vector<Convex>& pieces, std::span<const Line* const> lines,
                             std::deque<Line>& pool);

/// Does a convex region meet a face with their interiors?
bool meets_face(const Drawing& drawing, const Convex& region, std::uint32_t face);

}  // namespace sightline::verify
