// clip() beside the tracer from every camera, batch after batch, and with buffers of other sizes.
//     SIGHTLINE_SUBJECTS="building:2000 city FILE.obj" test_clip_cameras
// takes models (`:` number of polygons) and files with their .cameras beside them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "scene/read.hpp"
#include "tests/clip/shots.hpp"

namespace sightline::testing {
namespace {

constexpr std::size_t batch = 8;

Shot subject(const std::string& name) {
  if (!name.ends_with(".obj")) {
    const std::size_t colon = name.find(':');
    const auto polygons = colon == std::string::npos ? 0 : std::stoul(name.substr(colon + 1));
    return model(name.substr(0, colon), 1, static_cast<std::uint32_t>(polygons));
  }
  std::filesystem::path cameras = name;
  return {make_scene(read_polygons(name)), read_cameras(cameras.replace_extension(".cameras"))};
}

TEST(ClipCameras, BesideTheTracerWithBuffersOfAllSizes) {
  const char* wanted = std::getenv("SIGHTLINE_SUBJECTS");
  std::istringstream names(wanted ? wanted : "rooms maze:60");
  for (std::string name; names >> name;) {
    const Shot all = subject(name);
    std::size_t pieces = 0;
    for (std::size_t first = 0; first < all.cameras.size(); first += batch) {
      SCOPED_TRACE(name + ", cameras from " + std::to_string(first));
      Shot shot{all.scene, {}};
      for (std::size_t c = first; c < std::min(first + batch, all.cameras.size()); ++c) {
        shot.cameras.push_back(all.cameras[c]);
      }
      ClipOptions options;
      const ClipResult result = clip(shot.scene, shot.cameras, options);
      pieces += result.pieces.size();
      const ExactPieces exact(shot.scene, shot.cameras, options, result);
      EXPECT_EQ(unlike_tracer(shot, exact, result), "");
      for (const int buffer : {32, 256, 2048}) {
        options.buffer = buffer;
        EXPECT_TRUE(same(result, clip(shot.scene, shot.cameras, options))) << buffer;
      }
    }
    std::printf("%s: %zu cameras, %zu pieces in batches of %zu\n", name.c_str(), all.cameras.size(), pieces, batch);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace sightline::testing
