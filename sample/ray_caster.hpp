// Which polygon a ray hits first, in floats: Embree's answer, fast and not exact.
#pragma once

#include "scene/scene.hpp"

#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <span>

namespace sightline {

/// origin + t direction for 0 <= t <= length, in unit coordinates (see Grid).
struct Ray {
  glm::vec3 origin, direction;
  float length = std::numeric_limits<float>::infinity();
};
struct RayHit {
  PolygonId polygon = none;  // `none`: nothing is hit
  float distance = 0;        // t of the hit
};

/// A scene's polygons in Embree's tree. Where the scene is one-sided, backs are not hit. Safe with many threads. Throws
/// std::runtime_error when Embree gives no device.
class RayCaster {
 public:
  explicit RayCaster(const Scene& scene);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// hits[k] is ray k's; both have the same length, and 16 rays at a time are followed together.
  /// `coherent`: neighbours run nearly alike, as those of a block of pixels do. A ray with a number that is none or
  /// beyond 1.8e18 hits nothing.
  void cast(std::span<const Ray> rays, std::span<RayHit> hits, bool coherent) const;
  /// Memory that the tree takes.
  std::size_t bytes() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace sightline
