#include "photos/photo_frame.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {

PhotoFrame::PhotoFrame(const Scene& scene, const Camera& camera, int width, int height)
    : scene_(&scene), camera_(camera), width_(width), height_(height), eye_(camera.eye) {
  const Grid& grid = scene.grid();
  if (!grid.snap().empty()) {
    const GridPoint snapped = grid.point(camera.eye);
    for (int k = 0; k < 3; ++k) eye_[k] = grid.world(snapped.c[static_cast<std::size_t>(k)], k);
  }
  unit_eye_ = grid.unit(eye_);
  unit_per_world_ = 1 / std::ldexp(grid.step(), grid.unit_bits());  // a step may be the smallest of doubles
  const double determinant = glm::dot(camera.forward, glm::cross(camera.right, camera.up));
  inverse_[0] = glm::cross(camera.right, camera.up) / determinant;
  inverse_[1] = glm::cross(camera.up, camera.forward) / determinant;
  inverse_[2] = glm::cross(camera.forward, camera.right) / determinant;
}

std::optional<glm::dvec2> PhotoFrame::place(const glm::dvec3& point) const {
  const glm::dvec3 d = point - eye_;
  const double ahead = glm::dot(inverse_[0], d);
  if (!(ahead > 0)) return {};
  return glm::dvec2((0.5 + glm::dot(inverse_[1], d) / ahead) * width_,
                    (0.5 - glm::dot(inverse_[2], d) / ahead) * height_);
}

glm::dvec3 PhotoFrame::ray(const glm::dvec2& place) const {
  return camera_.forward + (place.x / width_ - 0.5) * camera_.right + (0.5 - place.y / height_) * camera_.up;
}

std::optional<glm::dvec3> PhotoFrame::on_plane(SurfaceId surface, const glm::dvec2& place) const {
  const ApproxPlane& plane = scene_->planes().approx(scene_->surfaces()[surface].plane);
  const glm::dvec3 normal(plane.n[0], plane.n[1], plane.n[2]);
  const glm::dvec3 direction = ray(place);
  const double along = (plane.d - glm::dot(normal, unit_eye_)) / (glm::dot(normal, direction) * unit_per_world_);
  if (!(along > 0) || !std::isfinite(along)) return {};
  return eye_ + along * direction;
}

}  // namespace sightline
