// Convex regions of the view, bounded by sightlines.
#pragma once

#include <span>
#include <vector>

#include "exact/sightline_table.hpp"

namespace sightline {

/// A side of a region: its line with the normal pointing inwards, that normal rounded, and the corner with the next
/// side, the ray n_next x n_line of the rounded normals.
struct RegionSide {
  SightlineRef line;
  glm::dvec3 normal;
  glm::dvec3 corner;
};

/// Regions as lists of sides on one stack: counter-clockwise as seen from the eye, every side of positive length. The
/// corners serve filters alone; what is decided is the sign of three sightlines.
class Regions {
 public:
  struct Region {
    std::uint32_t first, count;  // count 0: empty
  };

  Region push(const SightlineTable& table, std::span<const SightlineRef> sides);
  /// The part of a region on the inner side of a line, on top of the stack. The very region where nothing is cut off;
  /// empty where no interior is left.
  Region clip(SightlineTable& table, Region region, SightlineRef line);
  std::span<const RegionSide> sides(Region r) const { return std::span(stack_).subspan(r.first, r.count); }

  std::uint32_t mark() const { return static_cast<std::uint32_t>(stack_.size()); }
  void release(std::uint32_t mark) { stack_.resize(mark); }

 private:
  /// Where a line passes: bit 0: corners behind it, bit 1: in front. Their signs are in sign_.
  int classify(SightlineTable& table, Region region, SightlineRef line);

  std::vector<RegionSide> stack_;
  std::vector<std::int8_t> sign_;
};

}  // namespace sightline
