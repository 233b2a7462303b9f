#include "photos/image.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>

#include "scene/readers.hpp"

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

Canvas canvas(int width, int height) {
  Canvas surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  check(cairo_surface_status(surface.get()));
  return surface;
}

/// A row of cairo's pixels: a native 32-bit word each, alpha, red, green, blue from the top bits down.
unsigned char* row(cairo_surface_t* surface, int j) {
  return cairo_image_surface_get_data(surface) + std::ptrdiff_t{j} * cairo_image_surface_get_stride(surface);
}

cairo_status_t take(void* rest, unsigned char* data, unsigned length) {
  auto& bytes = *static_cast<std::string_view*>(rest);
  if (bytes.size() < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, bytes.data(), length);
  bytes.remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
  try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;  // an exception may not pass through C
  }
}

}  // namespace

std::array<std::uint8_t, 3> stored(const glm::dvec3& colour) {
  std::array<std::uint8_t, 3> c{};
  for (int k = 0; k < 3; ++k) {
    c[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(std::clamp(colour[k], 0.0, 255.0)));
  }
  return c;
}

Image parse_png(std::string_view bytes, const std::string& name) {
  const Canvas read(cairo_image_surface_create_from_png_stream(take, &bytes));
  const cairo_status_t status = cairo_surface_status(read.get());
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw InputError(name + ": no whole PNG image");
  Image image(cairo_image_surface_get_width(read.get()), cairo_image_surface_get_height(read.get()));
  // Painting turns whatever cairo read into one format.
  const Canvas surface = canvas(image.width, image.height);
  const std::unique_ptr<cairo_t, Release> context(cairo_create(surface.get()));
  cairo_set_operator(context.get(), CAIRO_OPERATOR_SOURCE);
  cairo_set_source_surface(context.get(), read.get(), 0, 0);
  cairo_paint(context.get());
  check(cairo_status(context.get()));
  cairo_surface_flush(surface.get());
  for (int j = 0; j < image.height; ++j) {
    const unsigned char* from = row(surface.get(), j);
    for (int i = 0; i < image.width; ++i, from += 4) {
      std::uint32_t word;
      std::memcpy(&word, from, sizeof word);
      if (word >> 24 != 255) throw InputError(name + ": the image is transparent in places");
      image.at(i, j) = {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
                        static_cast<std::uint8_t>(word)};
    }
  }
  return image;
}

Image read_png(const std::filesystem::path& file) { return parse_png(load_file(file.string()), file.string()); }

std::string png(const Image& image) {
  constexpr int most = 32767;  // cairo's limit
  if (image.width < 1 || image.height < 1 || image.width > most || image.height > most) {
    throw std::invalid_argument("an image's sides must be from 1 to 32767 pixels");
  }
  // RGB24 keeps alpha out of the file.
  const Canvas surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
  check(cairo_surface_status(surface.get()));
  for (int j = 0; j < image.height; ++j) {
    unsigned char* to = row(surface.get(), j);
    for (int i = 0; i < image.width; ++i, to += 4) {
      const auto& c = image.at(i, j);
      const std::uint32_t word = std::uint32_t{c[0]} << 16 | std::uint32_t{c[1]} << 8 | c[2];
      std::memcpy(to, &word, sizeof word);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  std::string content;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &content));
  return content;
}

}  // namespace sightline
