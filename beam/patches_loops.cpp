// The loops of a patch's boundary: which of them bound one region.
#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "beam/patches.hpp"

namespace sightline {

/// The loops of a patch whose corners are all different rays; false where they are not.
bool Patches::find_loops(const Patch& patch) {
  std::uint32_t again = 0;
  if (!index_sides(patch, again)) return false;
  const auto all = sides(patch);
  loops_.clear();
  loop_sides_.clear();
  for (std::uint32_t start = 0; start < all.size(); ++start) {
    if (corners_[root(all[start].from)].walk != walk_) continue;
    Loop loop{static_cast<std::uint32_t>(loop_sides_.size()), 0};
    std::uint32_t k = start;
    do {
      corners_[root(all[k].from)].walk = 0;
      loop_sides_.push_back(patch.first + k);
      ++loop.count;
      const Corner& next = corners_[root(all[k].to)];
      if (next.walk != walk_) break;
      k = next.at;
    } while (true);
    if (root(all[k].to) != root(all[start].from)) return false;
    loops_.push_back(loop);
  }
  return true;
}

void Patches::add_loop(const Loop& loop) {
  for (std::uint32_t k = loop.first; k < loop.first + loop.count; ++k) {
    const FragmentSide side = sides_[loop_sides_[k]];
    add_side(side.line, side.from, side.to);
  }
}

/// Twice the area of a loop on the frame: positive for one that goes round what is inside, negative for a hole, 0 where
/// doubles do not tell. The frame is seen with x to the left, which turns signs.
///
/// Let E bound what the differences d from the first corner are off. A cross product of two is within 2 E^2 and E times
/// the sum of their coordinates' sizes, twice that with its own rounding; n terms are summed within n 2^-52 of their
/// sizes.
double Patches::loop_area(const Loop& loop) const {
  glm::dvec2 first{0}, last{0};
  double twice = 0, sizes = 0, reach = 0, most = 0;
  for (std::uint32_t k = 0; k < loop.count; ++k) {
    glm::dvec2 at{0};
    double error = 0;
    if (!frame_->place_corner(corners_[sides_[loop_sides_[loop.first + k]].from].ray, at, error)) return 0;
    if (k == 0) first = at;
    const glm::dvec2 d = at - first;
    const double size = std::abs(d.x) + std::abs(d.y);
    most = std::max(most, 2 * error + 0x1p-52 * size);
    reach += 2 * size;  // each is in two terms
    twice += last.x * d.y - last.y * d.x;
    sizes += std::abs(last.x * d.y) + std::abs(last.y * d.x);
    last = d;
  }
  const double n = loop.count, bound = 2 * most * reach + 4 * n * most * most + n * 0x1p-51 * sizes;
  return std::abs(twice) > bound ? -twice : 0;
}

/// The outer loop that goes most closely round a hole; `none` where doubles do not tell.
std::size_t Patches::loop_around(const Loop& hole, std::span<const Patch> outer) const {
  const glm::dvec3& ray = corners_[sides_[loop_sides_[hole.first]].from].ray;
  std::size_t best = none;
  for (std::size_t k = 0; k < outer.size(); ++k) {
    bool known = false;
    const bool inside = odd(outer[k], ray, known);
    if (!known) return none;
    if (inside && (best == none || outer_area_[k] < outer_area_[best])) best = k;
  }
  return best;
}

bool Patches::connected_parts(const Patch& patch, std::vector<Patch>& parts) {
  if (!find_loops(patch)) return false;
  parts.clear();
  outer_area_.clear();
  holes_.clear();
  for (const Loop& loop : loops_) {
    const double area = loop_area(loop);
    if (area == 0) return false;
    if (area < 0) {
      holes_.push_back(loop);
      continue;
    }
    const auto first = static_cast<std::uint32_t>(sides_.size());
    add_loop(loop);
    parts.push_back(since(first));
    outer_area_.push_back(area);
  }
  if (parts.size() == 1) {
    parts[0] = patch;
    return true;
  }
  owner_.clear();
  for (const Loop& hole : holes_) {
    owner_.push_back(loop_around(hole, parts));
    if (owner_.back() == none) return false;
  }
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (std::find(owner_.begin(), owner_.end(), part) == owner_.end()) continue;
    const auto first = static_cast<std::uint32_t>(sides_.size());
    for (std::uint32_t k = parts[part].first; k < parts[part].first + parts[part].count; ++k) {
      const FragmentSide side = sides_[k];
      add_side(side.line, side.from, side.to);
    }
    for (std::size_t h = 0; h < holes_.size(); ++h) {
      if (owner_[h] == part) add_loop(holes_[h]);
    }
    parts[part] = since(first);
  }
  return true;
}

}  // namespace sightline
