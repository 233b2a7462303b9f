// What a tracer hands to the stitcher: convex regions of the view that tile it, each seeing one thing.
#pragma once

#include "exact/sightline_table.hpp"
#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace sightline {

/// A convex region of the view. Its sides are sightlines whose normals point inwards, in counter-clockwise order as
/// seen from the eye (right hand rule of an ordinary camera: the corner between side i and the next side j is the ray
/// n_j x n_i). At least 3 sides, each of positive length; no two sides have the same line.
struct Fragment {
  std::uint32_t first_side;  // into Fragments::sides
  std::uint32_t side_count;
  std::uint32_t first_seen;  // into Fragments::seen: the pieces seen here, all in one plane, ascending by polygon;
  std::uint32_t seen_count;  // the first is the owner, the others coincide with it. 0: nothing is hit.
};

/// Fragments that tile the window (or the sphere): interiors disjoint, nothing left out.
struct Fragments {
  std::vector<Fragment> fragments;
  std::vector<SightlineRef> sides;
  std::vector<SurfaceId> seen;
  void clear() {
    fragments.clear();
    sides.clear();
    seen.clear();
  }
};

}  // namespace sightline
