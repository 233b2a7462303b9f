// One camera: its eye's sightlines, window and regions. For this folder's own use.
#pragma once

#include "clip/clip.hpp"
#include "exact/window.hpp"

namespace sightline {

/// A sightline with the name that sides cut by it get.
struct NamedLine {
  SightlineRef line;
  ClipSide name;
};

/// Throws std::invalid_argument if it is not strictly convex.
void check_region(const TextureRegion& region);

/// Not for two threads at once: sightlines are made on demand.
class ClipView {
 public:
  ClipView(const Scene& scene, const Camera& camera, std::uint32_t index, std::span<const TextureRegion> regions);

  /// Can the camera see this side of the surface, and does its plane miss the eye?
  bool faces(const Surface& s) {
    const Sign eye = table_.eye_side(s.plane);
    return eye != 0 && !(scene_.options().one_sided && (eye > 0) == s.flipped);
  }
  /// The wedge of an edge of a surface that faces the camera, inwards.
  SightlineRef wedge(const Surface& s, const SurfaceEdge& e) {
    const SightlineRef line = table_.of_points(e.a, e.b);
    // Seen from the front edges run counter-clockwise, and (a - eye) x (b - eye) points outwards.
    return table_.eye_side(s.plane) > 0 ? -line : line;
  }
  /// Sides of the window and of interior regions, inwards: what is seen lies inside of all.
  std::span<const NamedLine> frame() const { return frame_; }
  /// Exterior regions: sides inwards; what lies inside of all is not seen.
  std::span<const std::vector<NamedLine>> holes() const { return holes_; }

  /// The line of the window or of a region that a side is named after.
  SightlineRef named(const ClipSide& side) const;

  const Window& window() const { return window_; }
  SightlineTable& table() { return table_; }
  const SightlineTable& table() const { return table_; }
  const Scene& scene() const { return scene_; }
  const Camera& camera() const { return camera_; }
  std::uint32_t index() const { return index_; }

 private:
  std::vector<NamedLine> sides_of(const TextureRegion& region, std::uint32_t index);

  const Scene& scene_;
  Camera camera_;
  std::uint32_t index_;
  Window window_;
  SightlineTable table_;
  std::vector<NamedLine> frame_;
  std::vector<std::vector<NamedLine>> holes_;
};

}  // namespace sightline
