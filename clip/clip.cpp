#include "clip/clip.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "clip/surface_clipper.hpp"

namespace sightline {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void append(ClipResult& result, const Scene& scene, SurfaceId surface, ClippedSurface& clipped, std::size_t cameras) {
  auto corner = static_cast<std::uint32_t>(result.corners.size());
  result.corners.insert(result.corners.end(), clipped.corners.begin(), clipped.corners.end());
  for (const ClippedSurface::Piece& piece : clipped.pieces) {
    ClipPiece p{scene.surfaces()[surface].polygon, surface, corner, piece.corner_count,
                static_cast<std::uint32_t>(result.cameras.size()), 0, 0};
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
  const BoxTree tree(scene);
  const auto count = static_cast<SurfaceId>(scene.surfaces().size());
  std::vector<ClippedSurface> clipped(count);
  std::atomic<SurfaceId> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      SurfaceClipper clipper(scene, tree, cameras, options);
      for (SurfaceId s = next++; s < count; s = next++) clipped[s] = clipper.clip(s);
      const std::lock_guard lock(mutex);
      result.stats.buffer_proofs += clipper.stats().buffer_proofs;
      result.stats.shadows += clipper.stats().shadows;
      result.stats.cuts += clipper.stats().cuts;
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned t = 1; t < options.threads; ++t) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  for (SurfaceId s = 0; s < count; ++s) append(result, scene, s, clipped[s], cameras.size());
  result.stats.clip_seconds = now() - start;
  return result;
}

}  // namespace sightline
