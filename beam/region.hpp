// Convex regions of the view, bounded by sightlines.
#pragma once

#include <span>
#include <vector>

#include "exact/sightline_table.hpp"

namespace sightline {

/// Regions as lists of sides on one stack: inward normals, counter-clockwise as seen from the eye, every side of
/// positive length. Nothing but signs of three sightlines is ever computed.
class Regions {
 public:
  struct Region {
    std::uint32_t first, count;  // count 0: empty
  };

  Region push(std::span<const SightlineRef> sides);
  /// The part of a region on the inner side of a line, on top of the stack. The very region where nothing is cut off;
  /// empty where no interior is left.
  Region clip(SightlineTable& table, Region region, SightlineRef line);
  std::span<const SightlineRef> sides(Region r) const { return std::span(stack_).subspan(r.first, r.count); }

  std::uint32_t mark() const { return static_cast<std::uint32_t>(stack_.size()); }
  void release(std::uint32_t mark) { stack_.resize(mark); }

 private:
  std::vector<SightlineRef> stack_;
  std::vector<std::int8_t> sign_;
};

}  // namespace sightline
