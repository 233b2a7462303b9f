// Surfaces before any is cut or kept: where they lie, one by one and by the block.
#pragma once

#include <algorithm>
#include <atomic>

#include "bsp/tree_frame.hpp"
#include "exact/predicates.hpp"

namespace sightline {

/// Bounds in floats that hold what they bound, with at least 2^-24 to spare: a float is within 2^-24 of a number below
/// 2, and coordinates, along a frame too, are below 1.8. Their own rounding is far below that.
struct RoundedBox {
  float low[3] = {2, 2, 2}, high[3] = {-2, -2, -2};

  void add(const glm::dvec3& least, const glm::dvec3& most) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], static_cast<float>(least[k] - 0x1p-23));
      high[k] = std::max(high[k], static_cast<float>(most[k] + 0x1p-23));
    }
  }
  void add(const RoundedBox& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
};

/// Bounds of many surfaces, or of parts of them.
struct TreeExtent {
  RoundedBox box, along;  // along the frame, where that is turned
  float spread = 0;       // at least the diagonal of the bounding box of every polygon
  void add(const TreeExtent& other) {
    box.add(other.box);
    along.add(other.along);
    spread = std::max(spread, other.spread);
  }
};

/// Surfaces of consecutive ids, from a multiple of it on, that have bounds in common: files hold together what lies
/// together, so that most planes pass a block by.
inline constexpr std::uint32_t surface_block = 64;

/// What is told of whole surfaces before any is cut or kept. Shared by all who divide nodes.
class TreeSurfaces {
 public:
  explicit TreeSurfaces(const Scene& scene);
  const Scene& scene() const { return scene_; }
  const TreeFrame& frame() const { return frame_; }
  const RoundedBox& box(SurfaceId s) const { return box_[s]; }
  /// Bounds along the frame.
  const RoundedBox& along(SurfaceId s) const { return turned_.empty() ? box_[s] : turned_[s]; }
  float area(SurfaceId s) const;
  /// At least the diagonal of the bounding box of the surface's polygon.
  float spread(SurfaceId s) const { return spread_[s]; }
  /// Of the block that the surface is in.
  const TreeExtent& block(SurfaceId s) const { return block_[s / surface_block]; }
  /// Whether all corners are points of the scene.
  bool has_points(SurfaceId s) const;
  template <class F>
  void for_corners(SurfaceId s, F&& f) const {
    const Surface& surface = scene_.surfaces()[s];
    const auto edges = scene_.edges(surface);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const PointId corner = edges[k].corner;
      f(corner != none ? scene_.points().approx(corner) : meet(surface, edges, k));
    }
  }
  std::size_t bytes() const {
    return box_.size() * (sizeof(RoundedBox) + 2 * sizeof(float)) + turned_.size() * sizeof(RoundedBox) +
           block_.size() * sizeof(TreeExtent);
  }

 private:
  glm::dvec3 meet(const Surface& surface, std::span<const SurfaceEdge> edges, std::size_t k) const;
  void find_bounds();
  void find_bounds_of_parts(SurfaceId first, SurfaceId end);

  const Scene& scene_;
  TreeFrame frame_;
  std::vector<RoundedBox> box_, turned_;
  std::vector<float> spread_;
  std::vector<TreeExtent> block_;
  std::unique_ptr<std::atomic<float>[]> area_;  // 0: not asked for yet; whoever asks finds the same
};

}  // namespace sightline
