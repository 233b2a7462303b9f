// A picture of a camera's view, drawn on with lines, dots and polygons of the world.
#pragma once

#include "scene/camera.hpp"
#include "visibility_map/draw.hpp"

#include <cairo.h>

#include <filesystem>

namespace sightline::gallery {

class Canvas {
 public:
  Canvas(const Camera& camera, int width);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  ~Canvas();

  void background(Colour colour);
  /// A thin coat over all that is there.
  void veil(Colour colour, double opacity);
  void map(const VisibilityMap& map, const Scene& scene, const DrawOptions& options);
  /// A line of the world, clipped to what lies before the eye.
  void line(const glm::dvec3& a, const glm::dvec3& b);
  void dot(const glm::dvec3& p, double radius);
  void polygon(const std::vector<glm::dvec3>& corners);
  /// Lines of the window.
  void window_line(const glm::dvec2& a, const glm::dvec2& b);
  /// What the calls above draw with.
  void pen(Colour colour, double opacity = 1, double line_width = 1);
  /// Rounds colours to sixteen levels a channel: fine lines make large files otherwise.
  void reduce_colours();
  /// Throws std::runtime_error if it cannot be written.
  void write_png(const std::filesystem::path& file) const;

 private:
  /// (w, x, y): p - eye = w forward + x right + y up.
  glm::dvec3 coordinates(const glm::dvec3& p) const;
  glm::dvec2 place(const glm::dvec3& coordinates) const;

  Camera camera_;
  int width_, height_;
  cairo_surface_t* surface_;
  cairo_t* context_;
};

}  // namespace sightline::gallery
