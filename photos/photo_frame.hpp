// Where a camera's photograph shows the points of a scene, and what lies behind its pixels.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sightline {

/// In doubles: good for colours; what is seen where is never decided here. Laws, to rounding. 1: the place of a point
/// along ray(place) is that place, for the whole photograph and beyond. 2: on_plane(surface, place) lies in the
/// surface's plane and has that place.
class PhotoFrame {
 public:
  /// A photograph of width x height pixels that fills the camera's window. Under a snap the eye is the snapped one.
  PhotoFrame(const Scene& scene, const Camera& camera, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  const glm::dvec3& eye() const { return eye_; }
  /// The place of a point in pixels, within the photograph or not; nothing where it is not before the eye.
  std::optional<glm::dvec2> place(const glm::dvec3& point) const;
  /// The direction in which a place is seen, its forward part the camera's `forward`.
  glm::dvec3 ray(const glm::dvec2& place) const;
  /// The point of the surface's plane that is seen at a place; nothing where the plane lies behind the eye there.
  std::optional<glm::dvec3> on_plane(SurfaceId surface, const glm::dvec2& place) const;

 private:
  const Scene* scene_;
  Camera camera_;
  int width_, height_;
  glm::dvec3 eye_;
  glm::dvec3 unit_eye_;
  double unit_per_world_;
  glm::dvec3 inverse_[3];  // rows: along forward, right and up
};

}  // namespace sightline
