// Recursive shallow clipping. For this folder's own use.
#pragma once

#include "clip/shadows.hpp"

namespace sightline {

enum class Sight : std::uint8_t { hidden, partly, visible };

struct CarvedPart {
  Outline outline;
  Sight sight;
};

/// Cuts an outline by shadows, that of the largest overlap first, until every part is wholly in one of them or wholly
/// outside of all. What turns out to be hidden altogether is left whole, at every depth: so which proof of that is
/// found, and when, changes no result.
class Carver {
 public:
  /// `threshold`: the area (unit coordinates) below which a partly visible part is not cut.
  Carver(Outlines& outlines, double threshold) : outlines_(outlines), threshold_(threshold) {}

  /// Appends the parts of the outline; true if any of it is visible.
  bool carve(const Outline& outline, std::span<const OutlineSide> frame, std::span<const Shadow> shadows,
             std::vector<CarvedPart>& parts);
  /// Bounds what the shadows hide of all of the surface, and drops those that hide nothing: where there are many
  /// pieces, most shadows miss most of them.
  void bound(const Outline& whole, std::vector<Shadow>& shadows);
  /// Have an outline and a figure any inside in common?
  bool meets(const Outline& outline, const Shadow& figure);
  std::uint64_t cuts() const { return cuts_; }

 private:
  /// `small`: it is enough to know whether any of it is visible.
  bool carve(const Outline& outline, std::span<const std::uint32_t> candidates, bool small,
             std::vector<CarvedPart>& parts);
  bool cut(const Outline& outline, std::span<const OutlineSide> lines, Outline& inside, std::vector<Outline>& outside);
  bool apart(const Outline& outline, const Shadow& shadow);
  double overlap(const Outline& outline, const Shadow& shadow);

  Outlines& outlines_;
  double threshold_;
  std::span<const Shadow> shadows_;
  std::uint64_t cuts_ = 0;
  std::vector<glm::dvec2> figure_, clipped_;
};

}  // namespace sightline
