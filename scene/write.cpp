#include "scene/read.hpp"

#include <charconv>

namespace sightline {
namespace {

template <class Number>
void append(std::string& text, Number value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append(std::string& text, const glm::dvec3& v) {
  for (int k = 0; k < 3; ++k) {
    append(text, v[k]);
    if (k < 2) text += ' ';
  }
}

}  // namespace

void write_obj(const std::filesystem::path& file, const PolygonSoup& soup) {
  std::string text;
  text.reserve(48 * soup.vertices.size() + 8 * soup.corners.size());
  for (const glm::dvec3& v : soup.vertices) {
    text += "v ";
    append(text, v);
    text += '\n';
  }
  std::uint32_t object = none;
  for (std::size_t p = 0; p + 1 < soup.first.size(); ++p) {
    const std::uint32_t own = soup.object_of.empty() ? none : soup.object_of[p];
    if (own != object) text += own == none ? "g\n" : "o " + soup.objects[own] + "\n";
    object = own;
    text += 'f';
    for (std::uint32_t k = soup.first[p]; k < soup.first[p + 1]; ++k) {
      text += ' ';
      append(text, std::uint64_t{soup.corners[k]} + 1);
    }
    text += '\n';
  }
  write_file(file, text);
}

void write_cameras(const std::filesystem::path& file, std::span<const CameraLine> cameras) {
  std::string text = "# eye x y z  forward x y z  up x y z  vertical angle in degrees  aspect\n";
  for (const CameraLine& c : cameras) {
    append(text, c.eye);
    text += "  ";
    append(text, c.forward);
    text += "  ";
    append(text, c.up);
    text += "  ";
    append(text, c.vertical_fov_degrees);
    text += ' ';
    append(text, c.aspect);
    text += '\n';
  }
  write_file(file, text);
}

}  // namespace sightline
