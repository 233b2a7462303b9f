#include "clip/outline.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/surface_list.hpp"

namespace sightline {

Outlines::Outlines(const Scene& scene, SurfaceId surface)
    : scene_(scene),
      surface_(scene.surfaces()[surface]),
      lines_(scene.planes(), surface_.plane, steepest_axis(scene.planes().approx(surface_.plane))) {}

std::uint32_t Outlines::name(const ClipSide& side) {
  names_.push_back(side);
  return static_cast<std::uint32_t>(names_.size() - 1);
}

Outline Outlines::whole() {
  const auto edges = scene_.edges(surface_);
  const std::size_t n = edges.size();
  // Counter-clockwise from the plane's front; seen against the axis, the same only if the normal points along it.
  const bool forwards = scene_.planes().approx(surface_.plane).n[lines_.axis()] > 0;
  Outline o;
  for (std::size_t k = 0; k < n; ++k) {
    const SurfaceEdge& e = edges[forwards ? k : n - 1 - k];
    const SightlineRef wall = lines_.of_plane(e.wall).line;
    o.sides.push_back({e.inside > 0 ? wall : -wall, name({ClipSide::edge, none, e.a, e.b})});
  }
  for (std::size_t k = 0; k < n; ++k) {
    o.corner.push_back(lines_.corner(o.sides[k].line.id, o.sides[k + 1 == n ? 0 : k + 1].line.id));
  }
  return o;
}

int Outlines::sides(const Outline& o, SightlineRef line) {
  sign_.resize(o.size());
  int found = 0;
  for (std::size_t k = 0; k < o.size(); ++k) {
    const Sign s = side(o, k, line);
    sign_[k] = static_cast<std::int8_t>(s);
    found |= s < 0 ? 1 : s > 0 ? 2 : 0;
  }
  return found;
}

void Outlines::split(const Outline& o, OutlineSide by, Outline& outside, Outline& inside) {
  const std::size_t n = o.size();
  for (const Sign half : {-1, 1}) {
    Outline& out = half < 0 ? outside : inside;
    out.sides.clear();
    out.corner.clear();
    const OutlineSide cut{half < 0 ? -by.line : by.line, by.name};
    for (std::size_t k = 0; k < n; ++k) {
      const int from = half * sign_[k == 0 ? n - 1 : k - 1], to = half * sign_[k];
      if (from <= 0 && to <= 0) continue;
      out.sides.push_back(o.sides[k]);
      if (to > 0) {
        out.corner.push_back(o.corner[k]);
        continue;
      }
      // Here it leaves: the cut follows, as far as the side that comes back.
      out.corner.push_back(to == 0 ? o.corner[k] : lines_.corner(o.sides[k].line.id, cut.line.id));
      std::size_t back = k + 1 == n ? 0 : k + 1;
      while (half * sign_[back] <= 0) back = back + 1 == n ? 0 : back + 1;
      const std::size_t before = back == 0 ? n - 1 : back - 1;
      out.sides.push_back(cut);
      out.corner.push_back(sign_[before] == 0 ? o.corner[before] : lines_.corner(cut.line.id, o.sides[back].line.id));
    }
  }
}

bool Outlines::unite(Outline& a, std::size_t i, const Outline& b, std::size_t k) {
  const std::size_t n = a.size(), m = b.size();
  if (a.sides[i].line != -b.sides[k].line) return false;
  // The side runs from corner a0 to corner i in a, and from b0 to k in b: backwards.
  const std::size_t a0 = (i + n - 1) % n, a1 = (i + 1) % n, b0 = (k + m - 1) % m, b1 = (k + 1) % m;
  if (a.corner[a0] != b.corner[k] || a.corner[i] != b.corner[b0]) return false;
  const SightlineRef here = a.sides[i].line, into = a.sides[a0].line, on = b.sides[b1].line, back = b.sides[b0].line,
                     out = a.sides[a1].line;
  if (lines_.order(into, here, on) != 0 || lines_.order(here, out, back) != 0) return false;
  // At both ends of what goes, one's side is followed by the other's: it must turn left, or go straight on.
  const bool straight_on = into == on, straight_out = back == out;
  if (!straight_on && lines_.turn(into, on) <= 0) return false;
  if (!straight_out && lines_.turn(back, out) <= 0) return false;
  Outline u;
  for (std::size_t s = 1; s < n; ++s) {
    u.sides.push_back(a.sides[(i + s) % n]);
    u.corner.push_back(a.corner[(i + s) % n]);
  }
  if (straight_on) u.corner.back() = b.corner[b1];  // one side instead of two
  for (std::size_t s = straight_on ? 2 : 1; s < m; ++s) {
    u.sides.push_back(b.sides[(k + s) % m]);
    u.corner.push_back(b.corner[(k + s) % m]);
  }
  if (straight_out) {  // the last side goes on as the first
    u.sides.pop_back();
    u.corner.pop_back();
  }
  a = std::move(u);
  return true;
}

double Outlines::area(const Outline& o) const {
  glm::dvec3 sum{0, 0, 0};
  for (std::size_t k = 2; k < o.size(); ++k)
    sum += glm::cross(o.corner[k - 1] - o.corner[0], o.corner[k] - o.corner[0]);
  return glm::length(sum) / 2;
}

}  // namespace sightline
