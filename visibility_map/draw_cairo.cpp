#include "scene/read.hpp"
#include "visibility_map/draw.hpp"
#include "visibility_map/query.hpp"
#include "visibility_map/write_text.hpp"

#include <cairo-pdf.h>
#include <cairo.h>

#include <memory>
#include <new>
#include <stdexcept>

namespace sightline {

namespace {

struct Release {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Canvas = std::unique_ptr<cairo_surface_t, Release>;

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
  try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;  // an exception may not pass through C
  }
}

void set_colour(cairo_t* context, Colour c, double opacity = 1) {
  cairo_set_source_rgba(context, c.r / 255.0, c.g / 255.0, c.b / 255.0, opacity);
}

void paint(cairo_surface_t* surface, const VisibilityMap& map, const Scene& scene, const DrawOptions& options,
           std::span<const DrawnPatch> patches = {}) {
  const std::unique_ptr<cairo_t, Release> context(cairo_create(surface));
  paint_map(context.get(), map, scene, options, patches);
  check(cairo_status(context.get()));
}

}  // namespace

void paint_map(cairo_t* context, const VisibilityMap& map, const Scene& scene, const DrawOptions& options,
               std::span<const DrawnPatch> patches) {
  const Drawing drawing(map, scene, options);
  cairo_save(context);
  cairo_rectangle(context, 0, 0, drawing.width(), drawing.height());
  cairo_clip(context);
  set_colour(context, Drawing::paper);
  cairo_paint(context);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);

  const auto go = [&](std::uint32_t vertex, auto step) {
    const glm::dvec2 place = drawing.place(map.vertices[vertex].st);
    step(context, place.x, place.y);
  };
  const auto fill = [&](Colour colour) {
    set_colour(context, colour);
    cairo_fill_preserve(context);
    cairo_set_line_width(context, Drawing::seal);
    cairo_stroke(context);
  };
  for (const DrawnPatch& patch : patches) {
    cairo_new_path(context);
    for (const glm::dvec2& st : patch.st) {
      const glm::dvec2 place = drawing.place(st);
      cairo_line_to(context, place.x, place.y);
    }
    cairo_close_path(context);
    fill(patch.colour);
  }
  for (const MapFace& face : map.faces) {
    if (options.fill == DrawOptions::Fill::empty || !patches.empty()) break;
    cairo_new_path(context);
    for (std::uint32_t k = 0; k < face.loop_count; ++k) {
      cairo_new_sub_path(context);
      for (const std::int32_t e : map.loop(face.first_loop + k)) go(start_vertex(map, e), cairo_line_to);
      cairo_close_path(context);
    }
    fill(drawing.fill(face));
  }
  for (const EdgeKind kind :
       {EdgeKind::seam, EdgeKind::crease, EdgeKind::intersection, EdgeKind::silhouette, EdgeKind::window}) {
    if (!drawing.drawn(kind)) continue;
    const Stroke stroke = drawing.stroke(kind);
    set_colour(context, stroke.colour, stroke.opacity);
    cairo_set_line_width(context, stroke.width);
    for (const MapEdge& edge : map.edges) {
      if (edge.kind != kind) continue;
      go(edge.vertex[0], cairo_move_to);
      go(edge.vertex[1], cairo_line_to);
      cairo_stroke(context);
    }
  }
  cairo_restore(context);
}

void write_map_png(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene, int width) {
  write_map_png(file, map, scene, DrawOptions{.width = width});
}

void write_map_png(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene,
                   const DrawOptions& options) {
  write_patches_png(file, {}, map, scene, options);
}

void write_patches_png(const std::filesystem::path& file, std::span<const DrawnPatch> patches, const VisibilityMap& map,
                       const Scene& scene, const DrawOptions& options) {
  const Drawing drawing(map, scene, options);
  const Canvas surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, drawing.width(), drawing.height()));
  check(cairo_surface_status(surface.get()));
  paint(surface.get(), map, scene, options, patches);
  std::string content;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &content));
  write_file(file, content);
}

void write_map_pdf(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene, int width) {
  write_map_pdf(file, map, scene, DrawOptions{.width = width});
}

void write_map_pdf(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene,
                   const DrawOptions& options) {
  const Drawing drawing(map, scene, options);
  std::string content;
  {
    const Canvas surface(cairo_pdf_surface_create_for_stream(append, &content, drawing.width(), drawing.height()));
    check(cairo_surface_status(surface.get()));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, text::utf8(scene.soup().source).c_str());
    // The time of writing is left out, so that the same map gives the same file.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    paint(surface.get(), map, scene, options);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
  }
  write_file(file, content);
}

}  // namespace sightline
