// Beams traced through the winged-pair: from a camera to its visibility map.
#pragma once

#include <limits>
#include <memory>

#include "bsp/tree.hpp"
#include "visibility_map/map.hpp"
#include "visibility_map/stitch.hpp"
#include "winged_pair/complex.hpp"

namespace sightline {

/// Counts of one map, as in the paper's table 2.
struct TraceStats {
  double seconds = 0;       // from the camera to the finished map in memory
  std::uint32_t beams = 0;  // cells: beams in cells; front-to-back: beams that end on a polygon or nowhere
  std::uint32_t cells = 0;  // cells: distinct cells that a beam entered; front-to-back: nodes visited
  std::uint32_t fragments = 0;
  std::uint32_t faces = 0, edges = 0, vertices = 0;
  double left_out = 0;  // TraceOptions::min_angle: a proven bound on the part of the window (sphere: steradians)
};

struct TraceOptions {
  /// Radians, 0 to 0.01. Parts of the view that lie between two lines closer than this, once all that is nearer has
  /// been taken out of it, are not followed: nothing is seen in them. TraceStats::left_out bounds how much that is. 0:
  /// all is followed, and the map exact.
  double min_angle = 0;
  /// In the scene's units, positive. Polygons whose bounding box (along the axes) is farther from the eye, exactly, are
  /// left out: the map is that of the scene without them.
  double max_distance = std::numeric_limits<double>::infinity();
  /// That share the work of one camera, by parts of its window, or of one sphere; the map is the same for any number.
  /// For few cameras of many faces: tracers on threads of their own are faster for many cameras.
  unsigned threads = 1;
};

/// Makes visibility maps by one of two engines, which give the same map, to the byte: `front-to-back` on a tree of the
/// scene's polygons, the faster one, and `cells` (Funkhouser 1999, section 4) on the winged-pair complex.
///
/// Holds the buffers of a sequence of cameras: one tracer a thread. Copies share what was prepared. Scene and complex,
/// or tree, must outlive it. The eye may be anywhere: inside, outside, on a polygon, edge or vertex.
/// Errors: std::invalid_argument if the camera's vectors are not finite or not linearly independent, or an option is
/// out of range.
class Tracer {
 public:
  explicit Tracer(const BspTree& tree, const TraceOptions& options = {});                // front-to-back
  Tracer(const Scene& scene, const Complex& complex, const TraceOptions& options = {});  // cells, without min_angle
  Tracer(const Tracer& other);
  ~Tracer();

  void trace(const Camera& camera, VisibilityMap& map, TraceStats* stats = nullptr);
  /// Only which polygons are seen, ascending: those of the map's faces. No map is put together, which is half the work.
  void visible(const Camera& camera, std::vector<PolygonId>& polygons, TraceStats* stats = nullptr);
  /// Only how much of the window each polygon takes up, ascending by polygon, `none` for where nothing is seen, each to
  /// within 2^-52 for every side of its fragments.
  void areas(const Camera& camera, std::vector<PolygonArea>& areas, TraceStats* stats = nullptr);
  /// The map of all directions around the eye: no window, see VisibilityMap::sphere.
  void trace_sphere(const glm::dvec3& eye, VisibilityMap& map, TraceStats* stats = nullptr);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sightline
