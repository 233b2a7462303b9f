// Pictures of clipped scenes: every piece coloured by how many cameras see it, after figure 9 of Yu's paper.
#pragma once

#include "clip/clip.hpp"
#include "visibility_map/draw.hpp"

namespace sightline {

/// What one view shows.
struct CountPicture {
  VisibilityMap map;                // the view's own: its edges are drawn
  std::vector<DrawnPatch> patches;  // tile what is seen of polygons; `what` is the number of cameras
};

/// The pieces of clip() as each of the views sees them: they are cut by these too, so that patches do not overlap.
/// Views do not count. The threshold of the options is not used: what is seen in part is cut, so that its colours are
/// right.
std::vector<CountPicture> count_pictures(const Scene& scene, std::span<const Camera> cameras,
                                         std::span<const Camera> views, const ClipOptions& options = {});

/// White, red, green, blue, yellow, cyan, magenta for 0 to 6 cameras, and greys that grow darker for more.
Colour count_colour(std::uint32_t cameras, double light);

/// Width in pixels. Errors as map_svg and write_map_png.
std::string count_svg(const CountPicture& picture, const Scene& scene, int width = 1024);
void write_count_png(const std::filesystem::path& file, const CountPicture& picture, const Scene& scene,
                     int width = 1024);

}  // namespace sightline
