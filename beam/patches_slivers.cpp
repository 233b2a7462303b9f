// Parts of patches that are too narrow to be followed.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "beam/patches.hpp"

namespace sightline {

SightlineRef Patches::middle_line(const Patch& patch) const {
  SightlineRef best = sides(patch).front().line;
  int most = -1;
  for (const FragmentSide& side : sides(patch)) {
    const glm::dvec3& n = table_->approx(side.line.id);
    int front = 0, behind = 0;
    for (const FragmentSide& other : sides(patch)) {
      const double value = glm::dot(n, corners_[other.from].ray);
      front += value > 0x1p-30;
      behind += value < -0x1p-30;
    }
    if (std::min(front, behind) <= most) continue;
    most = std::min(front, behind);
    best = side.line;
  }
  return best;
}

/// How far the loop's corners lie from the line of its longest side, as the sine of an angle, all rounding included
/// (of unit rays and normals, below 2^-46 where corners are as accurate as make_corner makes them); and on which side.
void Patches::measure(Loop& loop, double narrow) {
  const std::span loop_sides = std::span(loop_sides_).subspan(loop.first, loop.count);
  const auto unit = [&](std::uint32_t corner) { return glm::normalize(corners_[corner].ray); };
  double longest = -1;
  for (const std::uint32_t k : loop_sides) {
    const double length = glm::distance(unit(sides_[k].from), unit(sides_[k].to));
    if (length <= longest) continue;
    longest = length;
    loop.line = sides_[k].line;
  }
  const glm::dvec3 n = glm::normalize(table_->approx(loop.line.id));
  const glm::dvec3 first = unit(sides_[loop_sides[0]].from);
  double width = 0, reach = 0;
  for (const std::uint32_t k : loop_sides) {
    const glm::dvec3 ray = unit(sides_[k].from);
    width = std::max(width, std::abs(glm::dot(n, ray)));
    reach = std::max(reach, glm::distance(first, ray));
  }
  loop.width = width + 0x1p-46;
  // Within this far of its first corner: an arc is at most pi/2 times its chord.
  loop.length = std::min(3.2, 3.2 * (reach + 0x1p-46));
  if (!(loop.width < narrow)) return;
  Sign side = 0;
  const glm::dvec3 inwards = table_->approx(loop.line.id) * static_cast<double>(loop.line.sign);
  ++stamp_;
  for (const std::uint32_t k : loop_sides) {
    const Sign sign = side_of(sides_[k].from, loop.line, inwards);
    if (sign * side < 0) return;  // it winds around that line: followed
    if (sign != 0) side = sign;
  }
  loop.kind = side > 0 ? Loop::narrow : Loop::narrow_hole;
}

/// Does all of a loop lie in the strip along another's line that holds that one?
bool Patches::in_strip(const Loop& loop, const Loop& strip) const {
  const glm::dvec3 n = glm::normalize(table_->approx(strip.line.id));
  const std::span loop_sides = std::span(loop_sides_).subspan(loop.first, loop.count);
  return std::all_of(loop_sides.begin(), loop_sides.end(), [&](std::uint32_t k) {
    return std::abs(glm::dot(n, glm::normalize(corners_[sides_[k].from].ray))) <= strip.width + 0x1p-46;
  });
}

double Patches::part_slivers(Patch& patch, double angle, std::vector<Patch>& slivers) {
  if (patch.empty() || !find_loops(patch)) return 0;
  bool any = false;
  for (Loop& loop : loops_) {
    measure(loop, std::sin(angle));
    any = any || loop.kind == Loop::narrow;
  }
  if (!any) return 0;
  double area = 0;
  for (Loop& loop : loops_) {
    if (loop.kind != Loop::narrow) continue;
    const auto hides = [&](const Loop& other) { return other.kind == Loop::narrow_hole && in_strip(other, loop); };
    if (std::any_of(loops_.begin(), loops_.end(), hides)) continue;
    loop.kind = Loop::parted;
    area += 1.001 * loop.width * loop.length;  // the angle is that much longer than its sine at most: it is narrow
    const auto first = static_cast<std::uint32_t>(sides_.size());
    add_loop(loop);
    slivers.push_back(since(first));
  }
  if (area == 0) return 0;
  const auto first = static_cast<std::uint32_t>(sides_.size());
  for (const Loop& loop : loops_) {
    if (loop.kind != Loop::parted) add_loop(loop);
  }
  patch = since(first);
  return area;
}

}  // namespace sightline
