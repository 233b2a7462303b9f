#include "clip/sky.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace sightline {
namespace {

constexpr std::size_t few = 6;  // cones by which a region is cut at once

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

void Sky::fill(ClipView& view, std::span<const SurfaceId> surfaces, Fragments& fragments) {
  view_ = &view;
  fragments_ = &fragments;
  const Camera& c = view.camera();
  const glm::dvec3 f = c.forward / largest(c.forward), r = c.right / largest(c.forward), u = c.up / largest(c.forward);
  frame_[0] = glm::cross(u, f);
  frame_[1] = glm::cross(f, r);
  frame_[2] = glm::cross(r, u);
  cones_.clear();
  lines_.clear();
  points_.clear();
  for (const SurfaceId s : surfaces) add_cone(s);

  // Counter-clockwise as an ordinary camera sees it; a mirrored one has its right side on the eye's left.
  const bool mirrored = view.window().handedness() < 0;
  Region window;
  for (const Window::Side side : {Window::bottom, mirrored ? Window::left : Window::right, Window::top,
                                  mirrored ? Window::right : Window::left}) {
    window.push_back(view.frame()[side].line);
  }
  std::vector<std::uint32_t> all(cones_.size());
  std::iota(all.begin(), all.end(), 0u);
  divide(window, all, static_cast<int>(std::bit_width(all.size())) + 4);
}

void Sky::add_cone(SurfaceId surface) {
  const Scene& scene = view_->scene();
  const Surface& s = scene.surfaces()[surface];
  Cone cone{static_cast<std::uint32_t>(lines_.size()), s.edge_count, static_cast<std::uint32_t>(points_.size()), 0, {}};
  glm::dvec3 middle{0};
  for (const SurfaceEdge& e : scene.edges(s)) {
    lines_.push_back(view_->wedge(s, e));
    if (e.corner != none) points_.push_back(e.corner);
    const glm::dvec3 at = scene.points().approx(e.a) - view_->table().eye_approx();
    middle += at / std::max(largest(at), 0x1p-100);
  }
  cone.point_count = static_cast<std::uint32_t>(points_.size()) - cone.first_point;
  if (cone.point_count < s.edge_count) {
    points_.resize(cone.first_point);
    cone.point_count = 0;
  }
  const double ahead = glm::dot(frame_[2], middle);
  cone.middle = glm::dvec2(glm::dot(frame_[0], middle), glm::dot(frame_[1], middle)) / ahead;
  if (!(std::abs(cone.middle.x) < 1e3 && std::abs(cone.middle.y) < 1e3)) cone.middle = {0, 0};
  cones_.push_back(cone);
}

void Sky::divide(const Region& region, std::span<const std::uint32_t> cones, int halvings) {
  std::vector<std::uint32_t> near;
  for (const std::uint32_t k : cones) {
    const Place p = place(region, cones_[k]);
    if (p == Place::all) return;
    if (p == Place::meets) near.push_back(k);
  }
  if (near.size() > few && halvings > 0) {
    Region front, behind;
    if (halve(region, near, front, behind)) {
      divide(front, near, halvings - 1);
      divide(behind, near, halvings - 1);
      return;
    }
  }
  for (std::size_t next = 0; next < near.size(); ++next) {
    const Cone& cone = cones_[near[next]];
    Region inside = region;
    std::vector<Region> outside;
    bool any = true;
    for (std::uint32_t k = cone.first_line; any && k < cone.first_line + cone.line_count; ++k) {
      const int where = sides(inside, lines_[k]);
      any = where != 1;
      if (where != 3) continue;
      Region front;
      outside.emplace_back();
      split(inside, lines_[k], front, outside.back());
      inside = std::move(front);
    }
    if (!any) continue;
    for (const Region& rest : outside) divide(rest, std::span(near).subspan(next + 1), 0);
    return;
  }
  fragments_->add_convex({region.data(), region.size()}, {});
}

/// By a line on which the frame's s or t is about what it is in the middle of the cones. Any line would do.
bool Sky::halve(const Region& region, std::vector<std::uint32_t>& cones, Region& front, Region& behind) {
  glm::dvec2 low{1e3}, high{-1e3};
  for (const std::uint32_t k : cones) {
    low = glm::min(low, cones_[k].middle);
    high = glm::max(high, cones_[k].middle);
  }
  const int axis = high.x - low.x > high.y - low.y ? 0 : 1;
  const auto middle = cones.begin() + static_cast<std::ptrdiff_t>(cones.size() / 2);
  std::nth_element(cones.begin(), middle, cones.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cones_[a].middle[axis] < cones_[b].middle[axis]; });
  glm::dvec3 n = frame_[axis] - cones_[*middle].middle[axis] * frame_[2];
  n *= 0x1p30 / largest(n);
  if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.z)) return false;
  std::uint64_t words[3];
  for (int k = 0; k < 3; ++k) words[k] = static_cast<std::uint64_t>(std::llround(n[k]));
  const SightlineRef line = view_->table().of_normal(words, 1);
  if (sides(region, line) != 3) return false;
  split(region, line, front, behind);
  return true;
}

/// Exact where it says `apart` or `all`. Two convex figures whose insides are apart are parted by a side of one.
Sky::Place Sky::place(const Region& region, const Cone& cone) {
  bool all = true;
  for (std::uint32_t k = cone.first_line; k < cone.first_line + cone.line_count; ++k) {
    const int where = sides(region, lines_[k]);
    if (!(where & 2)) return Place::apart;
    all = all && !(where & 1);
  }
  if (all) return Place::all;
  const auto points = std::span(points_).subspan(cone.first_point, cone.point_count);
  if (points.empty()) return Place::meets;
  for (const SightlineRef side : region) {
    if (std::none_of(points.begin(), points.end(), [&](PointId p) { return view_->table().side(side, p) > 0; }))
      return Place::apart;
  }
  return Place::meets;
}

/// Bit 0: corners behind the line, bit 1: in front.
int Sky::sides(const Region& region, SightlineRef line) {
  sign_.resize(region.size());
  int found = 0;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const SightlineRef next = region[k + 1 == region.size() ? 0 : k + 1];
    const Sign s = view_->table().order(next, region[k], line);
    sign_[k] = static_cast<std::int8_t>(s);
    found |= s < 0 ? 1 : s > 0 ? 2 : 0;
  }
  return found;
}

void Sky::split(const Region& region, SightlineRef line, Region& front, Region& behind) const {
  for (const Sign half : {1, -1}) {
    Region& out = half > 0 ? front : behind;
    out.clear();
    for (std::size_t k = 0; k < region.size(); ++k) {
      const int from = half * sign_[k == 0 ? region.size() - 1 : k - 1], to = half * sign_[k];
      if (from <= 0 && to <= 0) continue;
      out.push_back(region[k]);
      if (to <= 0) out.push_back(half > 0 ? line : -line);
    }
  }
}

}  // namespace sightline
