#include "photos/photograph.hpp"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

namespace sightline {

Photograph::Photograph(const Scene& scene, const Camera& camera, Image image, PixelOwners owners)
    : frame_(scene, camera, image.width, image.height), image_(std::move(image)), owners_(std::move(owners)) {
  if (image_.width != owners_.width || image_.height != owners_.height) {
    throw std::invalid_argument("a photograph and its owners differ in size");
  }
}

PhotoSample Photograph::sample(PolygonId polygon, const glm::dvec2& place, int reach) const {
  const double far = reach + 1.0;
  if (!(place.x > -far && place.y > -far && place.x < image_.width + far && place.y < image_.height + far)) return {};
  const double x = std::floor(place.x - 0.5), y = std::floor(place.y - 0.5);
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const double right = place.x - 0.5 - x, down = place.y - 0.5 - y;
  glm::dvec3 sum(0);
  double weights = 0;
  for (int k = 0; k < 4; ++k) {
    const int column = i + (k & 1), line = j + (k >> 1);
    if (owners_.at(column, line) != polygon) continue;
    const double weight = ((k & 1) != 0 ? right : 1 - right) * (k >> 1 != 0 ? down : 1 - down);
    sum += weight * image_.colour(column, line);
    weights += weight;
  }
  // A weight below this is as good as no pixel: the quotient would be one far pixel's colour.
  constexpr double least = 1.0 / 16;
  if (weights >= least) return {PhotoSample::direct, sum / weights};

  const int column = static_cast<int>(std::floor(place.x)), line = static_cast<int>(std::floor(place.y));
  double nearest = std::numeric_limits<double>::infinity();
  PhotoSample found;
  for (int b = line - reach; b <= line + reach; ++b) {
    for (int a = column - reach; a <= column + reach; ++a) {
      if (owners_.at(a, b) != polygon) continue;
      const double distance = glm::distance(place, glm::dvec2(a + 0.5, b + 0.5));
      if (distance >= nearest) continue;
      nearest = distance;
      found = {PhotoSample::borrowed, image_.colour(a, b)};
    }
  }
  return found;
}

void check_aspect(const Image& image, const Camera& camera, const std::string& name) {
  const double aspect = glm::length(camera.right) / glm::length(camera.up);
  if (std::abs(image.width - image.height * aspect) <= 1 || std::abs(image.height - image.width / aspect) <= 1) return;
  char digits[32];
  const std::string wanted(digits,
                           std::to_chars(digits, digits + sizeof digits, aspect, std::chars_format::general, 6).ptr);
  throw InputError(name + ": " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                   " pixels do not fit the camera's aspect of " + wanted);
}

}  // namespace sightline
