#include "visibility_map/draw.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sightline {

namespace {

std::uint8_t channel(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

double cube(double x) { return x * x * x; }

double fraction(double x) { return x - std::floor(x); }

}  // namespace

Colour oklch(double lightness, double chroma, double hue) {
  const double turn = 2 * std::acos(-1.0) * hue;
  const double a = chroma * std::cos(turn), b = chroma * std::sin(turn);
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Drawing::Drawing(const VisibilityMap& map, const Scene& scene, const DrawOptions& options)
    : scene_(scene), camera_(map.camera), options_(options) {
  if (map.sphere) throw std::invalid_argument("a map of the whole sphere has no window to draw");
  const double height = std::round(options.width * (glm::length(map.camera.up) / glm::length(map.camera.right)));
  constexpr double most = 32767;  // cairo's limit
  if (options.width < 1 || options.width > most || !(height <= most)) {
    throw std::invalid_argument("a drawing's sides must be from 1 to 32767 pixels");
  }
  height_ = std::max(1, static_cast<int>(height));
  scale_ = std::clamp(std::sqrt(static_cast<double>(options.width) * height_ / (1024.0 * 768.0)), 0.5, 4.0);

  double length[5]{};
  std::size_t count[5]{};
  for (const MapEdge& edge : map.edges) {
    const auto kind = static_cast<std::size_t>(edge.kind);
    length[kind] += glm::distance(place(map.vertices[edge.vertex[0]].st), place(map.vertices[edge.vertex[1]].st));
    ++count[kind];
  }
  for (std::size_t kind = 0; kind < 5; ++kind) {
    const double mean = count[kind] == 0 ? 100 : length[kind] / static_cast<double>(count[kind]) / scale_;
    fineness_[kind] = std::clamp(mean / 16, 0.2, 1.0);
  }
}

double Drawing::light(PolygonId polygon) const {
  const auto corners = scene_.corners(polygon);
  const auto& vertices = scene_.soup().vertices;
  const glm::dvec3 first = vertices[corners[0]];
  glm::dvec3 normal{0, 0, 0};  // Newell's: right for polygons of any shape, folded ones too
  for (std::size_t k = 2; k < corners.size(); ++k) {
    normal += glm::cross(vertices[corners[k - 1]] - first, vertices[corners[k]] - first);
  }
  const double length = glm::length(normal);
  if (!(length > 0) || !std::isfinite(length)) return 0.5;
  if (glm::dot(normal, camera_.eye - first) < 0) normal = -normal;
  const glm::dvec3 lamp = -0.55 * glm::normalize(camera_.forward) - 0.45 * glm::normalize(camera_.right) +
                          0.75 * glm::normalize(camera_.up);
  return std::clamp(0.5 + 0.5 * glm::dot(normal / length, glm::normalize(lamp)), 0.0, 1.0);
}

Colour Drawing::fill(const MapFace& face) const {
  if (face.polygon == none) return paper;
  const double brightness = light(face.polygon);
  if (options_.fill == DrawOptions::Fill::shaded) return oklch(0.62 + 0.34 * brightness, 0.014, 0.22);
  // Steps of the golden ratio keep the hues of neighbouring indices far apart; the plastic number spreads lightness.
  const double hue = fraction(0.08 + face.polygon * 0.6180339887498949);
  const double offset = fraction(face.polygon * 0.7548776662466927) - 0.5;
  return oklch(0.56 + 0.3 * brightness + 0.06 * offset, 0.07, hue);
}

bool Drawing::drawn(EdgeKind kind) const {
  switch (kind) {
    case EdgeKind::silhouette:
      return options_.silhouettes;
    case EdgeKind::window:
      return options_.edges || options_.silhouettes;
    default:
      return options_.edges;
  }
}

Stroke Drawing::stroke(EdgeKind kind) const {
  const double fine = fineness_[static_cast<std::size_t>(kind)];
  switch (kind) {
    case EdgeKind::silhouette:
      return {2.4 * scale_ * std::max(fine, 0.3), {28, 28, 34}, 1};
    case EdgeKind::crease:
      return {0.8 * scale_, {52, 52, 62}, fine};
    case EdgeKind::seam:
      return {0.5 * scale_, {92, 92, 102}, 0.8 * fine};
    case EdgeKind::intersection:
      return {0.9 * scale_, {150, 52, 44}, fine};
    case EdgeKind::window:
      break;
  }
  return {2 * scale_, {28, 28, 34}, 1};
}

}  // namespace sightline
