#include "clip/hybrid.hpp"

#include <algorithm>
#include <chrono>

#include "clip/carve.hpp"
#include "clip/cover_buffer.hpp"
#include "clip/sky.hpp"
#include "visibility_map/stitch.hpp"

namespace sightline {

struct HybridTracer::State {
  State(const Scene& s, std::shared_ptr<const BoxTree> t, int b) : scene(s), tree(std::move(t)), buffer(b) {}

  void clip(SurfaceId surface, ClipView& view, const CoverBuffer& cover, ShadowFinder& finder);
  void see(const Outline& outline, SurfaceId surface, ClipView& view, Outlines& outlines, Carver& carver);
  SightlineRef sightline(const OutlineSide& side, PlaneId plane, ClipView& view, Outlines& outlines);

  const Scene& scene;
  std::shared_ptr<const BoxTree> tree;
  int buffer;
  Stitcher stitcher;
  Fragments fragments;
  Sky sky;
  std::vector<SurfaceId> in_window, seen, on;
  std::vector<OutlineSide> frame;
  std::vector<Shadow> shadows;
  std::vector<Coplanar> coplanar;
  std::vector<CarvedPart> parts;
  std::vector<SightlineRef> of_line;  // by line of the surface's plane; none: not yet known
  std::vector<SightlineRef> lines;
};

/// The plane through the eye and a side, its front where the outline lies.
SightlineRef HybridTracer::State::sightline(const OutlineSide& side, PlaneId plane, ClipView& view,
                                            Outlines& outlines) {
  if (of_line.size() <= side.line.id) of_line.resize(outlines.lines().size());
  SightlineRef& known = of_line[side.line.id];
  if (known.id == none) {
    const ClipSide& name = outlines.name(side.name);
    if (name.kind == ClipSide::window) {
      known = view.frame()[name.a].line;
    } else if (name.kind == ClipSide::intersection) {
      known = view.table().of_planes(plane, scene.surfaces()[name.a].plane);
    } else {
      known = view.table().of_points(name.a, name.b);
    }
    known.sign *= outlines.lines().of_sightline(view.table(), known).line.sign;
  }
  return {known.id, known.sign * side.line.sign};
}

void HybridTracer::State::see(const Outline& outline, SurfaceId surface, ClipView& view, Outlines& outlines,
                              Carver& carver) {
  const PlaneId plane = scene.surfaces()[surface].plane;
  lines.clear();
  for (const OutlineSide& side : outline.sides) lines.push_back(sightline(side, plane, view, outlines));
  // Counter-clockwise seen against the axis; the eye may be on the other side.
  const bool along = scene.planes().approx(plane).n[outlines.lines().axis()] > 0;
  if (along != (view.table().eye_side(plane) > 0)) std::reverse(lines.begin(), lines.end());
  on.assign(1, surface);
  for (const Coplanar& other : coplanar) {
    if (carver.meets(outline, other.figure)) on.push_back(other.surface);
  }
  fragments.add_convex(lines, on);
}

void HybridTracer::State::clip(SurfaceId surface, ClipView& view, const CoverBuffer& cover, ShadowFinder& finder) {
  const Surface& s = scene.surfaces()[surface];
  if (!view.faces(s)) return;
  Outlines outlines(scene, surface);
  const Outline whole = outlines.whole();
  if (cover.hides(whole.corner, s.plane, scene.planes().approx(s.plane).n[outlines.lines().axis()] < 0)) return;
  if (finder.find(surface, view, outlines, frame, shadows) == ShadowFinder::unseen) return;
  Carver carver(outlines, 0);
  parts.clear();
  if (!carver.carve(whole, frame, shadows, parts)) return;
  seen.push_back(surface);
  finder.find_coplanar(view, outlines, coplanar);
  of_line.clear();
  for (const CarvedPart& part : parts) {
    if (part.sight == Sight::visible) see(part.outline, surface, view, outlines, carver);
  }
}

HybridTracer::HybridTracer(const Scene& scene, int buffer)
    : state_(std::make_unique<State>(scene, std::make_shared<const BoxTree>(scene), buffer)) {}
HybridTracer::HybridTracer(const HybridTracer& other)
    : state_(std::make_unique<State>(other.state_->scene, other.state_->tree, other.state_->buffer)) {}
HybridTracer::~HybridTracer() = default;
std::size_t HybridTracer::bytes() const { return state_->tree->bytes(); }

void HybridTracer::trace(const Camera& camera, VisibilityMap& map, HybridStats* stats) {
  State& s = *state_;
  const auto start = std::chrono::steady_clock::now();
  ClipView view(s.scene, camera, 0, {});
  find_in_frame(view, *s.tree, s.in_window);
  const CoverBuffer cover(s.scene, camera, s.in_window, s.buffer > 0 ? s.buffer : chosen_size(s.in_window.size(), 1));
  ShadowFinder finder(s.scene, *s.tree);
  s.fragments.clear();
  s.seen.clear();
  for (const SurfaceId surface : s.in_window) s.clip(surface, view, cover, finder);
  s.sky.fill(view, s.seen, s.fragments);
  s.stitcher.stitch(s.scene, camera, view.window(),
                    {view.frame()[Window::left].line, view.frame()[Window::right].line,
                     view.frame()[Window::bottom].line, view.frame()[Window::top].line},
                    view.table(), s.fragments, map);
  if (!stats) return;
  *stats = {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            static_cast<std::uint32_t>(s.in_window.size()),
            static_cast<std::uint32_t>(s.fragments.fragments.size()),
            static_cast<std::uint32_t>(map.faces.size()),
            static_cast<std::uint32_t>(map.edges.size()),
            static_cast<std::uint32_t>(map.vertices.size())};
}

}  // namespace sightline
