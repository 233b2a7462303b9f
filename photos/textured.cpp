#include "photos/textured.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "photos/tile.hpp"

namespace sightline {

TextureLookup::TextureLookup(const Scene& scene, const ClipResult& clipped, const PhotoTextures& textures)
    : scene_(scene), clipped_(clipped), textures_(textures), first_piece_(scene.surfaces().size() + 1, 0) {
  for (const ClipPiece& piece : clipped.pieces) ++first_piece_[piece.surface + 1];
  for (std::size_t s = 1; s < first_piece_.size(); ++s) first_piece_[s] += first_piece_[s - 1];
}

std::uint32_t TextureLookup::piece_at(PolygonId polygon, const glm::dvec3& point) const {
  std::uint32_t best = none;
  double least = std::numeric_limits<double>::infinity();  // how far outside, in world units
  for (const Surface& s : scene_.surfaces(polygon)) {
    const auto surface = static_cast<std::size_t>(&s - scene_.surfaces().data());
    const ApproxPlane& plane = scene_.planes().approx(s.plane);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(plane.n[0], plane.n[1], plane.n[2]));
    for (std::uint32_t k = first_piece_[surface]; k < first_piece_[surface + 1]; ++k) {
      const auto corners =
          std::span(clipped_.corners).subspan(clipped_.pieces[k].first_corner, clipped_.pieces[k].corner_count);
      const auto at = [&](std::size_t i) { return glm::dvec3(corners[i].at[0], corners[i].at[1], corners[i].at[2]); };
      double outside = std::abs(glm::dot(normal, point - at(0)));
      for (std::size_t i = 0; i < corners.size() && outside < least; ++i) {
        const glm::dvec3 a = at(i), side = at(i + 1 == corners.size() ? 0 : i + 1) - a;
        const double length = glm::length(side);
        if (length > 0) outside = std::max(outside, glm::dot(glm::cross(side, normal), point - a) / length);
      }
      if (outside >= least) continue;
      least = outside;
      best = k;
    }
  }
  return best;
}

glm::dvec2 TextureLookup::place(std::uint32_t piece, const glm::dvec3& point) const {
  const PieceTexture& t = textures_.pieces[piece];
  if (t.camera == none) return {t.x + t.width / 2.0, t.y + t.height / 2.0};
  const PieceFrame frame(scene_, clipped_, clipped_.pieces[piece]);
  const auto along = [](double at, double size, int texels) {
    return size > 0 ? std::clamp(at / size, 0.0, 1.0) * texels : texels / 2.0;
  };
  const glm::dvec3 d = point - frame.origin;
  return {t.x + along(glm::dot(d, frame.across), frame.size.x, t.width),
          t.y + along(glm::dot(d, frame.down), frame.size.y, t.height)};
}

glm::dvec3 TextureLookup::colour(std::uint32_t page, const glm::dvec2& place) const {
  const Image& image = textures_.pages[page];
  const double x = std::floor(place.x - 0.5), y = std::floor(place.y - 0.5);
  const double right = place.x - 0.5 - x, down = place.y - 0.5 - y;
  glm::dvec3 sum(0);
  for (int k = 0; k < 4; ++k) {
    const int i = std::clamp(static_cast<int>(x) + (k & 1), 0, image.width - 1);
    const int j = std::clamp(static_cast<int>(y) + (k >> 1), 0, image.height - 1);
    sum += ((k & 1) != 0 ? right : 1 - right) * (k >> 1 != 0 ? down : 1 - down) * image.colour(i, j);
  }
  return sum;
}

namespace {

void append(std::string& out, double value, int digits) {
  char buffer[40];
  // + 0.0: -0 becomes 0.
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0, std::chars_format::general, digits).ptr;
  out.append(buffer, end);
}

}  // namespace

std::string textured_obj(const Scene& scene, const ClipResult& clipped, const PhotoTextures& textures,
                         const std::string& materials) {
  std::map<std::array<double, 3>, std::size_t> index;
  std::vector<std::size_t> vertex;
  std::string points, places, faces;
  for (const ClipCorner& corner : clipped.corners) {
    const auto [entry, is_new] = index.try_emplace(corner.at, index.size() + 1);
    vertex.push_back(entry->second);
    if (!is_new) continue;
    points += 'v';
    for (const double x : corner.at) append(points += ' ', x, 17);
    points += '\n';
  }
  PolygonId polygon = none;
  std::uint32_t page = none;
  for (std::size_t k = 0; k < clipped.pieces.size(); ++k) {
    const ClipPiece& piece = clipped.pieces[k];
    const PieceTexture& texture = textures.pieces[k];
    const Image& image = textures.pages[texture.page];
    if (piece.polygon != polygon) faces += "g polygon_" + std::to_string(polygon = piece.polygon) + "\n";
    if (texture.page != page) faces += "usemtl page_" + std::to_string(page = texture.page) + "\n";
    faces += 'f';
    const bool flipped = scene.surfaces()[piece.surface].flipped;
    for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
      const std::size_t c = piece.first_corner + (flipped ? piece.corner_count - 1 - i : i);
      faces += " " + std::to_string(vertex[c]) + "/" + std::to_string(c + 1);
    }
    faces += '\n';
    for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
      const glm::dvec2& place = textures.places[piece.first_corner + i];
      append(places += "vt ", place.x / image.width, 9);
      append(places += ' ', 1 - place.y / image.height, 9);
      places += '\n';
    }
  }
  return "# sightline clip: face k is piece k\nmtllib " + materials + "\n" + points + places + faces;
}

std::string textured_mtl(std::span<const std::string> images) {
  std::string text;
  for (std::size_t k = 0; k < images.size(); ++k) {
    text += "newmtl page_" + std::to_string(k) + "\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " + images[k] + "\n";
  }
  return text;
}

}  // namespace sightline
