// Photographs mapped to the pieces of clip(): a texture for each piece, from its best camera.
#pragma once

#include "clip/clip.hpp"
#include "photos/photograph.hpp"

namespace sightline {

struct PhotoOptions {
  /// How far from its place a texel may borrow a pixel's colour, in pixels; a guard needs at least as many.
  int reach = 2;
  double density = 1;                                 // texels for each pixel of the photograph, along a side
  int page = 4096;                                    // longest side of a page, in pixels, 16 to 32,767
  std::array<std::uint8_t, 3> unseen{128, 128, 128};  // where nothing is known
  unsigned threads = 1;
};

/// Texels around a piece's own that belong to it alone and continue it.
inline constexpr int texture_padding = 2;

struct PieceTexture {
  enum Source : std::uint8_t {
    best,     // a texture from the camera that sees the piece in the most pixels
    next,     // that one had too few usable pixels: from the next in that order that has enough
    uniform,  // none has enough: one colour, the mean of the usable pixels of all of them
    polygon,  // none has any: the mean of the polygon's other pieces
    unknown,  // they have none either: PhotoOptions::unseen
    hidden    // no camera sees it: the same
  } source = hidden;
  std::uint32_t camera = none;  // best and next
  std::uint32_t page = 0;
  int x = 0, y = 0, width = 0, height = 0;  // its own texels in the page, padding not counted
};

struct PhotoStats {
  double seconds = 0;
  std::array<std::uint64_t, 6> pieces{};  // by PieceTexture::Source
  /// Texels within pieces that have a texture: from pixels at their place, borrowed nearby, or continued from
  /// neighbouring texels because there was nothing to borrow.
  std::uint64_t direct = 0, borrowed = 0, continued = 0;
};

struct PhotoTextures {
  std::vector<PieceTexture> pieces;  // of ClipResult::pieces
  std::vector<glm::dvec2> places;    // of ClipResult::corners: where in the piece's page, in pixels
  std::vector<Image> pages;
  PhotoStats stats;
};

/// A texture for each piece. Photographs are those of the cameras that clip() was given, in their order.
///
/// A camera may give a piece its texture if it sees all of it, by clip(); where a threshold has left pieces that some
/// see in part, those come after the others. They are tried in the order of the area in which they see the piece, in
/// pixels, largest first (nearer and less oblique is larger); the first in whose photograph at least half of the
/// piece's texels find a usable pixel at their place is taken.
///
/// Laws. 1: a texture holds colours of pixels that the piece's polygon owns in its camera's photograph, and means of
/// them, and nothing else. 2: own texels and padding of two pieces do not overlap (pieces of one colour may share a
/// texel). 3: a piece's corners lie within its own texels, so that a bilinear look-up touches nothing but those and
/// padding. 4: the same result at any number of threads. Errors: std::invalid_argument where a number is out of range
/// or there are not as many photographs as cameras named in the result.
PhotoTextures map_photos(const Scene& scene, const ClipResult& clipped, std::span<const Photograph> photographs,
                         const PhotoOptions& options = {});

}  // namespace sightline
