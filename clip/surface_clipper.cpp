#include "clip/surface_clipper.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {

SurfaceClipper::SurfaceClipper(const Scene& scene, const BoxTree& tree, std::span<const Camera> cameras,
                               std::span<const CoverBuffer> buffers, const ClipOptions& options)
    : scene_(scene), buffers_(buffers), finder_(scene, tree), sampling_(options.sampling) {
  for (std::uint32_t c = 0; c < cameras.size(); ++c) {
    std::span<const TextureRegion> regions;
    if (c < options.regions.size()) regions = options.regions[c];
    views_.emplace_back(scene, cameras[c], c, regions);
  }
  const double unit = std::ldexp(scene.grid().step(), scene.grid().unit_bits());
  threshold_ = options.threshold / (unit * unit);
}

bool SurfaceClipper::hidden(const CoverBuffer& buffer, const Outline& outline, PlaneId plane, bool backwards) {
  const bool proven =
      sampling_ ? buffer.hides_by_samples(outline.corner, plane) : buffer.hides(outline.corner, plane, backwards);
  stats_.buffer_proofs += proven;
  return proven;
}

ClippedSurface SurfaceClipper::clip(SurfaceId surface) {
  Outlines outlines(scene_, surface);
  Carver carver(outlines, threshold_);
  const CameraSet nobody(views_.size());
  std::vector<SurfacePiece> pieces{{outlines.whole(), nobody, nobody, false}}, next;
  std::vector<OutlineSide> frame;
  std::vector<Shadow> shadows;
  std::vector<CarvedPart> parts;
  const PlaneId plane = scene_.surfaces()[surface].plane;
  const bool backwards = scene_.planes().approx(plane).n[outlines.lines().axis()] < 0;
  const Outline whole = pieces[0].outline;
  for (std::size_t c = 0; c < views_.size(); ++c) {
    if (!views_[c].faces(scene_.surfaces()[surface])) continue;
    if (hidden(buffers_[c], whole, plane, backwards)) continue;
    if (finder_.find(surface, views_[c], outlines, frame, shadows) == ShadowFinder::unseen) continue;
    stats_.shadows += shadows.size();
    if (pieces.size() > 3) carver.bound(whole, shadows);
    next.clear();
    for (SurfacePiece& piece : pieces) {
      parts.clear();
      if (pieces.size() > 1 && !shadows.empty() && hidden(buffers_[c], piece.outline, plane, backwards)) {
        next.push_back(std::move(piece));
        next.back().fresh = false;
        continue;
      }
      if (!carver.carve(piece.outline, frame, shadows, parts)) {
        next.push_back(std::move(piece));
        next.back().fresh = false;
        continue;
      }
      const bool fresh = parts.size() > 1;
      for (CarvedPart& part : parts) {
        next.push_back({std::move(part.outline), piece.wholly, piece.partly, fresh});
        if (part.sight == Sight::visible) next.back().wholly.add(c);
        if (part.sight == Sight::partly) next.back().partly.add(c);
      }
    }
    pieces.swap(next);
    unite(pieces, outlines);
  }
  stats_.cuts += carver.cuts();
  ClippedSurface out;
  finish(pieces, outlines, out);
  return out;
}

void SurfaceClipper::finish(std::vector<SurfacePiece>& pieces, Outlines& outlines, ClippedSurface& out) const {
  // Counter-clockwise from the plane's front: backwards where the axis looked along runs against the normal.
  const bool forwards = scene_.planes().approx(outlines.lines().plane()).n[outlines.lines().axis()] > 0;
  for (SurfacePiece& piece : pieces) {
    const Outline& o = piece.outline;
    const std::size_t n = o.size();
    for (std::size_t k = 0; k < n; ++k) {
      // Forwards, side k + 1 follows corner k; backwards, side k follows corner k.
      const std::size_t corner = forwards ? k : n - 1 - k, after = (corner + 1) % n;
      out.corners.push_back({outlines.lines().world(o.sides[corner].line.id, o.sides[after].line.id),
                             outlines.name(o.sides[forwards ? after : corner].name)});
    }
    out.pieces.push_back({static_cast<std::uint32_t>(n), std::move(piece.wholly), std::move(piece.partly)});
  }
}

}  // namespace sightline
