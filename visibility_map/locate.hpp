// Point location in a map.
#pragma once

#include "visibility_map/map.hpp"

#include <memory>

namespace sightline {

/// What lies at a point of the window: a face's interior, an edge without its ends, a vertex, or nothing of the map.
struct MapPlace {
  enum Kind : std::uint8_t { outside, face, edge, vertex } kind = outside;
  std::uint32_t index = none;  // into the map's faces, edges or vertices
  bool operator==(const MapPlace&) const = default;
};

/// Finds the place of points (s,t), each taken exactly as the doubles they are, against the map's true edges and
/// vertices: not the rounded `st` but the rays in which their lines meet. Doubles decide what is clear, exact integers
/// the rest. Laws: every point of the closed window has a place other than `outside`, and no other point has; the
/// answer does not depend on how the locator divides the window.
/// Relies on a right map of the scene, with every `st` the nearest double. Errors: std::invalid_argument for a sphere
/// map, or where a line of the map is none in the scene.
class Locator {
 public:
  /// Divides the window into cells in time near linear in the edges. Map and scene must outlive the locator.
  Locator(const VisibilityMap& map, const Scene& scene);
  ~Locator();
  Locator(Locator&&) noexcept;
  Locator& operator=(Locator&&) noexcept;

  /// May be called by several threads at once.
  MapPlace at(const glm::dvec2& st) const;
  /// The same for an exact point (w, x, y), w > 0, s = 1/2 + x/w, t = 1/2 + y/w.
  MapPlace at_exact(const std::array<Integer, 3>& point) const;
  /// The face in whose interior the point lies; `none` on edges and vertices and outside.
  std::uint32_t face_at(const glm::dvec2& st) const;
  /// Edges of which some part may lie in the box (at least all that do), in no order, each once.
  std::vector<std::uint32_t> edges_near(const glm::dvec2& low, const glm::dvec2& high) const;

 private:
  struct Cells;
  std::unique_ptr<const Cells> cells_;
};

/// One query without preparation, in time linear in the edges; otherwise as Locator::at.
MapPlace locate(const VisibilityMap& map, const Scene& scene, const glm::dvec2& st);

}  // namespace sightline
