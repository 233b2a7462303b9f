// Clipping a small scene for two cameras: the same pieces whatever the buffer, and of each polygon the traced maps see
// what the pieces say.
#include "beam/trace.hpp"
#include "clip/clip.hpp"
#include "clip/files.hpp"
#include "clip/t_free.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/small_scene.hpp"
#include "visibility_map/write.hpp"

#include <set>

using namespace sightline;

namespace {

std::set<PolygonId> seen_by_pieces(const ClipResult& clipped, std::uint32_t camera) {
  std::set<PolygonId> seen;
  for (const ClipPiece& piece : clipped.pieces) {
    for (std::uint32_t k = 0; k < piece.camera_count; ++k) {
      if (clipped.cameras[piece.first_camera + k] == camera) seen.insert(piece.polygon);
    }
  }
  return seen;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::SmallScene small = fuzz::small_scene(data, size, 2);
  const Scene scene = make_scene(small.soup, small.options);
  ClipOptions options;
  options.buffer = 16;
  const ClipResult clipped = clip(scene, small.cameras, options);
  const std::string ply = clip_ply(scene, clipped);
  options.buffer = 1;
  fuzz::expect(clip_ply(scene, clip(scene, small.cameras, options)) == ply, "another buffer, other pieces");
  options.buffer = 64;
  options.sampling = true;
  fuzz::expect(clip_ply(scene, clip(scene, small.cameras, options)) == ply, "samples, other pieces");
  t_free(scene, small.cameras, options, clipped);

  const BspTree tree(scene);
  Tracer tracer(tree);
  VisibilityMap map;
  for (std::uint32_t c = 0; c < 2; ++c) {
    tracer.trace(small.cameras[c], map);
    std::set<PolygonId> seen;
    for (const PolygonVisibility& polygon : visible_polygons(map, scene)) seen.insert(polygon.polygon);
    fuzz::expect(seen == seen_by_pieces(clipped, c), "pieces and map see other polygons");
  }
  return 0;
}
