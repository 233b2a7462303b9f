// One piece's texture, before it has a place on a page. For this folder's own use.
#pragma once

#include "photos/photos.hpp"

namespace sightline {

/// A rectangle in a piece's plane around the piece, its first side along the piece's longest.
struct PieceFrame {
  glm::dvec3 origin{0}, across{0}, down{0};  // a corner and two unit vectors
  glm::dvec2 size{0};
  std::vector<glm::dvec2> corner;  // the piece's, from (0,0) to size

  PieceFrame(const Scene& scene, const ClipResult& clipped, const ClipPiece& piece);
  glm::dvec3 point(const glm::dvec2& at) const { return origin + at.x * across + at.y * down; }
  glm::dvec2 centre() const;  // the mean of the corners
  /// Inside of the piece, borders included, to rounding.
  bool holds(const glm::dvec2& at) const;
};

struct Tile {
  int width = 0, height = 0;       // own texels
  std::vector<glm::dvec3> colour;  // with padding, rows one after the other
  std::vector<PhotoSample::Kind> kind;
  std::size_t direct = 0, borrowed = 0, bare = 0;  // of the texels within the piece, and of its centre
  glm::dvec3 sum{0};                               // of the colours of those direct and borrowed

  bool enough() const { return 2 * direct >= direct + borrowed + bare; }
  int full_width() const { return width + 2 * texture_padding; }
  int full_height() const { return height + 2 * texture_padding; }
};

/// How many pixels of a photograph a piece covers; 0 where a corner is not before the eye.
double pixels(const ClipResult& clipped, const ClipPiece& piece, const PhotoFrame& photo);
/// The photograph's colours of the polygon in the frame's plane: texels without any are left `nothing`.
Tile make_tile(const PieceFrame& frame, const ClipPiece& piece, const Photograph& photo, const PhotoOptions& options);
/// Continues a tile's colours, ring by ring, into texels that have none. Some colour must have been found.
void continue_colours(Tile& tile);

}  // namespace sightline
