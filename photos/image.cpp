#include "photos/image.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "scene/readers.hpp"

namespace sightline {

namespace {

/// libpng's state for one image, freed whatever happens.
struct PngState : png_image {
  PngState() : png_image{} { version = PNG_IMAGE_VERSION; }
  ~PngState() { png_image_free(this); }
  PngState(const PngState&) = delete;
  PngState& operator=(const PngState&) = delete;
};

}  // namespace

std::array<std::uint8_t, 3> stored(const glm::dvec3& colour) {
  std::array<std::uint8_t, 3> c{};
  for (int k = 0; k < 3; ++k) {
    c[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(std::clamp(colour[k], 0.0, 255.0)));
  }
  return c;
}

Image parse_png(std::string_view bytes, const std::string& name) {
  PngState state;
  const auto check = [&](int ok) {
    if (ok == 0) throw InputError(name + ": no whole PNG image: " + state.message);
  };
  check(png_image_begin_read_from_memory(&state, bytes.data(), bytes.size()));
  if (state.width > Image::longest || state.height > Image::longest) {
    throw InputError(name + ": more than " + std::to_string(Image::longest) + " pixels along a side");
  }
  state.format = PNG_FORMAT_RGBA;
  state.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // or 16 bits a channel would be taken for light, and encoded
  std::vector<std::array<std::uint8_t, 4>> pixels(std::size_t{state.width} * state.height);
  check(png_image_finish_read(&state, nullptr, pixels.data(), 0, nullptr));
  Image image(static_cast<int>(state.width), static_cast<int>(state.height));
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const auto& [r, g, b, alpha] = pixels[k];
    if (alpha != 255) throw InputError(name + ": the image is transparent in places");
    image.pixels[k] = {r, g, b};
  }
  return image;
}

Image read_png(const std::filesystem::path& file) { return parse_png(load_file(file.string()), file.string()); }

std::string png(const Image& image) {
  if (image.width < 1 || image.height < 1 || image.width > Image::longest || image.height > Image::longest) {
    throw std::invalid_argument("an image's sides must be from 1 to 32767 pixels");
  }
  PngState state;
  state.width = static_cast<png_uint_32>(image.width);
  state.height = static_cast<png_uint_32>(image.height);
  state.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  const auto write = [&](void* to) {
    if (png_image_write_to_memory(&state, to, &size, 0, image.pixels.data(), 0, nullptr) == 0) {
      throw std::runtime_error(std::string("PNG: ") + state.message);
    }
  };
  write(nullptr);  // finds the size
  std::string content(size, '\0');
  write(content.data());
  content.resize(size);
  return content;
}

}  // namespace sightline
