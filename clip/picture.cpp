#include "clip/picture.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "clip/hybrid.hpp"

namespace sightline {
namespace {

DrawOptions look(int width) { return {.width = width}; }

/// Where a point before the camera is seen, rounded.
glm::dvec2 place(const Camera& c, const std::array<double, 3>& at) {
  const glm::dvec3 ray = glm::dvec3(at[0], at[1], at[2]) - c.eye;
  const double ahead = glm::dot(ray, glm::cross(c.right, c.up));
  return glm::dvec2(glm::dot(ray, glm::cross(c.up, c.forward)), glm::dot(ray, glm::cross(c.forward, c.right))) / ahead +
         0.5;
}

}  // namespace

Colour count_colour(std::uint32_t cameras, double light) {
  // Lightness, chroma, hue.
  static constexpr double hues[7][3] = {{0.97, 0, 0},       {0.62, 0.19, 0.075}, {0.72, 0.18, 0.395},
                                        {0.56, 0.16, 0.73}, {0.9, 0.16, 0.295},  {0.8, 0.11, 0.55},
                                        {0.66, 0.2, 0.905}};
  const double shade = 0.1 * (light - 1);
  if (cameras < 7) return oklch(hues[cameras][0] + shade, hues[cameras][1], hues[cameras][2]);
  return oklch(std::max(0.84 - 0.03 * (cameras - 7), 0.4) + shade, 0.02, 0.2);
}

std::vector<CountPicture> count_pictures(const Scene& scene, std::span<const Camera> cameras,
                                         std::span<const Camera> views, const ClipOptions& options) {
  std::vector<Camera> all(cameras.begin(), cameras.end());
  all.insert(all.end(), views.begin(), views.end());
  ClipOptions whole = options;
  whole.threshold = 0;
  whole.regions.resize(std::min(whole.regions.size(), cameras.size()));
  const ClipResult result = clip(scene, all, whole);

  std::vector<CountPicture> pictures(views.size());
  HybridTracer tracer(scene, options.buffer);
  for (std::size_t v = 0; v < views.size(); ++v) {
    CountPicture& picture = pictures[v];
    tracer.trace(views[v], picture.map);
    const Drawing drawing(picture.map, scene, look(1024));
    for (const ClipPiece& piece : result.pieces) {
      const auto seen_by = std::span(result.cameras).subspan(piece.first_camera, piece.camera_count);
      if (!std::binary_search(seen_by.begin(), seen_by.end(), cameras.size() + v)) continue;
      const auto own = std::lower_bound(seen_by.begin(), seen_by.end(), cameras.size());
      const auto count = static_cast<std::uint32_t>(own - seen_by.begin());
      DrawnPatch patch{{}, count_colour(count, drawing.light(piece.polygon)), count};
      for (std::uint32_t k = 0; k < piece.corner_count; ++k)
        patch.st.push_back(place(views[v], result.corners[piece.first_corner + k].at));
      picture.patches.push_back(std::move(patch));
    }
  }
  return pictures;
}

std::string count_svg(const CountPicture& picture, const Scene& scene, int width) {
  return patches_svg(picture.patches, picture.map, scene, look(width));
}

void write_count_png(const std::filesystem::path& file, const CountPicture& picture, const Scene& scene, int width) {
  write_patches_png(file, picture.patches, picture.map, scene, look(width));
}

}  // namespace sightline
