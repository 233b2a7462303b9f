// From fragments to the map: seams dissolved, edges maximal, everything named by the drawing alone.
#pragma once

#include "visibility_map/fragment.hpp"
#include "visibility_map/map.hpp"

namespace sightline {

/// Buffers that a sequence of maps reuses.
class Stitcher {
 public:
  Stitcher();
  ~Stitcher();
  Stitcher(Stitcher&&) noexcept;
  Stitcher& operator=(Stitcher&&) noexcept;

  /// The map of fragments that tile the camera's window. `table` holds their sightlines and the camera's eye.
  void stitch(const Scene& scene, const Camera& camera, SightlineTable& table, const Fragments& fragments,
              VisibilityMap& map);
  /// The map of fragments that tile the sphere of directions.
  void stitch_sphere(const Scene& scene, const glm::dvec3& eye, SightlineTable& table, const Fragments& fragments,
                     VisibilityMap& map);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace sightline
