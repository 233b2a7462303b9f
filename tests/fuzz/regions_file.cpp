// A regions file of `clip`: refused in one line, or a clip with it ends.
#include "clip/clip.hpp"
#include "clip/files.hpp"
#include "scene/errors.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <optional>

using namespace sightline;

namespace {

Scene small_scene() {
  PolygonSoup soup;
  soup.vertices = {{-1, 4, -1}, {1, 4, -1}, {1, 4, 1}, {-1, 4, 1}, {-2, 6, 0}, {3, 6, 0}, {0, 7, 3}};
  soup.corners = {0, 1, 2, 3, 4, 5, 6};
  soup.first = {0, 4, 7};
  return make_scene(std::move(soup));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Scene scene = small_scene();
  static const std::vector<Camera> cameras{{}, {{1, -1, 0}, {0, 2, 0}, {1, 0, 0}, {0, 0, 1}}};
  ClipOptions options;
  try {
    options.regions = read_regions(fuzz::as_file(fuzz::text(data, size), ".regions"), cameras.size());
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
    return 0;
  }
  fuzz::expect(options.regions.size() <= cameras.size(), "regions of a camera that there is not");
  std::size_t points = 0;
  for (const auto& of_camera : options.regions) {
    for (const TextureRegion& region : of_camera) points += region.points.size();
  }
  if (points > 40) return 0;
  options.buffer = 16;
  fuzz::expect(!clip(scene, cameras, options).pieces.empty(), "pieces were lost");
  return 0;
}
