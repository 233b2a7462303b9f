// One surface after the other, against all cameras. For this folder's own use.
#pragma once

#include <algorithm>
#include <deque>

#include "clip/carve.hpp"
#include "clip/cover_buffer.hpp"

namespace sightline {

/// Which cameras see all of a piece, and which some.
struct CameraSet {
  std::vector<std::uint64_t> words;
  explicit CameraSet(std::size_t cameras) : words((cameras + 63) / 64, 0) {}
  void add(std::size_t camera) { words[camera / 64] |= std::uint64_t{1} << (camera % 64); }
  bool has(std::size_t camera) const { return (words[camera / 64] >> (camera % 64) & 1) != 0; }
  bool any() const {
    return std::any_of(words.begin(), words.end(), [](std::uint64_t w) { return w != 0; });
  }
  bool operator==(const CameraSet&) const = default;
};

struct SurfacePiece {
  Outline outline;
  CameraSet wholly, partly;
  bool fresh = true;  // cut by the latest camera
};

/// The finished pieces of one surface.
struct ClippedSurface {
  std::vector<ClipCorner> corners;
  struct Piece {
    std::uint32_t corner_count;
    CameraSet wholly, partly;
  };
  std::vector<Piece> pieces;
};

/// Of one thread: has sightlines of its own for every camera.
class SurfaceClipper {
 public:
  /// A buffer for every camera.
  SurfaceClipper(const Scene& scene, const BoxTree& tree, std::span<const Camera> cameras,
                 std::span<const CoverBuffer> buffers, const ClipOptions& options);
  ClippedSurface clip(SurfaceId surface);
  const ClipStats& stats() const { return stats_; }

 private:
  bool hidden(const CoverBuffer& buffer, const Outline& outline, PlaneId plane, bool backwards);
  void finish(std::vector<SurfacePiece>& pieces, Outlines& outlines, ClippedSurface& out) const;

  const Scene& scene_;
  std::span<const CoverBuffer> buffers_;
  std::deque<ClipView> views_;
  ShadowFinder finder_;
  bool sampling_;
  double threshold_;  // in unit coordinates
  ClipStats stats_;
};

/// Unites pieces that the same cameras see where two make a convex one. Only pairs are tried of which one is `fresh`.
void unite(std::vector<SurfacePiece>& pieces, Outlines& outlines);

}  // namespace sightline
