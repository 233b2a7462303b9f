// The complex as a tracer walks it: read once from the winged-pair, shared by all threads.
#pragma once

#include "winged_pair/traverse.hpp"

namespace sightline {

/// One side of a face, walked counter-clockwise seen from the front of its plane.
struct FaceSide {
  EdgeId edge;
  std::uint32_t direction;  // Pair::direction
};

/// Lists gathered by the winged-pair's traversals, contiguous in memory.
struct Topology {
  explicit Topology(const Complex& complex);

  std::vector<std::uint32_t> first_face;  // by cell
  std::vector<FaceId> faces;
  std::vector<std::uint32_t> first_side;  // by face
  std::vector<FaceSide> sides;
  std::vector<FaceId> outer;  // faces of the box

  std::span<const FaceId> faces_of(CellId c) const {
    return std::span(faces).subspan(first_face[c], first_face[c + 1] - first_face[c]);
  }
  std::span<const FaceSide> sides_of(FaceId f) const {
    return std::span(sides).subspan(first_side[f], first_side[f + 1] - first_side[f]);
  }
};

}  // namespace sightline
