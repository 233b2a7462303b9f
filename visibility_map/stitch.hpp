// From fragments to the map: seams dissolved, edges maximal, everything named by the drawing alone.
#pragma once

#include "exact/window.hpp"
#include "visibility_map/fragment.hpp"
#include "visibility_map/map.hpp"

#include <array>
#include <memory>

namespace sightline {

/// How much of a window a polygon takes up.
struct PolygonArea {
  PolygonId polygon;  // none: nothing is hit
  double area;        // part of the window
};

/// Makes maps, one after the other; keeps its buffers, so that nothing is allocated once they have grown. The map is
/// the canonical one of docs/map.md. Its laws: it does not depend on how the fragments cut up the faces, nor on their
/// order; the areas of a window's faces sum to 1, the solid angles of a sphere's to 4 pi; a mirrored camera gives the
/// map of the camera it mirrors with s replaced by 1 - s. Throws std::logic_error where the fragments overlap, leave a
/// gap or are not of this scene. Not for two threads at once.
class Stitcher {
 public:
  Stitcher();
  ~Stitcher();
  Stitcher(Stitcher&&) noexcept;
  Stitcher& operator=(Stitcher&&) noexcept;

  /// The map of fragments that tile the camera's window. `table` holds their sightlines and the camera's eye.
  void stitch(const Scene& scene, const Camera& camera, SightlineTable& table, const Fragments& fragments,
              VisibilityMap& map);
  /// The same for a tracer that has made the camera's window and its four sides (by Window::Side) already.
  void stitch(const Scene& scene, const Camera& camera, const Window& window, const std::array<SightlineRef, 4>& border,
              SightlineTable& table, const Fragments& fragments, VisibilityMap& map);
  /// Only how much of the window each polygon takes up, `none` for where nothing is seen: ascending by polygon. Summed
  /// over fragments instead of faces, in twice the precision of doubles, from corners that are rounded to the nearest
  /// double: within 2^-52 for every side of a fragment.
  void areas(const Scene& scene, const Camera& camera, const Window& window, const std::array<SightlineRef, 4>& border,
             SightlineTable& table, const Fragments& fragments, std::vector<PolygonArea>& areas);
  /// The map of fragments that tile the sphere of directions.
  void stitch_sphere(const Scene& scene, const glm::dvec3& eye, SightlineTable& table, const Fragments& fragments,
                     VisibilityMap& map);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace sightline
