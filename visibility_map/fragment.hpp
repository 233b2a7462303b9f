// What a tracer hands to the stitcher: regions of the view that tile it, each seeing one thing.
#pragma once

#include <span>
#include <vector>

#include "exact/sightline_table.hpp"
#include "exact/stamped_map.hpp"
#include "scene/scene.hpp"

namespace sightline {

/// A ray in which two sightlines meet: sign * (N_low x N_high), N being the canonical normals, low < high.
struct FragmentCorner {
  SightlineId low, high;
  Sign sign;
  /// The ray n_b x n_a of two oriented lines.
  static FragmentCorner of(SightlineRef a, SightlineRef b) {
    return b.id < a.id ? FragmentCorner{b.id, a.id, b.sign * a.sign} : FragmentCorner{a.id, b.id, -a.sign * b.sign};
  }
};

/// A piece of a fragment's boundary: along a sightline whose normal points inwards, between two corners that have it in
/// their names, of positive length and less than half a turn, counter-clockwise as seen from the eye (right hand rule
/// of an ordinary camera).
struct FragmentSide {
  SightlineRef line;
  std::uint32_t from, to;  // into Fragments::corners
};

/// A connected region of the view; its boundary may have notches, and touch itself in single rays.
struct Fragment {
  std::uint32_t first_side;  // into Fragments::sides
  std::uint32_t side_count;
  std::uint32_t first_seen;  // into Fragments::seen: the pieces seen here, all in one plane, ascending by polygon;
  std::uint32_t seen_count;  // the first is the owner, the others coincide with it. 0: nothing is hit.
};

/// Fragments that tile the window (or the sphere): interiors disjoint, nothing left out.
struct Fragments {
  std::vector<Fragment> fragments;
  std::vector<FragmentSide> sides;
  std::vector<FragmentCorner> corners;
  /// Of the corners, or of none of them: largest component between 2^-10 and 2, each within 9 * 2^-53.
  std::vector<glm::dvec3> rays;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> same;  // corners known to be one ray; others may be, too
  std::vector<SurfaceId> seen;
  /// What lines were made of: needed only where fragments that see nothing may lie beside lines that are no edges of
  /// what is seen there, because a tracer does not follow all beams.
  struct Origin {
    SightlineId line;
    bool edge;            // of two points, else of two planes
    std::uint32_t of[2];  // PointId or PlaneId
  };
  std::vector<Origin> origins;

  void clear();
  /// A convex fragment, by its lines in counter-clockwise order: at least 3, each a side of positive length.
  void add_convex(std::span<const SightlineRef> lines, std::span<const SurfaceId> on);
  /// Those of another part of the view, whose lines are in a table of their own, of the same eye.
  void append(const Fragments& part, const SightlineTable& from, SightlineTable& to);

 private:
  std::uint32_t corner(SightlineRef a, SightlineRef b);
  StampedMap by_lines_;                // the corners made by add_convex
  std::vector<SightlineRef> line_of_;  // by line of the part appended
  std::vector<std::uint64_t> words_;
};

}  // namespace sightline
