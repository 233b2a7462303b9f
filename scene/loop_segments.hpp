// The edges of a loop in a plane without those parts over which it runs back.
#pragma once

#include "scene/plane_figure.hpp"

#include <span>
#include <vector>

namespace sightline {

/// A part of a line over which the loop runs `net` times more often from p to q than from q to p; net is not 0.
/// q comes after p in the order of (x, y).
struct LoopSegment {
  std::uint32_t line;  // index into LoopSegments::lines
  PointId p, q;
  int net;
};

struct LoopSegments {
  std::vector<PlaneLine> lines;       // all different, each directed as its segments
  std::vector<LoopSegment> segments;  // those of one line stand together, in order along it
};

/// Collinear edges that follow one another are one segment.
LoopSegments loop_segments(const PlaneView& view, std::span<const PointId> loop);

}  // namespace sightline
