// Where a window shows nothing. For this folder's own use.
#pragma once

#include "clip/short_list.hpp"
#include "clip/view.hpp"
#include "visibility_map/fragment.hpp"

namespace sightline {

/// Finds the parts of a window in which none of a list of surfaces is seen. The window is halved, by whatever lines
/// keep the lists short, until few surfaces are left, and then cut by these, as Carver does with polygons; what is
/// decided is decided exactly.
class Sky {
 public:
  /// Appends those parts to the fragments, convex each. All surfaces must face the camera.
  void fill(ClipView& view, std::span<const SurfaceId> surfaces, Fragments& fragments);

 private:
  /// Sides counter-clockwise as the eye sees them, inwards.
  using Region = ShortList<SightlineRef, 8>;
  /// What is seen of a surface. Its scene points are empty if one of its corners is none.
  struct Cone {
    std::uint32_t first_line, line_count, first_point, point_count;
    glm::dvec2 middle;  // about, in the frame
  };
  enum class Place { apart, meets, all };

  void add_cone(SurfaceId surface);
  void divide(const Region& region, std::span<const std::uint32_t> cones, int halvings);
  bool halve(const Region& region, std::vector<std::uint32_t>& cones, Region& front, Region& behind);
  Place place(const Region& region, const Cone& cone);
  int sides(const Region& region, SightlineRef line);
  void split(const Region& region, SightlineRef line, Region& front, Region& behind) const;

  ClipView* view_ = nullptr;
  Fragments* fragments_ = nullptr;
  glm::dvec3 frame_[3];  // normals: their products with a ray are as (s - 1/2) : (t - 1/2) : 1
  std::vector<Cone> cones_;
  std::vector<SightlineRef> lines_;
  std::vector<PointId> points_;
  std::vector<std::int8_t> sign_;  // of a region's corners, for split()
};

}  // namespace sightline
