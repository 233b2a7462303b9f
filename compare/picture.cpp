// The picture of a comparison: run time against error.
#include "compare/axis.hpp"
#include "compare/report.hpp"
#include "scene/read.hpp"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

namespace sightline::comparison {
namespace {

struct Release {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

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

constexpr double page_width = 1080, page_height = 500, panel_width = 410, panel_height = 360, top = 70;

struct Colour {
  double r, g, b;
};
constexpr Colour ink{0.13, 0.13, 0.13}, faint{0.86, 0.85, 0.82}, paper{0.98, 0.976, 0.965};
constexpr std::array<Colour, 8> colours{{{0.07, 0.07, 0.07},
                                         {0.78, 0.06, 0.18},
                                         {0.16, 0.42, 0.69},
                                         {0.31, 0.62, 0.27},
                                         {0.90, 0.56, 0.12},
                                         {0.48, 0.35, 0.69},
                                         {0.16, 0.61, 0.56},
                                         {0.55, 0.38, 0.24}}};

/// A point a method and setting; those of one kind have one colour and a line through them.
struct Point {
  std::string kind, label;
  double seconds, error;
};

/// A place that something has been drawn at.
struct Box {
  double left, top, width, height;
  bool meets(const Box& o) const {
    return left < o.left + o.width && o.left < left + width && top < o.top + o.height && o.top < top + height;
  }
};

class Painter {
 public:
  explicit Painter(cairo_t* context) : c_(context) {
    cairo_select_font_face(c_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
    use(paper);
    cairo_paint(c_);
  }

  /// `along` and `up`: 0 begins at the place, 1/2 is in its middle, 1 ends there.
  void text(double x, double y, const std::string& words, double along, double size = 12) {
    cairo_set_font_size(c_, size);
    cairo_text_extents_t extents;
    cairo_text_extents(c_, words.c_str(), &extents);
    cairo_move_to(c_, x - along * extents.x_advance, y);
    cairo_show_text(c_, words.c_str());
  }

  void panel(double left, const std::string& title, const std::vector<Point>& points) {
    std::vector<double> times, errors;
    for (const Point& p : points) {
      times.push_back(p.seconds * 1e3);
      errors.push_back(p.error);
    }
    const LogAxis across(times, false, 2), upwards(errors, true, 2);
    const auto x = [&](double at) { return left + at * panel_width; };
    const auto y = [&](double at) { return top + (1 - at) * panel_height; };
    cairo_set_line_width(c_, 1);
    for (const Tick& tick : across.ticks()) {
      line(x(tick.at), y(0), x(tick.at), y(1), faint);
      use(ink);
      text(x(tick.at), y(0) + 20, tick.text, 0.5, 11);
    }
    for (const Tick& tick : upwards.ticks()) {
      line(x(0), y(tick.at), x(1), y(tick.at), faint);
      use(ink);
      text(x(0) - 8, y(tick.at) + 4, tick.text, 1, 11);
    }
    line(x(0), y(0), x(1), y(0), ink);
    line(x(0), y(0), x(0), y(1), ink);
    use(ink);
    text(left, top - 16, title, 0, 13);
    text(x(0.5), y(0) + 40, "milliseconds a view (median, one thread)", 0.5, 12);

    std::vector<Box> taken;
    for (std::size_t k = 0; k < kinds().size(); ++k) {
      const Colour colour = colours[k % colours.size()];
      use(colour);
      cairo_set_line_width(c_, 1.5);
      cairo_new_path(c_);
      for (const Point& p : points) {
        if (p.kind == kinds()[k].name) cairo_line_to(c_, x(across.place(p.seconds * 1e3)), y(upwards.place(p.error)));
      }
      cairo_stroke(c_);
      for (const Point& p : points) {
        if (p.kind != kinds()[k].name) continue;
        const double at = x(across.place(p.seconds * 1e3)), height = y(upwards.place(p.error));
        cairo_arc(c_, at, height, 4.5, 0, 2 * std::acos(-1.0));
        cairo_fill(c_);
        taken.push_back({at - 5, height - 5, 10, 10});
      }
    }
    for (const Point& p : points) {
      const auto kind = std::ranges::find(kinds(), p.kind, &Kind::name) - kinds().begin();
      use(colours[static_cast<std::size_t>(kind) % colours.size()]);
      label(x(across.place(p.seconds * 1e3)), y(upwards.place(p.error)), p.label, x(1), taken);
    }
  }

 private:
  void use(Colour c) { cairo_set_source_rgb(c_, c.r, c.g, c.b); }
  void line(double x0, double y0, double x1, double y1, Colour colour) {
    use(colour);
    cairo_move_to(c_, x0, y0);
    cairo_line_to(c_, x1, y1);
    cairo_stroke(c_);
  }
  /// Beside its point, on the side where there is room, above or below what is there already.
  void label(double x, double y, const std::string& words, double right, std::vector<Box>& taken) {
    cairo_set_font_size(c_, 11);
    cairo_text_extents_t extents;
    cairo_text_extents(c_, words.c_str(), &extents);
    const double width = extents.x_advance, from = x + 8 + width > right + 40 ? x - 8 - width : x + 8;
    Box box{from, 0, width, 10};
    for (const double move : {-6, 15, -18, 27, -30, 39, -42}) {
      box.top = y + move - 9;
      if (std::ranges::none_of(taken, [&](const Box& t) { return t.meets(box); })) break;
    }
    taken.push_back(box);
    cairo_move_to(c_, from, box.top + 9);
    cairo_text_path(c_, words.c_str());
    cairo_path_t* const path = cairo_copy_path(c_);
    cairo_save(c_);
    use(paper);
    cairo_set_line_width(c_, 3);
    cairo_stroke(c_);
    cairo_restore(c_);
    cairo_append_path(c_, path);
    cairo_path_destroy(path);
    cairo_fill(c_);
  }

  cairo_t* c_;
};

void paint(cairo_surface_t* surface, std::span<const MethodResult> methods, const std::string& title) {
  check(cairo_surface_status(surface));
  const std::unique_ptr<cairo_t, Release> context(cairo_create(surface));
  std::vector<Point> areas, counts;
  for (const MethodResult& m : methods) {
    const Summary s = summary_of(m);
    if (!std::isfinite(s.seconds)) continue;  // it failed everywhere
    const std::string kind = m.name.substr(0, m.name.find(':'));
    areas.push_back({kind, m.name, s.seconds, s.wrong_area});
    counts.push_back({kind, m.name, s.seconds, s.missed + s.falsely});
  }
  Painter painter(context.get());
  painter.panel(80, "wrong part of the window, mean", areas);
  painter.panel(610, "polygons missed or falsely reported, mean of a view", counts);
  cairo_set_source_rgb(context.get(), ink.r, ink.g, ink.b);
  painter.text(80, 28, title, 0, 15);
  check(cairo_status(context.get()));
}

}  // namespace

void write_picture(const std::filesystem::path& path, std::span<const MethodResult> methods, const std::string& title) {
  std::string svg, png;
  {
    const std::unique_ptr<cairo_surface_t, Release> surface(
        cairo_svg_surface_create_for_stream(append, &svg, page_width, page_height));
    paint(surface.get(), methods, title);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
  }
  const std::unique_ptr<cairo_surface_t, Release> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(page_width), static_cast<int>(page_height)));
  paint(surface.get(), methods, title);
  check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  write_file(path.string() + ".svg", svg);
  write_file(path.string() + ".png", png);
}

}  // namespace sightline::comparison
