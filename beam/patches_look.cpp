// What of a figure lies in a patch: told conservatively, before anything is cut.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "beam/patches.hpp"

namespace sightline {

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

}  // namespace sightline
