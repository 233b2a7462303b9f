#include "beam/patches.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
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

/// Is a ray in the patch? Known by what a line of the frame from it towards greater x crosses, unless it comes too near
/// to a corner, or the ray to a side. Rounding to floats: 2^-24 of a coordinate.
bool Patches::odd(const Patch& patch, const glm::dvec3& ray, bool& known) const {
  glm::dvec2 at;
  double error = 0;
  known = frame_->place(ray, at, error);
  if (!known) return false;
  constexpr float far = std::numeric_limits<float>::infinity();
  const double off_x = 2 * error + 0x1p-22 * std::abs(at.x), off_y = 2 * error + 0x1p-22 * std::abs(at.y);
  const FrameBox line{
      {static_cast<float>(at.x - off_x), static_cast<float>(at.y - off_y), -far, static_cast<float>(-at.y - off_y)}};
  const double least = at.y - off_y, most = at.y + off_y, beyond = at.x + off_x;
  bool odd = false;
  for (std::uint32_t k = patch.first; k < patch.first + patch.count; ++k) {
    const FrameBox& box = boxes_[k];
    if (!box.meets(line)) continue;
    const FrameBox &from = corners_[sides_[k].from].box, &to = corners_[sides_[k].to].box;
    const bool up = -from.side[3] < least && most < to.side[1], down = -to.side[3] < least && most < from.side[1];
    if (up == down) {
      known = false;
      return false;
    }
    if (box.side[0] > beyond) {
      odd = !odd;
      continue;
    }
    // The frame is seen with x to the left and y upwards, inside is on the left of a side: with the ray inside, it
    // lies towards greater x if it goes down.
    const double inside = glm::dot(table_->approx(sides_[k].line.id), ray) * sides_[k].line.sign;
    if (!(std::abs(inside) > 4 * scale_.point)) {
      known = false;
      return false;
    }
    if ((inside > 0) == down) odd = !odd;
  }
  return odd;
}

/// Is there a line, along the side of the patch or one of the figure, that clearly has them on its two sides?
/// `within` is set where an end of the side is clearly in the figure.
bool Patches::keeps_away(const FragmentSide& side, Cone& figure, bool& within) const {
  constexpr int all = VectorFours::all;
  const VectorFours::Factor n(table_->approx(side.line.id));
  bool front = true, behind = true;
  for (std::size_t k = 0; k < figure.quick_ray.size(); ++k) {
    const auto [above, below] = figure.quick_ray.signs(n, k);
    front = front && above == all;
    behind = behind && below == all;
  }
  if (front || behind) return true;
  figure.need_sides(scale_);
  const VectorFours::Factor from(corners_[side.from].ray), to(corners_[side.to].ray);
  bool from_within = true, to_within = true;
  for (std::size_t k = 0; k < figure.quick_out.size(); ++k) {
    const auto at_from = figure.quick_out.signs(from, k), at_to = figure.quick_out.signs(to, k);
    if ((at_from.above & at_to.above) != 0) return true;
    from_within = from_within && at_from.below == all;
    to_within = to_within && at_to.below == all;
  }
  within = within || from_within || to_within;
  return false;
}

/// Where doubles do not tell: by what the two are, then by numbers.
Sign Patches::exact_side(const Corner& corner, SightlineRef line) const {
  if (line.id < line_names_.size() && holds(*scene_, line_names_[line.id], corner.place)) return 0;
  return table_->order({corner.name.low, corner.name.sign}, {corner.name.high, 1}, line);
}

/// The side of a corner against side k of a figure, +1 outwards, where doubles do not tell; `uncertain` for a cut.
Sign Patches::exact_side(const Corner& corner, Cone& figure, std::uint32_t k) const {
  const TreePiece& piece = *figure.piece;
  const TreeEdge& edge = piece.edge[k];
  if (holds(*scene_, line_name(piece, k), corner.place)) return 0;
  const PlaceName begin = place_name(piece, k), end = place_name(piece, k + 1 == piece.count ? 0 : k + 1);
  if (corner.place.known() && (corner.place == begin || corner.place == end)) return 0;
  if (edge.a == none) return uncertain;
  SightlineRef& outer = figure.outer[k];
  if (outer.id == none) {
    outer = table_->of_points(edge.a, edge.b);
    outer.sign *= figure.eye_side;
  }
  return exact_side(corner, outer);
}

/// Is there such a line at all, which they may touch? What the figure does not clearly keep away from is decided
/// exactly, as long as that is cheap.
bool Patches::parted(const FragmentSide& side, Cone& figure) const {
  const glm::dvec3& n = table_->approx(side.line.id);
  const LineName name = side.line.id < line_names_.size() ? line_names_[side.line.id] : LineName{};
  bool front = true, behind = true;
  for (std::uint32_t k = 0; k < figure.piece->count && (front || behind); ++k) {
    const double value = glm::dot(n, figure.ray[k]);
    if (std::abs(value) > scale_.point) {
      (value > 0 ? behind : front) = false;
    } else if (!holds(*scene_, name, place_name(*figure.piece, k))) {
      const PointId p = figure.piece->corner[k].point;
      const Sign sign = p != none ? table_->side({side.line.id, 1}, p) : uncertain;
      front = front && (sign == 0 || sign == 1);
      behind = behind && (sign == 0 || sign == -1);
    }
  }
  if (front || behind) return true;
  const Corner &from = corners_[side.from], &to = corners_[side.to];
  for (std::uint32_t k = 0; k < figure.piece->count; ++k) {
    const double at_from = glm::dot(figure.out[k], from.ray), at_to = glm::dot(figure.out[k], to.ray);
    if (at_from < -scale_.side || at_to < -scale_.side) continue;
    const auto outside = [&](double value, const Corner& c) {
      const Sign sign = value > scale_.side ? 1 : exact_side(c, figure, k);
      return sign == 0 || sign == 1;
    };
    if (outside(at_from, from) && outside(at_to, to)) return true;
  }
  return false;
}

Patches::Place Patches::look(const Patch& patch, const FrameBox& bounds, Cone& figure) {
  near_.clear();
  bool within = false;
  for (std::uint32_t k = patch.first, end = patch.first + patch.count; k < end; ++k) {
    if (boxes_[k].meets(bounds) && !keeps_away(sides_[k], figure, within)) near_.push_back(k);
  }
  if (within) return Place::touched;
  for (const std::uint32_t k : near_) {
    if (!parted(sides_[k], figure)) return Place::touched;
  }
  // No side meets the figure: all of it is inside or outside.
  bool known = false;
  const bool inside = odd(patch, figure.inner(frame_->ahead()), known);
  return !known || (inside && !near_.empty()) ? Place::touched : inside ? Place::inside : Place::outside;
}

/// A side keeps away if its box does, or if a plane along it has the figure on one side.
Patches::Place Patches::look(const Patch& patch, const FrameBox& bounds, const TreeBox& figure) const {
  const glm::dvec3 middle = figure.middle - scale_.eye;
  for (std::uint32_t k = patch.first, end = patch.first + patch.count; k < end; ++k) {
    if (!boxes_[k].meets(bounds)) continue;
    const glm::dvec3& n = table_->approx(sides_[k].line.id);
    if (!(std::abs(glm::dot(n, middle)) > glm::dot(glm::abs(n), figure.half) + scale_.point)) return Place::touched;
  }
  bool known = false;
  const bool inside = odd(patch, middle, known);
  return !known ? Place::touched : inside ? Place::inside : Place::outside;
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
