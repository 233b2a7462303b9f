// What may hide parts of one surface from one camera. For this folder's own use.
#pragma once

#include "clip/box_tree.hpp"
#include "clip/outline.hpp"
#include "clip/view.hpp"

namespace sightline {

/// A convex part of a surface's plane that a camera does not see: where a surface in front of it throws its shadow from
/// the eye, where one in the same plane with a lower index lies, or where an exterior region does. The intersection of
/// the inner sides of its lines; with none, all of the plane.
///
/// The shadow of a surface O from eye e is what lies beyond O's plane, seen from e, and within the wedges of O's edges:
/// a polyhedron whose sides are planes of the scene and planes through the eye. So surfaces that cross need no
/// cutting beforehand: where O's plane cuts the figure is one side of its shadow.
struct Shadow {
  std::vector<OutlineSide> lines;
  std::vector<glm::dvec3> rough;  // the same in doubles, found from the scene alone
  glm::dvec3 low{-1}, high{1};    // unit coordinates: what it hides of the surface lies within
};

/// A sightline as a plane for BoxTree: what lies in its front is inside.
RoughPlane as_plane(const SightlineTable& table, SightlineRef line);

/// Ascending, every surface that reaches into what the camera sees, and others near it.
void find_in_frame(const ClipView& view, const BoxTree& tree, std::vector<SurfaceId>& found);

/// A surface in the plane of another, and where it lies there.
struct Coplanar {
  SurfaceId surface;
  Shadow figure;
};

/// Finds them, and the lines of the camera's frame, for one surface and camera after the other.
class ShadowFinder {
 public:
  ShadowFinder(const Scene& scene, const BoxTree& tree) : scene_(scene), tree_(tree) {}

  enum Outcome { unseen, seen };
  /// `unseen`: all of the surface lies outside of the frame, or behind, or edge-on. Otherwise all that may hide a part
  /// of its inside, and the lines of the frame that it is not wholly inside of.
  Outcome find(SurfaceId surface, ClipView& view, Outlines& outlines, std::vector<OutlineSide>& frame,
               std::vector<Shadow>& shadows);
  /// For the surface that find() has just looked at: those of higher index that face the camera in its plane and may
  /// have a part of its inside in common. They are not seen where it is, but coincide with it.
  void find_coplanar(ClipView& view, Outlines& outlines, std::vector<Coplanar>& coplanar);

 private:
  bool may_hide(const Surface& other, SurfaceId other_id, ClipView& view);
  bool may_meet(const Surface& other, ClipView& view);
  bool add_line(Shadow& shadow, const PlaneLines::Cut& cut, const ClipSide& name, const glm::dvec3& rough,
                Outlines& outlines) const;
  bool make(SurfaceId other, ClipView& view, Outlines& outlines, Shadow& shadow) const;
  glm::dvec3 rough(const glm::dvec3& normal, double offset, const Outlines& outlines) const;

  const Scene& scene_;
  const BoxTree& tree_;
  SurfaceId surface_ = 0;
  std::vector<SightlineRef> wedges_;  // of the surface, inwards
  std::vector<PointId> corners_;      // of the surface; empty if one of them is no point of the scene
  std::vector<PointId> other_corners_;
  std::vector<RoughPlane> volume_;
  std::vector<SurfaceId> found_;
};

}  // namespace sightline
