// The pieces of a clip without T-junctions.
#pragma once

#include "clip/clip.hpp"

namespace sightline {

/// Pieces as lists of corners: piece k has corners[first[k] .. first[k + 1]), counter-clockwise seen from the front of
/// its plane. Corners are indices into ClipResult::corners, and those that are one place have one index.
struct TFreePieces {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> corners;
};

/// Gives every piece the corners of other pieces that lie on its sides, so that sides which meet are shared whole:
/// between the pieces of one polygon, and wherever sides of any two run along one line. Cameras and options are those
/// of the clip.
/// Laws. 1: no corner of a piece lies inside a side of another. 2: without the corners that lie straight between their
/// neighbours the pieces are those of the clip. 3: two corners have one index just if they are one place. All are
/// decided exactly, by the names of the sides.
TFreePieces t_free(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options,
                   const ClipResult& result);

}  // namespace sightline
