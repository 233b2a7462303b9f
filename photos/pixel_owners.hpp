// Which pixels of a photograph show one polygon and nothing else.
#pragma once

#include <span>

#include "clip/clip.hpp"
#include "visibility_map/map.hpp"

namespace sightline {

/// Of each pixel the polygon that it may be used for, or `none`.
struct PixelOwners {
  int width = 0, height = 0;
  std::vector<PolygonId> polygon;  // rows from the top

  PolygonId at(int i, int j) const {
    if (i < 0 || j < 0 || i >= width || j >= height) return none;
    return polygon[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
  }
};

/// The owners of the pixels of a photograph that fills the map's window.
///
/// With a guard of N pixels, N > 0: a pixel has an owner where no edge of the map but the window's own touches it, and
/// no silhouette touches any pixel within N - 1 pixels of it, to the side or diagonally. It then shows its owner alone,
/// however little it would show of another polygon. With N = 0: the polygon seen at its centre, as an item buffer has
/// it, whatever else the pixel shows. Pixels that are not wholly inside of the regions have no owner.
///
/// Laws. 1: with N > 0 every edge of the map is at least 2^-21 pixels from every pixel that has an owner. 2: the owners
/// for N + 1 are those for N, or none. Errors: std::invalid_argument for a sphere map, a side below 1 or above 32,767
/// pixels, or a negative guard.
PixelOwners pixel_owners(const VisibilityMap& map, const Scene& scene, int width, int height, int guard,
                         std::span<const TextureRegion> regions = {});

}  // namespace sightline
