// Convex parts of one surface, bounded by lines of its plane. For this folder's own use.
#pragma once

#include "clip/clip.hpp"
#include "clip/short_list.hpp"
#include "exact/plane_lines.hpp"

namespace sightline {

struct OutlineSide {
  SightlineRef line;   // inwards
  std::uint32_t name;  // index into Outlines::names
};

/// Sides run counter-clockwise as Outlines sees them; side i ends in corner i, where side i + 1 begins.
struct Outline {
  ShortList<OutlineSide, 8> sides;
  ShortList<glm::dvec3, 8> corner;  // unit coordinates, to the nearest doubles: the same however the outline was made
  std::size_t size() const { return sides.size(); }
};

/// Cuts the outlines of one surface. All of them have an interior.
class Outlines {
 public:
  Outlines(const Scene& scene, SurfaceId surface);

  PlaneLines& lines() { return lines_; }
  const PlaneLines& lines() const { return lines_; }
  Outline whole();
  Sign side(const Outline& o, std::size_t corner, SightlineRef line) {
    return lines_.side(o.corner[corner], o.sides[corner].line, o.sides[corner + 1 == o.size() ? 0 : corner + 1].line,
                       line);
  }
  /// Bit 0: partly outside of the line, bit 1: partly inside. Remembered for split().
  int sides(const Outline& o, SightlineRef line);
  /// Cuts an outline that lies on both sides, as found by sides() just before.
  void split(const Outline& o, OutlineSide by, Outline& outside, Outline& inside);
  /// If side i of `a` is side k of `b`, whole and the other way round, and together they are convex: puts their union
  /// into a.
  bool unite(Outline& a, std::size_t i, const Outline& b, std::size_t k);

  std::uint32_t name(const ClipSide& side);
  const ClipSide& name(std::uint32_t index) const { return names_[index]; }
  /// Area in unit coordinates, rounded.
  double area(const Outline& o) const;

 private:
  const Scene& scene_;
  const Surface& surface_;
  PlaneLines lines_;
  std::vector<ClipSide> names_;
  std::vector<std::int8_t> sign_;
};

}  // namespace sightline
