// Visibility maps by clipping: the engine `hybrid`.
#pragma once

#include <memory>

#include "scene/camera.hpp"
#include "visibility_map/map.hpp"

namespace sightline {

/// Counts of one map.
struct HybridStats {
  double seconds = 0;          // from the camera to the finished map in memory
  std::uint32_t surfaces = 0;  // looked at: those that may reach into the window
  std::uint32_t pieces = 0;    // seen, and parts of the window that see nothing
  std::uint32_t faces = 0, edges = 0, vertices = 0;
};

/// Makes the map of a camera from the pieces into which clip() would cut the polygons for this one camera: the same map
/// as a Tracer's, to the byte. It needs no tree of the scene and no complex, only boxes around its surfaces.
///
/// Holds the buffers of a sequence of cameras: one a thread. Copies share what was prepared. The scene must outlive it.
/// Errors: std::invalid_argument if the camera's vectors are not finite or not linearly independent.
class HybridTracer {
 public:
  /// `buffer`: pixels along a side of the buffer, as ClipOptions::buffer; 0: chosen. No map depends on it.
  explicit HybridTracer(const Scene& scene, int buffer = 0);
  HybridTracer(const HybridTracer& other);
  ~HybridTracer();

  void trace(const Camera& camera, VisibilityMap& map, HybridStats* stats = nullptr);
  /// Memory held by the boxes, which all copies share.
  std::size_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sightline
