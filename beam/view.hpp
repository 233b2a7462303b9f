// What the engines share: one camera's sightlines, regions and fragments. Internal to beam/.
#pragma once

#include <memory>

#include "beam/reach.hpp"
#include "beam/region.hpp"
#include "visibility_map/fragment.hpp"

namespace sightline {

/// The view of one eye while it is traced.
struct View {
  View(const Scene& s, const PlaneTable& planes, double max_distance)
      : scene(s), table(planes), reach(s, max_distance) {}

  const Scene& scene;
  SightlineTable table;
  Reach reach;
  Regions regions;
  Fragments fragments;
  std::uint32_t beams = 0, cells = 0;
  double left_out = 0;  // a bound on the solid angle that was not followed

  /// Is a surface opaque seen from that side of its plane?
  bool opaque(SurfaceId s, Sign eye_side) const {
    return !scene.options().one_sided || scene.surfaces()[s].flipped == (eye_side < 0);
  }
  bool in_reach(SurfaceId s) const { return reach.holds(scene.surfaces()[s].polygon); }
  /// A region in which the surfaces of `on` are seen that are in reach and opaque from the eye's side; none: nothing
  /// is.
  void see(Regions::Region region, std::span<const SurfaceId> on, Sign eye_side);

 private:
  std::vector<SightlineRef> lines_;
  std::vector<SurfaceId> on_;
};

/// A way to find out what is seen.
class Engine {
 public:
  Engine(const Scene& scene, const PlaneTable& planes, double max_distance) : view(scene, planes, max_distance) {}
  virtual ~Engine() = default;
  virtual std::unique_ptr<Engine> copy() const = 0;
  /// Forgets what was seen from another eye.
  void start(const GridPoint& eye) {
    view.table.reset(view.table.planes(), eye);
    view.reach.start(eye, view.table.eye_approx());
    view.fragments.clear();
    view.beams = view.cells = 0;
    view.left_out = 0;
    begin();
  }
  /// Fills a convex part of the view with fragments, given by its sides, their normals pointing inwards, in
  /// counter-clockwise order. `ahead` is a direction such that nothing of it lies behind the plane through the eye that
  /// it is normal to.
  virtual void fill(std::span<const SightlineRef> window, const glm::dvec3& ahead) = 0;

  View view;

 private:
  /// For a new eye: the view's table has it already.
  virtual void begin() = 0;
};

}  // namespace sightline
