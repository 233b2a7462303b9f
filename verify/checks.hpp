// The checks of a map that is known to be a subdivision of its window (Drawing::check).
#pragma once

#include "verify/regions.hpp"

namespace sightline::verify {

/// What the checks share.
struct Context {
  Drawing& drawing;
  bool one_sided;
  unsigned threads;
  std::vector<std::vector<SeenSurface>> seen;        // by face's polygon; only those of faces are filled in
  std::vector<std::vector<std::uint32_t>> faces_of;  // of each polygon
};
Context make_context(Drawing& drawing, bool one_sided, unsigned threads);

/// "area", "solid angle": the figures printed.
void check_measures(const Drawing& drawing, const MapFile& file, Report& report);
/// "cover": every face lies within its polygon.
void check_cover(const Context& context, Report& report);
/// "depth", "coincident": no polygon is nearer than a face's own in any part of the face; among coplanar ones the
/// lowest index owns; the others are listed.
void check_depth(Context& context, Report& report);
/// "kinds", "lines": kind and owner of every edge, and that a line named by a scene edge is one that carries it.
void check_kinds(const Context& context, Report& report);
/// "maximality": nothing could be merged.
void check_maximality(const Context& context, Report& report);
/// "scene vertices": named where they are seen, and none left out.
void check_scene_vertices(const Context& context, Report& report);

}  // namespace sightline::verify
