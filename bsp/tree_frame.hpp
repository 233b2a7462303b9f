// The directions along which a scene lies.
#pragma once

#include <glm/geometric.hpp>

#include "scene/scene.hpp"

namespace sightline {

/// Three directions at right angles, those of most of the scene's surface: the axes, or others where the scene has been
/// turned against them. Only a measure of where parts of surfaces lie: boxes along these directions are close.
class TreeFrame {
 public:
  explicit TreeFrame(const Scene& scene);
  bool turned() const { return turned_; }
  /// Of unit length but for rounding; exactly along axis k if not turned.
  const glm::dvec3& direction(int k) const { return direction_[k]; }
  glm::dvec3 of(const glm::dvec3& p) const {
    return {glm::dot(direction_[0], p), glm::dot(direction_[1], p), glm::dot(direction_[2], p)};
  }

 private:
  glm::dvec3 direction_[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  bool turned_ = false;
};

}  // namespace sightline
