#include "docs/gallery/canvas.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>

namespace sightline::gallery {

namespace {

constexpr double nearest = 1e-3;  // of the distance of the window: what is nearer than this is cut off

}  // namespace

Canvas::Canvas(const Camera& camera, int width)
    : camera_(camera),
      width_(width),
      height_(static_cast<int>(std::lround(width * glm::length(camera.up) / glm::length(camera.right)))),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_, height_)),
      context_(cairo_create(surface_)) {
  cairo_set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
}

Canvas::~Canvas() {
  cairo_destroy(context_);
  cairo_surface_destroy(surface_);
}

void Canvas::background(Colour colour) { veil(colour, 1); }

void Canvas::veil(Colour colour, double opacity) {
  pen(colour, opacity);
  cairo_paint(context_);
}

void Canvas::reduce_colours() {
  cairo_surface_flush(surface_);
  unsigned char* data = cairo_image_surface_get_data(surface_);
  const int bytes = cairo_image_surface_get_stride(surface_) * height_;
  for (int k = 0; k < bytes; ++k) data[k] = static_cast<unsigned char>((data[k] + 8) / 17 * 17);
  cairo_surface_mark_dirty(surface_);
}

void Canvas::map(const VisibilityMap& map, const Scene& scene, const DrawOptions& options) {
  DrawOptions fitting = options;
  fitting.width = width_;
  paint_map(context_, map, scene, fitting);
}

void Canvas::pen(Colour colour, double opacity, double line_width) {
  cairo_set_source_rgba(context_, colour.r / 255.0, colour.g / 255.0, colour.b / 255.0, opacity);
  cairo_set_line_width(context_, line_width);
}

glm::dvec3 Canvas::coordinates(const glm::dvec3& p) const {
  const glm::dvec3 d = p - camera_.eye;
  const glm::dvec3 ru = glm::cross(camera_.right, camera_.up), uf = glm::cross(camera_.up, camera_.forward),
                   fr = glm::cross(camera_.forward, camera_.right);
  return glm::dvec3(glm::dot(d, ru), glm::dot(d, uf), glm::dot(d, fr)) / glm::dot(camera_.forward, ru);
}

glm::dvec2 Canvas::place(const glm::dvec3& c) const {
  return {(0.5 + c.y / c.x) * width_, (0.5 - c.z / c.x) * height_};
}

void Canvas::line(const glm::dvec3& a, const glm::dvec3& b) {
  glm::dvec3 p = coordinates(a), q = coordinates(b);
  if (p.x > q.x) std::swap(p, q);
  if (q.x <= nearest) return;
  if (p.x < nearest) p += (nearest - p.x) / (q.x - p.x) * (q - p);
  const glm::dvec2 from = place(p), to = place(q);
  cairo_move_to(context_, from.x, from.y);
  cairo_line_to(context_, to.x, to.y);
  cairo_stroke(context_);
}

void Canvas::dot(const glm::dvec3& p, double radius) {
  const glm::dvec3 c = coordinates(p);
  if (c.x <= nearest) return;
  const glm::dvec2 at = place(c);
  cairo_arc(context_, at.x, at.y, radius, 0, 2 * std::acos(-1.0));
  cairo_fill(context_);
}

void Canvas::polygon(const std::vector<glm::dvec3>& corners) {
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 c = coordinates(corner);
    if (c.x <= nearest) return cairo_new_path(context_);
    const glm::dvec2 at = place(c);
    cairo_line_to(context_, at.x, at.y);
  }
  cairo_close_path(context_);
  cairo_fill_preserve(context_);
  cairo_stroke(context_);
}

void Canvas::window_line(const glm::dvec2& a, const glm::dvec2& b) {
  cairo_move_to(context_, a.x * width_, (1 - a.y) * height_);
  cairo_line_to(context_, b.x * width_, (1 - b.y) * height_);
  cairo_stroke(context_);
}

void Canvas::write_png(const std::filesystem::path& file) const {
  if (cairo_surface_write_to_png(surface_, file.string().c_str()) != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

}  // namespace sightline::gallery
