#include "clip/files.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <map>

#include "clip/hybrid.hpp"
#include "clip/in_threads.hpp"
#include "clip/view.hpp"
#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"
#include "visibility_map/write.hpp"

namespace sightline {

std::vector<std::vector<TextureRegion>> read_regions(const std::filesystem::path& file, std::size_t cameras) {
  const std::string text = load_file(file.string());
  TextScanner in(file.string(), text, {.comments = true, .continuations = false});
  std::vector<std::vector<TextureRegion>> regions(cameras);
  std::size_t count = 0;
  for (; in.find_token(); in.next_line(), ++count) {
    const Item item{"region", count};
    const std::int64_t camera = in.integer(item, "camera");
    if (camera < 0 || static_cast<std::uint64_t>(camera) >= cameras)
      in.fail(item, "there is no camera " + std::to_string(camera));
    const std::string_view kind = in.token();
    if (kind != "interior" && kind != "exterior") in.fail(item, quoted(kind) + " is neither interior nor exterior");
    TextureRegion region{kind == "interior", {}};
    while (!in.at_line_end()) {
      const double s = in.number(item, "s");
      region.points.emplace_back(s, in.number(item, "t"));
    }
    try {
      check_region(region);
    } catch (const std::invalid_argument& e) {
      in.fail(item, e.what());
    }
    regions[static_cast<std::size_t>(camera)].push_back(std::move(region));
  }
  return regions;
}

namespace {

void append(std::string& out, double value) {
  char buffer[40];
  // + 0.0: -0 becomes 0.
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0, std::chars_format::general, 17).ptr;
  out.append(buffer, end);
}

void append_list(std::string& out, std::span<const std::uint32_t> list) {
  out += std::to_string(list.size());
  for (const std::uint32_t k : list) out += " " + std::to_string(k);
}

}  // namespace

std::string clip_ply(const Scene& scene, const ClipResult& result, bool thresholded, const TFreePieces* t_free) {
  std::map<std::array<double, 3>, std::uint32_t> index;
  std::vector<std::uint32_t> vertex;
  std::string places, faces;
  for (const ClipCorner& corner : result.corners) {
    const auto [it, is_new] = index.try_emplace(corner.at, static_cast<std::uint32_t>(index.size()));
    vertex.push_back(it->second);
    if (!is_new) continue;
    for (int k = 0; k < 3; ++k) {
      append(places, corner.at[static_cast<std::size_t>(k)]);
      places += k < 2 ? ' ' : '\n';
    }
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t p = 0; p < result.pieces.size(); ++p) {
    const ClipPiece& piece = result.pieces[p];
    corners.clear();
    if (t_free) {
      for (std::uint32_t k = t_free->first[p]; k < t_free->first[p + 1]; ++k)
        corners.push_back(vertex[t_free->corners[k]]);
    } else {
      corners.assign(vertex.begin() + piece.first_corner, vertex.begin() + piece.first_corner + piece.corner_count);
    }
    if (scene.surfaces()[piece.surface].flipped) std::reverse(corners.begin(), corners.end());
    append_list(faces, corners);
    faces += " " + std::to_string(piece.polygon) + " ";
    const auto cameras = std::span(result.cameras).subspan(piece.first_camera);
    append_list(faces, cameras.first(piece.camera_count));
    if (thresholded) {
      faces += " ";
      append_list(faces, cameras.subspan(piece.camera_count, piece.partly_count));
    }
    faces += "\n";
  }
  return "ply\nformat ascii 1.0\ncomment sightline clip\nelement vertex " + std::to_string(index.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(result.pieces.size()) +
         "\nproperty list uint uint vertex_indices\nproperty uint source_polygon\nproperty list uint uint cameras\n" +
         (thresholded ? "property list uint uint partly\n" : "") + "end_header\n" + places + faces;
}

std::string clip_csv(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options) {
  const HybridTracer prepared(scene, options.buffer);
  std::vector<std::string> rows(cameras.size());
  std::atomic<std::size_t> next = 0;
  in_threads(options.threads, [&] {
    HybridTracer tracer(prepared);
    VisibilityMap map;
    for (std::size_t c = next++; c < cameras.size(); c = next++) {
      tracer.trace(cameras[c], map);
      rows[c] = map_csv(map, scene, c);
    }
  });
  std::string text = csv_header;
  for (const std::string& row : rows) text += row;
  return text;
}

}  // namespace sightline
