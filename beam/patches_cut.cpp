// Cutting patches along lines.
#include <algorithm>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "beam/patches.hpp"
#include "exact/tally.hpp"

namespace sightline {

// filter_order with the cross product of the first two taken beforehand: the same roundings, the same bound.
Sign Patches::side_of(std::uint32_t corner, SightlineRef line, const glm::dvec3& normal) {
  constexpr double bound = 64 * 0x1p-53;
  Corner& c = corners_[corner];
  if (c.stamp == stamp_) return c.sign;
  c.stamp = stamp_;
  const double det = c.ray.x * normal.x + c.ray.y * normal.y + c.ray.z * normal.z;
  if (det > bound || det < -bound) [[likely]] {
    ++tally().filter;
    return c.sign = det > 0 ? 1 : -1;
  }
  return c.sign = exact_side(c, line);
}

void Patches::take_up(const Patch& patch) {
  parts_.clear();
  crossings_.clear();
  ties_ = false;
  for (std::uint32_t k = 0; k < patch.count; ++k) {
    const FragmentSide& side = sides_[patch.first + k];
    parts_.push_back({side.line, side.from, side.to, k, 0, 0});
  }
}

/// Where the parts' ends lie. Bit 0: some are behind the line; bit 1: in front.
int Patches::classify(SightlineRef line) {
  ++stamp_;
  const glm::dvec3 normal = table_->approx(line.id) * static_cast<double>(line.sign);
  int found = 0;
  for (Part& part : parts_) {
    part.at_from = side_of(part.from, line, normal);
    part.at_to = side_of(part.to, line, normal);
    found |= part.at_from > 0 || part.at_to > 0 ? 2 : 0;
    found |= part.at_from < 0 || part.at_to < 0 ? 1 : 0;
  }
  return found;
}

/// A part with normal n that comes to the line from the front, or leaves it to the back, meets it in the ray
/// n_line x n, and there the patch begins as one goes along the line with its front on the left; the other way round
/// in n x n_line, where the patch ends.
void Patches::add_event(const Part& part, SightlineRef line, bool begins, std::uint32_t corner, bool plus, bool minus) {
  const FragmentCorner& name = corners_[corner].name;
  const int step = begins ? 1 : -1;
  events_.push_back({begins ? part.line : -part.line, corner, name.low == line.id || name.high == line.id,
                     plus ? step : 0, minus ? step : 0});
}

/// Leaves in parts_ what lies in front of the classified line, closed along it; what lies behind goes to `behind`.
void Patches::clip(SightlineRef line, std::vector<Part>* behind) {
  events_.clear();
  std::size_t kept = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part part = parts_[k];
    if (part.at_from == 0 && part.at_to == 0) {  // along the line
      if (part.line.sign == line.sign) {
        parts_[kept++] = part;
      } else if (behind) {
        behind->push_back(part);
      }
    } else if (part.at_from >= 0 && part.at_to >= 0) {
      if (part.at_to == 0) add_event(part, line, true, part.to, true, false);
      if (part.at_from == 0) add_event(part, line, false, part.from, true, false);
      parts_[kept++] = part;
    } else if (part.at_from <= 0 && part.at_to <= 0) {
      if (part.at_from == 0) add_event(part, line, true, part.from, false, true);
      if (part.at_to == 0) add_event(part, line, false, part.to, false, true);
      if (behind) behind->push_back(part);
    } else {
      const bool begins = part.at_from > 0;
      const std::uint32_t corner = make_corner(begins ? part.line : -part.line, line);
      add_event(part, line, begins, corner, true, true);
      if (part.origin != none) crossings_.push_back({corner, part.origin});
      Part rest = part;
      (begins ? part.to : part.from) = corner;
      (begins ? rest.from : rest.to) = corner;
      parts_[kept++] = part;
      if (behind) behind->push_back(rest);
    }
  }
  parts_.resize(kept);
  add_caps(line);
}

/// Closes the parts along the line where the patch lies on both sides of it.
void Patches::add_caps(SightlineRef line) {
  if (events_.size() == 2 && events_[0].plus * events_[0].minus * events_[1].plus * events_[1].minus != 0 &&
      events_[0].plus != events_[1].plus) {
    const int first = events_[0].plus > 0 ? 0 : 1;
    parts_.push_back({line, events_[static_cast<std::size_t>(first)].corner,
                      events_[static_cast<std::size_t>(1 - first)].corner, none, 0, 0});
    return;
  }
  add_sorted_caps(line);
}

/// One corner for events in the same ray, with the line in its name.
std::uint32_t Patches::named_corner(std::size_t first, std::size_t end, SightlineRef line) {
  for (std::size_t k = first; k < end; ++k) {
    if (events_[k].named) return events_[k].corner;
  }
  const std::uint32_t corner = make_corner(events_[first].across, line);
  unite(corner, events_[first].corner);
  ties_ = true;
  events_[first].corner = corner;
  events_[first].named = true;
  return corner;
}

void Patches::add_sorted_caps(SightlineRef line) {
  // N x v comes after N x u where det(N, v, u) > 0.
  const auto after = [&](const Event& a, const Event& b) -> Sign {
    if (a.corner == b.corner || root(a.corner) == root(b.corner)) return 0;
    return table_->order(line, b.across, a.across);
  };
  for (std::size_t k = 1; k < events_.size(); ++k) {
    const Event event = events_[k];
    std::size_t j = k;
    while (j > 0) {
      const Sign sign = after(events_[j - 1], event);
      if (sign == 0 && events_[j - 1].corner != event.corner) {
        unite(events_[j - 1].corner, event.corner);
        ties_ = true;
      }
      if (sign >= 0) break;
      events_[j] = events_[j - 1];
      --j;
    }
    events_[j] = event;
  }
  int plus = 0, minus = 0;
  std::uint32_t from = none;
  for (std::size_t first = 0, end = 0; first < events_.size(); first = end) {
    const std::uint32_t ray = root(events_[first].corner);
    const bool before = plus == 1 && minus == 1;
    for (; end < events_.size() && root(events_[end].corner) == ray; ++end) {
      plus += events_[end].plus;
      minus += events_[end].minus;
    }
    if (plus < 0 || plus > 1 || minus < 0 || minus > 1) throw std::logic_error("trace: a patch that is not closed");
    const bool now = plus == 1 && minus == 1;
    if (!before && !now) continue;
    const std::uint32_t corner = named_corner(first, end, line);
    if (before) parts_.push_back({line, from, corner, none, 0, 0});
    from = corner;
  }
  if (plus != 0 || minus != 0) throw std::logic_error("trace: a patch that is not closed");
}

/// Where a corner of the figure touches a side that stays outside, this side ends, too: no side may pass through a
/// corner of another. Such a crossing is one ray with an end of a cap.
void Patches::add_stops() {
  stops_.clear();
  if (!ties_) return;
  for (const Crossing& c : crossings_) {
    const std::uint32_t part = part_of_[c.origin];
    if (part != none && (parts_[part].from == c.corner || parts_[part].to == c.corner)) continue;
    const std::uint32_t ray = root(c.corner);
    const auto ends_there = [&](const Part& cap) {
      return cap.origin == none && (root(cap.from) == ray || root(cap.to) == ray);
    };
    if (std::any_of(parts_.begin(), parts_.end(), ends_there)) stops_.push_back(c);
  }
}

/// What the figure leaves of a side of the patch.
void Patches::add_remainder(const FragmentSide& side, const FrameBox& box, std::uint32_t origin) {
  const std::uint32_t part = part_of_[origin];
  if (part != none) {
    const std::uint32_t from = parts_[part].from, to = parts_[part].to;
    if (from != side.from) add_side(side.line, side.from, from);
    if (to != side.to) add_side(side.line, to, side.to);
    return;
  }
  for (const Crossing& stop : stops_) {
    if (stop.origin != origin) continue;
    add_side(side.line, side.from, stop.corner);
    add_side(side.line, stop.corner, side.to);
    return;
  }
  sides_.push_back(side);
  boxes_.push_back(box);
}

bool Patches::carve_by_lines(const Patch& patch, std::span<const SightlineRef> lines, Patch& inside, Patch& outside) {
  take_up(patch);
  for (const SightlineRef line : lines) {
    const int found = classify(line);
    if (!(found & 2)) return false;
    if (found & 1) clip(line, nullptr);
  }
  part_of_.assign(patch.count, none);
  for (std::uint32_t k = 0; k < parts_.size(); ++k) {
    if (parts_[k].origin != none) part_of_[parts_[k].origin] = k;
  }
  add_stops();
  auto first = static_cast<std::uint32_t>(sides_.size());
  for (const Part& part : parts_) add_side(part.line, part.from, part.to);
  inside = since(first);
  first = static_cast<std::uint32_t>(sides_.size());
  for (std::uint32_t k = 0; k < patch.count; ++k) {
    const FragmentSide side = sides_[patch.first + k];
    const FrameBox box = boxes_[patch.first + k];
    add_remainder(side, box, k);
  }
  for (const Part& part : parts_) {
    if (part.origin == none) add_side(-part.line, part.to, part.from);
  }
  outside = since(first);
  return true;
}

}  // namespace sightline
