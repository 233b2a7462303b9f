#include "bsp/tree_parts.hpp"

#include <cmath>
#include <numeric>

namespace sightline {

TreePart TreeParts::add(const Piece& piece) {
  CutPart made{piece.surface, piece.first, piece.count, static_cast<float>(pieces_.area(piece)), {}, {}};
  made.box.add(piece.low, piece.high);
  if (frame().turned()) {
    for (const PieceCorner& c : pieces_.corners(piece))
      made.turned.add(frame().of(c.place.approx), frame().of(c.place.approx));
  }
  cut_.push_back(made);
  return count_ + static_cast<TreePart>(cut_.size() - 1);
}

void TreeParts::take_all(TreeLoad& load, TreeExtent& extent) const {
  load.parts.resize(count_);
  std::iota(load.parts.begin(), load.parts.end(), 0u);
  for (SurfaceId s = 0; s < count_; s += surface_block) extent.add(wholes_.block(s));
}

void TreeParts::aim(PlaneId plane) {
  const ApproxPlane& p = wholes_.scene().planes().approx(plane);
  plane_ = plane;
  normal_ = frame().of({p.n[0], p.n[1], p.n[2]});
  d_ = p.d;
  axis_ = frame().turned() ? -1 : wholes_.scene().planes().axis(plane);
  at_ = axis_ >= 0 ? static_cast<float>(d_ / normal_[axis_]) : 0;
}

int TreeParts::exact_sides(TreePart p) {
  if (!whole(p)) return pieces_.sides(piece(p), plane_);
  const Scene& scene = wholes_.scene();
  const Surface& surface = scene.surfaces()[p];
  if (surface.plane == plane_) return 0;
  if (!wholes_.has_points(p)) {
    const std::size_t end = pieces_.corner_count();
    const int found = pieces_.sides(pieces_.whole(p), plane_);
    pieces_.truncate(end);
    return found;
  }
  int found = 0;
  for (const SurfaceEdge& e : scene.edges(surface)) {
    const Sign s = point_side(scene.planes(), e.corner, plane_);
    found |= s < 0 ? 1 : s > 0 ? 2 : 0;
  }
  return found;
}

void TreeParts::split(TreePart p, TreePart& behind, TreePart& front) {
  Piece halves[2];
  if (whole(p)) {
    const Piece made = pieces_.whole(p);
    pieces_.sides(made, plane_);
    pieces_.split(made, plane_, halves[0], halves[1]);
  } else {
    pieces_.split(piece(p), plane_, halves[0], halves[1]);
  }
  behind = add(halves[0]);
  front = add(halves[1]);
}

void TreeParts::swap_arena(TreeLoad& load) {
  cut_.swap(load.cut);
  pieces_.swap_corners(load.corners);
}

void TreeParts::pack(std::vector<TreePart>& parts, TreeLoad& load) const {
  constexpr std::size_t looked_at_once = 64;
  const auto take = [&](TreePart& p) {
    if (whole(p)) return;
    const auto own = corners(p);
    load.cut.push_back(cut_[p - count_]);
    load.cut.back().first = static_cast<std::uint32_t>(load.corners.size());
    load.corners.insert(load.corners.end(), own.begin(), own.end());
    p = count_ + static_cast<TreePart>(load.cut.size() - 1);
  };
  for (std::size_t k = 0; k < parts.size() && !cut_.empty(); k += looked_at_once) {
    const auto some = std::span(parts).subspan(k, std::min(looked_at_once, parts.size() - k));
    TreePart last = 0;
    for (const TreePart p : some) last = std::max(last, p);
    if (!whole(last)) std::for_each(some.begin(), some.end(), take);
  }
  load.parts = std::move(parts);
}

void TreeParts::truncate(const Mark& mark) {
  cut_.erase(cut_.begin() + static_cast<std::ptrdiff_t>(mark.cut), cut_.end());
  pieces_.truncate(mark.corners);
}

}  // namespace sightline
