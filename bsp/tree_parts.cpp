#include "bsp/tree_parts.hpp"

#include <cmath>
#include <glm/common.hpp>

namespace sightline {

TreeSurfaces::TreeSurfaces(const Scene& scene)
    : scene_(scene),
      frame_(scene),
      box_(scene.surfaces().size()),
      turned_(frame_.turned() ? box_.size() : 0),
      spread_(box_.size()),
      area_(std::make_unique<std::atomic<float>[]>(box_.size())) {
  for (SurfaceId s = 0; s < box_.size(); ++s) {
    const auto edges = scene.edges(scene.surfaces()[s]);
    if (std::any_of(edges.begin(), edges.end(), [](const SurfaceEdge& e) { return e.corner == none; })) continue;
    glm::dvec3 low = scene.points().approx(edges[0].corner), high = low;
    for (const SurfaceEdge& e : edges.subspan(1)) {
      low = glm::min(low, scene.points().approx(e.corner));
      high = glm::max(high, scene.points().approx(e.corner));
    }
    box_[s].add(low, high);
    if (frame_.turned()) for_corners(s, [&](const glm::dvec3& p) { turned_[s].add(frame_.of(p), frame_.of(p)); });
  }
  find_spreads();
}

/// From the polygon's corners, which may be more than those of its surfaces.
void TreeSurfaces::find_spreads() {
  for (SurfaceId s = 0; s < spread_.size(); ++s) {
    const PolygonId polygon = scene_.surfaces()[s].polygon;
    if (s > 0 && scene_.surfaces()[s - 1].polygon == polygon) {
      spread_[s] = spread_[s - 1];
      continue;
    }
    glm::dvec3 low{INFINITY}, high{-INFINITY};
    for (const PointId corner : scene_.corners(polygon)) {
      low = glm::min(low, scene_.points().approx(corner));
      high = glm::max(high, scene_.points().approx(corner));
    }
    spread_[s] = static_cast<float>(glm::length(high - low) * (1 + 0x1p-20) + 0x1p-40);
  }
}

float TreeSurfaces::area(SurfaceId s) const {
  float area = area_[s].load(std::memory_order_relaxed);
  if (area != 0) return area;
  glm::dvec3 from{0}, last{0}, sum{0};
  int seen = 0;
  for_corners(s, [&](const glm::dvec3& p) {
    if (seen == 0) from = p;
    if (seen > 1) sum += glm::cross(last - from, p - from);
    last = p;
    ++seen;
  });
  area = static_cast<float>(glm::length(sum) / 2);
  area_[s].store(area, std::memory_order_relaxed);
  return area;
}

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

void TreeParts::take_all(TreeLoad& load) {
  load.parts.resize(count_);
  for (SurfaceId s = 0; s < count_; ++s) load.parts[s] = wholes_.has_points(s) ? s : add(pieces_.whole(s));
  swap_arena(load);
}

void TreeParts::aim(PlaneId plane) {
  const ApproxPlane& p = wholes_.scene().planes().approx(plane);
  plane_ = plane;
  normal_ = frame().of({p.n[0], p.n[1], p.n[2]});
  d_ = p.d;
  axis_ = frame().turned() ? -1 : wholes_.scene().planes().axis(plane);
  at_ = axis_ >= 0 ? static_cast<float>(d_ / normal_[axis_]) : 0;
}

/// First by the box, which has 2^-24 to spare on every side. A plane across an axis loses at most 2^-25 as a float; the
/// sum for any other, of a normal of at least 1/2, is far less off than what a box has to spare along it.
int TreeParts::sides(TreePart p) {
  const RoundedBox& box = along(p);
  if (axis_ >= 0) {
    if (box.low[axis_] > at_) return 2;
    if (box.high[axis_] < at_) return 1;
    return exact_sides(p);
  }
  double middle = -d_, reach = 0;
  for (int k = 0; k < 3; ++k) {
    middle += normal_[k] * (static_cast<double>(box.low[k]) + box.high[k]) * 0.5;
    reach += std::abs(normal_[k]) * (static_cast<double>(box.high[k]) - box.low[k]) * 0.5;
  }
  if (middle > reach) return 2;
  if (middle < -reach) return 1;
  return exact_sides(p);
}

int TreeParts::exact_sides(TreePart p) {
  if (!whole(p)) return pieces_.sides(piece(p), plane_);
  const Scene& scene = wholes_.scene();
  const Surface& surface = scene.surfaces()[p];
  if (surface.plane == plane_) return 0;
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
  for (TreePart& p : parts) {
    if (cut_.empty()) break;
    if (whole(p)) continue;
    const auto own = corners(p);
    load.cut.push_back(cut_[p - count_]);
    load.cut.back().first = static_cast<std::uint32_t>(load.corners.size());
    load.corners.insert(load.corners.end(), own.begin(), own.end());
    p = count_ + static_cast<TreePart>(load.cut.size() - 1);
  }
  load.parts = std::move(parts);
}

void TreeParts::truncate(const Mark& mark) {
  cut_.erase(cut_.begin() + static_cast<std::ptrdiff_t>(mark.cut), cut_.end());
  pieces_.truncate(mark.corners);
}

}  // namespace sightline
