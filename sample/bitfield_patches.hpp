// Bitfields of patches: one bit for several polygons that lie together. (Meruvia and Strothotte, section 5.)
#pragma once

#include "sample/bitfield.hpp"
#include "scene/scene.hpp"

namespace sightline {

/// All polygons of a scene in patches of at most `most` of them. Those of a patch face roughly the same way (the same
/// of the six directions along an axis) and lie near one another: groups are halved across the longest side of the box
/// of their middles until they are small enough, so that patches have at least half of `most`, rounded down, where that
/// many face the same way. The same for the same scene, always.
///
/// Laws. 1: every polygon is in one patch. 2: polygons(patches(f)) is a superset of f, and of size 1 patches f itself.
/// 3: patches(polygons(g)) = g. 4: both keep unions.
class PolygonPatches {
 public:
  /// most > 0.
  PolygonPatches(const Scene& scene, std::uint32_t most);

  std::uint32_t size() const { return static_cast<std::uint32_t>(first_.size()) - 1; }
  std::uint32_t patch_of(PolygonId p) const { return patch_of_[p]; }
  /// Ascending.
  std::span<const PolygonId> members(std::uint32_t patch) const {
    return std::span(members_).subspan(first_[patch], first_[patch + 1] - first_[patch]);
  }
  /// The patches of which a polygon is set.
  IdBitfield patches(const IdBitfield& polygons) const;
  /// All polygons of the patches that are set.
  IdBitfield polygons(const IdBitfield& patches) const;

 private:
  std::vector<std::uint32_t> first_{0};
  std::vector<PolygonId> members_;
  std::vector<std::uint32_t> patch_of_;
};

}  // namespace sightline
