// Beams traced through the winged-pair: from a camera to its visibility map.
#pragma once

#include <memory>

#include "visibility_map/map.hpp"
#include "winged_pair/complex.hpp"

namespace sightline {

/// Counts of one map, as in the paper's table 2.
struct TraceStats {
  double seconds = 0;  // from the camera to the finished map in memory
  std::uint32_t beams = 0;
  std::uint32_t cells = 0;  // distinct cells that a beam entered
  std::uint32_t fragments = 0;
  std::uint32_t faces = 0, edges = 0, vertices = 0;
};

/// Engine `cells` (Funkhouser 1999, section 4): beams go depth first through transparent faces, trimmed by each.
///
/// Holds the buffers of a sequence of cameras: one tracer a thread. Copies share what was prepared from the complex.
/// Scene and complex must outlive it. The eye may be anywhere: inside, outside, on a polygon, edge or vertex.
/// Errors: std::invalid_argument if the camera's vectors are not finite or not linearly independent.
class Tracer {
 public:
  Tracer(const Scene& scene, const Complex& complex);
  Tracer(const Tracer& other);
  ~Tracer();

  void trace(const Camera& camera, VisibilityMap& map, TraceStats* stats = nullptr);
  /// The map of all directions around the eye: no window, see VisibilityMap::sphere.
  void trace_sphere(const glm::dvec3& eye, VisibilityMap& map, TraceStats* stats = nullptr);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sightline
