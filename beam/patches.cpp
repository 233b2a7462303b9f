#include "beam/patches.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {

void Patches::begin(const Scene& scene, SightlineTable& table, const Frame& frame, const ViewScale& scale) {
  scene_ = &scene;
  table_ = &table;
  frame_ = &frame;
  scale_ = scale;
  corners_.clear();
  sides_.clear();
  boxes_.clear();
  given_.clear();
  line_names_.clear();
  stamp_ = walk_ = 0;
}

std::uint32_t Patches::root(std::uint32_t corner) {
  while (corners_[corner].parent != corner) {
    corner = corners_[corner].parent = corners_[corners_[corner].parent].parent;
  }
  return corner;
}

void Patches::unite(std::uint32_t a, std::uint32_t b) {
  a = root(a);
  b = root(b);
  corners_[std::max(a, b)].parent = std::min(a, b);
}

void Patches::name_line(SightlineId line, const LineName& name) {
  if (line >= line_names_.size()) line_names_.resize(line + 1);
  LineName& known = line_names_[line];
  if (!known.known()) {
    known = name;
  } else if (known.cut != none && known.cut == name.cut && known.surface == name.surface) {
    // Another piece of the surface may reach an end of the cut.
    if (known.first == none) known.first = name.first;
    if (known.second == none) known.second = name.second;
  }
}

/// The ray n_line x n_across.
std::uint32_t Patches::make_corner(SightlineRef across, SightlineRef line) {
  const auto id = static_cast<std::uint32_t>(corners_.size());
  Corner& c = corners_.emplace_back();
  c.name = FragmentCorner::of(across, line);
  // Where the lines are all but parallel, their rounded normals say little about the ray.
  c.ray = glm::cross(table_->approx(c.name.low), table_->approx(c.name.high));
  if (std::max({std::abs(c.ray.x), std::abs(c.ray.y), std::abs(c.ray.z)}) < 0x1p-10) {
    c.ray = table_->corner(c.name.low, c.name.high);
  }
  if (c.name.sign < 0) c.ray = -c.ray;
  c.box = frame_->bounds(c.ray);
  c.parent = id;
  if (c.name.high < line_names_.size()) {
    c.place = common_place(*scene_, line_names_[c.name.low], line_names_[c.name.high]);
  }
  return id;
}

void Patches::add_side(SightlineRef line, std::uint32_t from, std::uint32_t to) {
  sides_.push_back({line, from, to});
  boxes_.push_back(corners_[from].box.around(corners_[to].box));
}

void Patches::set_side(std::uint32_t at, const FragmentSide& side) {
  sides_[at] = side;
  boxes_[at] = corners_[side.from].box.around(corners_[side.to].box);
}

void Patches::bound(Patch& patch) const {
  if (patch.count == 0) return;
  patch.bounds = boxes_[patch.first];
  for (std::uint32_t k = patch.first + 1; k < patch.first + patch.count; ++k) {
    patch.bounds = patch.bounds.around(boxes_[k]);
  }
}

Patch Patches::since(std::uint32_t first) const {
  const auto count = static_cast<std::uint32_t>(sides_.size()) - first;
  Patch p{first, count, count, {}};
  bound(p);
  return p;
}

Patch Patches::convex(std::span<const SightlineRef> lines) {
  const auto first = static_cast<std::uint32_t>(sides_.size());
  const std::uint32_t begin = make_corner(lines.back(), lines.front());
  std::uint32_t from = begin;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::uint32_t to = k + 1 == lines.size() ? begin : make_corner(lines[k], lines[k + 1]);
    add_side(lines[k], from, to);
    from = to;
  }
  return since(first);
}

bool Patches::split(const Patch& patch, SightlineRef line, Patch& front, Patch& behind) {
  take_up(patch);
  if (classify(line) != 3) return false;
  behind_.clear();
  clip(line, &behind_);
  auto first = static_cast<std::uint32_t>(sides_.size());
  for (const Part& part : parts_) add_side(part.line, part.from, part.to);
  front = since(first);
  first = static_cast<std::uint32_t>(sides_.size());
  for (const Part& part : behind_) add_side(part.line, part.from, part.to);
  for (const Part& part : parts_) {
    if (part.origin == none) add_side(-part.line, part.to, part.from);
  }
  behind = since(first);
  return true;
}

/// Notes, for a walk along the sides, which of them begins in each ray. False: two begin in one, `again` is the second.
bool Patches::index_sides(const Patch& patch, std::uint32_t& again) {
  ++walk_;
  const auto all = sides(patch);
  for (again = 0; again < all.size(); ++again) {
    Corner& begin = corners_[root(all[again].from)];
    if (begin.walk == walk_) return false;
    begin.walk = walk_;
    begin.at = again;
  }
  return true;
}

/// Follows the sides from the first one on, by the rays in which they meet.
bool Patches::simple(const Patch& patch, std::uint32_t& other) {
  if (!index_sides(patch, other)) return false;
  const auto all = sides(patch);
  std::uint32_t k = 0, passed = 0;
  do {
    Corner& begin = corners_[root(all[k].from)];
    begin.walk = 0;
    ++passed;
    const Corner& next = corners_[root(all[k].to)];
    k = next.walk == walk_ ? next.at : 0;
  } while (k != 0);
  if (passed == all.size()) return true;
  for (other = 0; corners_[root(all[other].from)].walk != walk_; ++other) {
  }
  return false;
}

void Patches::see(const Patch& patch, std::span<const SurfaceId> on, Fragments& out) {
  out.fragments.push_back({static_cast<std::uint32_t>(out.sides.size()), patch.count,
                           static_cast<std::uint32_t>(out.seen.size()), static_cast<std::uint32_t>(on.size())});
  out.seen.insert(out.seen.end(), on.begin(), on.end());
  const auto given = [&](std::uint32_t corner) {
    Corner& c = corners_[corner];
    if (c.out == none) {
      c.out = static_cast<std::uint32_t>(out.corners.size());
      out.corners.push_back(c.name);
      out.rays.push_back(c.ray);
      given_.push_back(corner);
    }
    return c.out;
  };
  for (const FragmentSide& side : sides(patch)) out.sides.push_back({side.line, given(side.from), given(side.to)});
}

void Patches::tell_same(Fragments& out) {
  for (const std::uint32_t corner : given_) {
    const std::uint32_t top = root(corner);
    if (top == corner) continue;
    Corner& first = corners_[top];
    if (first.out == none) {
      first.out = corners_[corner].out;
    } else if (first.out != corners_[corner].out) {
      out.same.push_back({first.out, corners_[corner].out});
    }
  }
  given_.clear();
}

}  // namespace sightline
