// Pieces with their textures: looked up, and as OBJ and MTL files.
#pragma once

#include "photos/photos.hpp"

namespace sightline {

/// The colours of a textured scene at points of its polygons. What it is made of must outlive it.
class TextureLookup {
 public:
  TextureLookup(const Scene& scene, const ClipResult& clipped, const PhotoTextures& textures);

  /// The piece of the polygon that holds the point, to rounding; between two either.
  std::uint32_t piece_at(PolygonId polygon, const glm::dvec3& point) const;
  /// Where a point of a piece's plane is in the piece's page, in pixels.
  glm::dvec2 place(std::uint32_t piece, const glm::dvec3& point) const;
  /// The bilinear mean of the page's four pixels around a place.
  glm::dvec3 colour(std::uint32_t page, const glm::dvec2& place) const;
  glm::dvec3 at(PolygonId polygon, const glm::dvec3& point) const {
    const std::uint32_t piece = piece_at(polygon, point);
    return colour(textures_.pieces[piece].page, place(piece, point));
  }

 private:
  const Scene& scene_;
  const ClipResult& clipped_;
  const PhotoTextures& textures_;
  std::vector<std::uint32_t> first_piece_;  // by surface
};

/// The pieces as an OBJ file: points with 17 significant digits, those with equal coordinates once; places in images
/// with 9; face k is piece k, its corners running as those of its polygon, its group `polygon_P` for the source polygon
/// P, its material that of its page, `page_0`, `page_1` and so on. `materials` is the name of the MTL file.
std::string textured_obj(const Scene& scene, const ClipResult& clipped, const PhotoTextures& textures,
                         const std::string& materials);
/// The MTL file with a material for each image file.
std::string textured_mtl(std::span<const std::string> images);

}  // namespace sightline
