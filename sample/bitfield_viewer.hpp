// From samples to the polygons to render for a viewer. (Meruvia and Strothotte, section 3.2.)
#pragma once

#include "sample/bitfield_forms.hpp"
#include "sample/bitfield_hull.hpp"
#include "sample/bitfield_patches.hpp"
#include "sample/bitfield_samples.hpp"

#include <optional>

namespace sightline {

struct BitfieldViewing {
  /// Samples that are joined: the three at the corners of the hull's face that holds the viewer (3), also the three
  /// across its edges (6), or that one of the three that is nearest by angle (1).
  unsigned neighbours = 6;
  /// `lists`: a list of polygons for each face, made beforehand, so that a query looks nothing up but the face. Else
  /// the fields are joined for every query, in one of their forms.
  enum Form : std::uint8_t { lists, plain, hierarchical, compressed } form = lists;
  unsigned threads = 1;  // that make the lists
};

/// Laws. 1: of 1, 3 and 6 neighbours each gives a superset of the one before. 2: all forms give the same, but `lists`
/// do not know of one neighbour. 3: where samples are exact, a camera that is a sample's gets that sample alone: just
/// what it sees. 4: threads change nothing.
class BitfieldViewer {
 public:
  struct View {
    std::uint32_t face = none;            // of the hull; none: the camera is that of an exact sample
    std::vector<std::uint32_t> samples;   // that were joined, ascending
    std::span<const PolygonId> polygons;  // ascending; valid until the next call
  };

  /// `scene` is that of the samples, and needed only where a bit is a patch. Throws std::invalid_argument where the
  /// samples' viewpoints do not surround the centre, for a number of neighbours that is none of 1, 3 and 6, or is 1
  /// with lists, and for patches without their scene.
  BitfieldViewer(BitfieldSamples samples, const BitfieldViewing& options, const Scene* scene = nullptr);

  /// Only the camera's eye counts, but where the camera is that of an exact sample.
  const View& look(const Camera& camera);

  const ViewHull& hull() const { return hull_; }
  const BitfieldSamples& samples() const { return samples_; }
  /// Of the lists or of the fields in their form.
  std::size_t bytes() const;
  /// Polygons to render, on the average over all faces of the hull: what is left of the model.
  double mean_list() const;

 private:
  /// Those that are joined for a viewer in that direction within the face.
  std::vector<std::uint32_t> samples_around(std::uint32_t face, const ViewDirection& direction) const;
  IdBitfield joined(std::span<const std::uint32_t> samples) const;
  std::vector<PolygonId> list_of(std::span<const std::uint32_t> samples) const;
  void make_lists();

  BitfieldSamples samples_;
  BitfieldViewing options_;
  ViewHull hull_;
  std::optional<PolygonPatches> patches_;
  std::vector<std::vector<std::uint32_t>> at_corner_;  // samples by the corner of the hull nearest to their direction
  std::vector<HierarchicalBitfield> hierarchical_;
  std::vector<CompressedBitfield> compressed_;
  std::vector<std::vector<PolygonId>> lists_;  // by face
  std::vector<PolygonId> list_;
  View view_;
};

}  // namespace sightline
