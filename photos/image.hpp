// Pictures as PNG files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/errors.hpp"

namespace sightline {

/// A picture of 8 bits a channel, rows from the top. Pixel (i,j) is the square from (i,j) to (i+1,j+1): x runs to the
/// right, y downwards. Colours are mixed as the numbers they are stored as.
struct Image {
  static constexpr int longest = 32767;  // pixels along a side
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;  // width * height

  Image() = default;
  Image(int w, int h, std::array<std::uint8_t, 3> colour = {0, 0, 0})
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), colour) {}
  std::array<std::uint8_t, 3>& at(int i, int j) { return pixels[index(i, j)]; }
  const std::array<std::uint8_t, 3>& at(int i, int j) const { return pixels[index(i, j)]; }
  glm::dvec3 colour(int i, int j) const {
    const auto& c = at(i, j);
    return {c[0], c[1], c[2]};
  }
  bool operator==(const Image&) const = default;

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
  }
};

/// The nearest storable colour of numbers from 0 to 255.
std::array<std::uint8_t, 3> stored(const glm::dvec3& colour);

/// Reads a PNG file of any kind; 16 bits a channel become 8, other gammas that of sRGB. Throws InputError where it
/// cannot be read, is no whole PNG, is transparent anywhere, or has a side of more than Image::longest pixels.
Image read_png(const std::filesystem::path& file);
/// The same from the bytes of a file; `name` stands for the file in messages.
Image parse_png(std::string_view bytes, const std::string& name);
/// A PNG file's bytes. Law: parse_png(png(image)) == image. Throws std::invalid_argument where a side is below 1 or
/// above 32,767.
std::string png(const Image& image);

}  // namespace sightline
