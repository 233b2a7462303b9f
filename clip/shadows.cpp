#include "clip/shadows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

/// The scene points in a surface's corners; none at all if one corner is no scene point.
void corners_of(const Scene& scene, const Surface& s, std::vector<PointId>& corners) {
  corners.clear();
  for (const SurfaceEdge& e : scene.edges(s)) {
    if (e.corner == none) {
      corners.clear();
      return;
    }
    corners.push_back(e.corner);
  }
}

}  // namespace

// Normals within 2^-53, the eye within 2^-53 of its size E: the value n.(x - e) is off by less than 24 2^-53 (E + 1),
// as in SightlineTable::side; the products n.e and n.x here are rounded as much again.
RoughPlane as_plane(const SightlineTable& table, SightlineRef line) {
  const glm::dvec3 n = table.approx(line.id) * static_cast<double>(line.sign);
  const glm::dvec3& e = table.eye_approx();
  const double reach = std::max({std::abs(e.x), std::abs(e.y), std::abs(e.z)});
  return {n, glm::dot(n, e), 0x1p-47 * (reach + 1)};
}

void find_in_frame(const ClipView& view, const BoxTree& tree, std::vector<SurfaceId>& found) {
  std::vector<RoughPlane> volume;
  for (const NamedLine& side : view.frame()) volume.push_back(as_plane(view.table(), side.line));
  found.clear();
  tree.find(volume, found);
}

ShadowFinder::Outcome ShadowFinder::find(SurfaceId surface, ClipView& view, Outlines& outlines,
                                         std::vector<OutlineSide>& frame, std::vector<Shadow>& shadows) {
  frame.clear();
  shadows.clear();
  const Surface& s = scene_.surfaces()[surface];
  if (!view.faces(s)) return unseen;
  surface_ = surface;
  SightlineTable& table = view.table();
  corners_of(scene_, s, corners_);
  volume_.clear();

  for (const NamedLine& side : view.frame()) {
    bool in = corners_.empty(), out = corners_.empty();
    for (const PointId p : corners_) {
      const Sign at = table.side(side.line, p);
      in = in || at > 0;
      out = out || at < 0;
    }
    if (!in) return unseen;
    volume_.push_back(as_plane(table, side.line));
    if (!out) continue;
    const PlaneLines::Cut cut = outlines.lines().of_sightline(table, side.line);
    if (cut.line.id != none) {
      frame.push_back({cut.line, outlines.name(side.name)});
    } else if (cut.side < 0) {
      return unseen;
    }
  }

  const ApproxPlane& own = scene_.planes().approx(s.plane);
  const double front = table.eye_side(s.plane);
  volume_.push_back({front * glm::dvec3(own.n[0], own.n[1], own.n[2]), front * own.d, 0x1p-46});
  wedges_.clear();
  for (const SurfaceEdge& e : scene_.edges(s)) {
    wedges_.push_back(view.wedge(s, e));
    volume_.push_back(as_plane(table, wedges_.back()));
  }
  found_.clear();
  tree_.find(volume_, found_);

  for (const std::vector<NamedLine>& hole : view.holes()) {
    Shadow shadow;
    bool any = true;
    for (const NamedLine& side : hole) {
      const glm::dvec3 n = table.approx(side.line.id) * static_cast<double>(side.line.sign);
      any = any && add_line(shadow, outlines.lines().of_sightline(table, side.line), side.name,
                            rough(n, glm::dot(n, table.eye_approx()), outlines), outlines);
    }
    if (any) shadows.push_back(std::move(shadow));
  }
  for (const SurfaceId other : found_) {
    if (other == surface || !may_hide(scene_.surfaces()[other], other, view)) continue;
    Shadow shadow;
    if (make(other, view, outlines, shadow)) shadows.push_back(std::move(shadow));
  }
  return seen;
}

void ShadowFinder::find_coplanar(ClipView& view, Outlines& outlines, std::vector<Coplanar>& coplanar) {
  coplanar.clear();
  for (const SurfaceId id : found_) {
    const Surface& other = scene_.surfaces()[id];
    if (id <= surface_ || other.plane != scene_.surfaces()[surface_].plane || !view.faces(other)) continue;
    corners_of(scene_, other, other_corners_);
    Coplanar found{id, {}};
    if (may_meet(other, view) && make(id, view, outlines, found.figure)) coplanar.push_back(std::move(found));
  }
}

/// Exact, where it says no. Corners of both are scene points nearly always; where one is not, the cuts will tell.
bool ShadowFinder::may_hide(const Surface& other, SurfaceId other_id, ClipView& view) {
  const Surface& s = scene_.surfaces()[surface_];
  if (!view.faces(other)) return false;
  SightlineTable& table = view.table();
  corners_of(scene_, other, other_corners_);
  if (other.plane == s.plane) {
    if (other_id > surface_) return false;
  } else {
    // Some of it in front of our plane, and some of us beyond its plane.
    const Sign front = table.eye_side(s.plane), before = table.eye_side(other.plane);
    const auto in_front = [&](PointId p) { return point_side(scene_.planes(), p, s.plane) == front; };
    if (!other_corners_.empty() && std::none_of(other_corners_.begin(), other_corners_.end(), in_front)) return false;
    const auto beyond = [&](PointId p) { return point_side(scene_.planes(), p, other.plane) == -before; };
    if (!corners_.empty() && std::none_of(corners_.begin(), corners_.end(), beyond)) return false;
  }
  return may_meet(other, view);
}

/// Of the other surface, whose corners are at hand: are they seen apart from ours, as one of the edges tells?
bool ShadowFinder::may_meet(const Surface& other, ClipView& view) {
  SightlineTable& table = view.table();
  const auto inside_of = [&](SightlineRef line) {
    return [&table, line](PointId p) { return table.side(line, p) > 0; };
  };
  if (!other_corners_.empty()) {
    for (const SightlineRef wedge : wedges_) {
      if (std::none_of(other_corners_.begin(), other_corners_.end(), inside_of(wedge))) return false;
    }
  }
  if (!corners_.empty()) {
    for (const SurfaceEdge& e : scene_.edges(other)) {
      if (std::none_of(corners_.begin(), corners_.end(), inside_of(view.wedge(other, e)))) return false;
    }
  }
  return true;
}

glm::dvec3 ShadowFinder::rough(const glm::dvec3& normal, double offset, const Outlines& outlines) const {
  // As PlaneLines makes lines, in doubles.
  const ApproxPlane& own = scene_.planes().approx(scene_.surfaces()[surface_].plane);
  const int k = outlines.lines().axis(), i = (k + 1) % 3, j = (k + 2) % 3;
  const double f = normal[k] / own.n[k];
  return {normal[i] - f * own.n[i], normal[j] - f * own.n[j], f * own.d - offset};
}

/// False: nothing lies in the shadow.
bool ShadowFinder::add_line(Shadow& shadow, const PlaneLines::Cut& cut, const ClipSide& name, const glm::dvec3& rough,
                            Outlines& outlines) const {
  if (cut.line.id == none) return cut.side > 0;
  shadow.lines.push_back({cut.line, outlines.name(name)});
  shadow.rough.push_back(rough);
  return true;
}

/// False: it hides nothing.
bool ShadowFinder::make(SurfaceId other, ClipView& view, Outlines& outlines, Shadow& shadow) const {
  const Surface &s = scene_.surfaces()[surface_], &o = scene_.surfaces()[other];
  SightlineTable& table = view.table();
  PlaneLines& lines = outlines.lines();
  const auto turned = [](PlaneLines::Cut cut, Sign sign) {
    return sign > 0 ? cut : PlaneLines::Cut{cut.line.id == none ? cut.line : -cut.line, -cut.side};
  };
  if (o.plane == s.plane) {
    for (const SurfaceEdge& e : scene_.edges(o)) {
      const ApproxPlane& wall = scene_.planes().approx(e.wall);
      const double in = e.inside;
      if (!add_line(shadow, turned(lines.of_plane(e.wall), e.inside), {ClipSide::edge, none, e.a, e.b},
                    rough(in * glm::dvec3(wall.n[0], wall.n[1], wall.n[2]), in * wall.d, outlines), outlines))
        return false;
    }
    return true;
  }
  const Sign before = table.eye_side(o.plane);
  const ApproxPlane& plane = scene_.planes().approx(o.plane);
  const double beyond = -before;
  if (!add_line(shadow, turned(lines.of_plane(o.plane), -before), {ClipSide::intersection, none, other, none},
                rough(beyond * glm::dvec3(plane.n[0], plane.n[1], plane.n[2]), beyond * plane.d, outlines), outlines))
    return false;
  for (const SurfaceEdge& e : scene_.edges(o)) {
    const glm::dvec3 eye = table.eye_approx();
    const glm::dvec3 n =
        glm::cross(scene_.points().approx(e.a) - eye, scene_.points().approx(e.b) - eye) * static_cast<double>(-before);
    if (!add_line(shadow, lines.of_sightline(table, view.wedge(o, e)), {ClipSide::wedge, view.index(), e.a, e.b},
                  rough(n, glm::dot(n, eye), outlines), outlines))
      return false;
  }
  return true;
}

}  // namespace sightline
