#include "tests/fuzz/small_scene.hpp"

#include <cmath>
#include <limits>

namespace sightline::fuzz {

namespace {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  unsigned next() { return at_ == end_ ? 0 : *at_++; }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

/// Three bits say the whole number, two how far it is off, two by what it is scaled; most bytes scale by 1.
double coordinate(unsigned byte) {
  const double whole = static_cast<double>(byte & 7u) - 4;
  switch (byte >> 3) {
    case 1:
      return std::nextafter(whole, std::numeric_limits<double>::infinity());
    case 2:
      return std::nextafter(whole, -std::numeric_limits<double>::infinity());
    case 3:
      return whole / 3;
    case 4:
      return whole + 0.5;
    case 5:
      return std::ldexp(whole, -30);
    case 6:
      return std::ldexp(whole, 20);
    case 7:
      return std::ldexp(whole, -200);
    default:
      return whole;
  }
}

glm::dvec3 place(Bytes& bytes) {
  const double x = coordinate(bytes.next()), y = coordinate(bytes.next()), z = coordinate(bytes.next());
  return {x, y, z};
}

/// Of whole numbers, so that it is exact whether vectors depend on each other.
glm::dvec3 direction(Bytes& bytes) {
  const unsigned a = bytes.next(), b = bytes.next();
  return {static_cast<double>(a & 15u) - 7, static_cast<double>(a >> 4) - 7, static_cast<double>(b & 15u) - 7};
}

double determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace

SmallScene small_scene(const std::uint8_t* data, std::size_t size, int cameras) {
  Bytes bytes(data, size);
  SmallScene result;
  const unsigned kind = bytes.next();
  result.options.one_sided = (kind & 1u) != 0;
  if ((kind & 6u) == 6) result.options.snap = "0.5";
  for (int k = 0; k < cameras; ++k) {
    Camera camera;
    camera.eye = place(bytes);
    const glm::dvec3 forward = direction(bytes), right = direction(bytes), up = direction(bytes);
    if (determinant(forward, right, up) != 0) {
      camera.forward = forward;
      camera.right = right;
      camera.up = up;
    }
    result.cameras.push_back(camera);
  }
  const unsigned vertices = 3 + bytes.next() % 14;
  for (unsigned k = 0; k < vertices; ++k) result.soup.vertices.push_back(place(bytes));
  const unsigned polygons = 1 + bytes.next() % 7;
  for (unsigned k = 0; k < polygons; ++k) {
    const unsigned corners = 3 + bytes.next() % 4;
    for (unsigned c = 0; c < corners; ++c) result.soup.corners.push_back(bytes.next() % vertices);
    result.soup.first.push_back(static_cast<std::uint32_t>(result.soup.corners.size()));
  }
  result.soup.source = "small.obj";
  return result;
}

}  // namespace sightline::fuzz
