#include "clip/clip.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

#include "clip/in_threads.hpp"
#include "clip/surface_clipper.hpp"

namespace sightline {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void append(ClipResult& result, const Scene& scene, SurfaceId surface, ClippedSurface& clipped, std::size_t cameras) {
  auto corner = static_cast<std::uint32_t>(result.corners.size());
  result.corners.insert(result.corners.end(), clipped.corners.begin(), clipped.corners.end());
  for (const ClippedSurface::Piece& piece : clipped.pieces) {
    ClipPiece p{scene.surfaces()[surface].polygon,
                surface,
                corner,
                piece.corner_count,
                static_cast<std::uint32_t>(result.cameras.size()),
                0,
                0};
    for (std::uint32_t c = 0; c < cameras; ++c) {
      if (!piece.wholly.has(c)) continue;
      result.cameras.push_back(c);
      ++p.camera_count;
    }
    for (std::uint32_t c = 0; c < cameras; ++c) {
      if (!piece.partly.has(c)) continue;
      result.cameras.push_back(c);
      ++p.partly_count;
    }
    corner += piece.corner_count;
    result.pieces.push_back(p);
  }
}

}  // namespace

ClipResult clip(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options) {
  ClipResult result;
  const double start = now();
  std::vector<std::optional<CoverBuffer>> drawn(cameras.size());
  std::atomic<std::size_t> next_camera = 0;
  const BoxTree tree(scene);
  in_threads(options.threads, [&] {
    std::vector<SurfaceId> in_window;
    for (std::size_t c = next_camera++; c < cameras.size(); c = next_camera++) {
      find_in_frame(ClipView(scene, cameras[c], static_cast<std::uint32_t>(c), {}), tree, in_window);
      const int size = options.buffer > 0 ? options.buffer : chosen_size(in_window.size(), cameras.size());
      drawn[c].emplace(scene, cameras[c], in_window, size);
    }
  });
  std::vector<CoverBuffer> buffers;
  for (auto& buffer : drawn) buffers.push_back(std::move(*buffer));
  const double ready = now();
  result.stats.buffer_seconds = ready - start;

  const auto count = static_cast<SurfaceId>(scene.surfaces().size());
  std::vector<ClippedSurface> clipped(count);
  std::atomic<SurfaceId> next = 0;
  std::mutex mutex;
  in_threads(options.threads, [&] {
    SurfaceClipper clipper(scene, tree, cameras, buffers, options);
    for (SurfaceId s = next++; s < count; s = next++) clipped[s] = clipper.clip(s);
    const std::lock_guard lock(mutex);
    result.stats.buffer_proofs += clipper.stats().buffer_proofs;
    result.stats.shadows += clipper.stats().shadows;
    result.stats.cuts += clipper.stats().cuts;
  });
  for (SurfaceId s = 0; s < count; ++s) append(result, scene, s, clipped[s], cameras.size());
  result.stats.clip_seconds = now() - ready;
  return result;
}

}  // namespace sightline
