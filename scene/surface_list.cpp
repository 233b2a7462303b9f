#include "scene/surface_list.hpp"

#include <bit>
#include <cmath>
#include <utility>

namespace sightline {

int steepest_axis(const ApproxPlane& plane) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(plane.n[k]) > std::abs(plane.n[axis])) axis = k;
  }
  return axis;
}

SurfaceList::SurfaceList(PlaneTable& planes, std::span<const PointId> representative, std::size_t surface_count,
                         std::size_t edge_count)
    : planes_(planes), representative_(representative), walls_(std::bit_ceil(2 * edge_count + 2)) {
  surfaces.reserve(surface_count);
  edges.reserve(edge_count);
}

void SurfaceList::add(PolygonId polygon, PlaneTable::Interned plane, std::span<const PointId> corners) {
  const ApproxPlane& approx = planes_.approx(plane.id);
  const int axis = steepest_axis(approx);
  const Sign slope = approx.n[axis] > 0 ? 1 : -1;
  const auto n = static_cast<std::uint32_t>(corners.size());
  surfaces.push_back({polygon, plane.id, static_cast<std::uint32_t>(edges.size()), n, plane.flipped});
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = k + 1 == n ? 0 : k + 1;
    if (plane.flipped) {  // the same corners backwards
      add_edge(corners[n - 1 - k], corners[n - 1 - next], corners[n - 1 - next], axis, slope);
    } else {
      add_edge(corners[k], corners[next], corners[next], axis, slope);
    }
  }
}

void SurfaceList::add(PolygonId polygon, PlaneId plane, std::span<const PieceSide> sides, bool reversed, bool flipped) {
  const ApproxPlane& approx = planes_.approx(plane);
  const int axis = steepest_axis(approx);
  const Sign slope = approx.n[axis] > 0 ? 1 : -1;
  const std::size_t n = sides.size();
  surfaces.push_back(
      {polygon, plane, static_cast<std::uint32_t>(edges.size()), static_cast<std::uint32_t>(n), flipped});
  for (std::size_t k = 0; k < n; ++k) {
    const PieceSide& s = sides[reversed ? n - 1 - k : k];
    if (reversed) {  // a side ends where the one before it in the given order ended
      add_edge(s.b, s.a, sides[(2 * n - 2 - k) % n].corner, axis, slope);
    } else {
      add_edge(s.a, s.b, s.corner, axis, slope);
    }
  }
}

/// Which side of the wall is inside needs no arithmetic. With n the plane's normal, u = b - a along the edge and e the
/// axis, the piece lies towards n x u (its edges run counter-clockwise), and the wall's normal is u x e, so that
/// (n x u).(u x e) = (n.u)(u.e) - (n.e)(u.u) = -(n.e)(u.u), because u lies in the plane. So it is the sign of -n.e.
void SurfaceList::add_edge(PointId a, PointId b, PointId corner, int axis, Sign slope) {
  const PlaneTable::Interned made = wall(a, b, axis);
  edges.push_back({a, b, made.id, made.flipped ? slope : -slope, corner});
}

PlaneTable::Interned SurfaceList::wall(PointId a, PointId b, int axis) {
  PointId low = representative_[a], high = representative_[b];
  const bool backwards = low > high;
  if (backwards) std::swap(low, high);
  if (2 * wall_count_ >= walls_.size()) grow();
  const std::uint64_t points = std::uint64_t{low} << 32 | high;
  const std::size_t mask = walls_.size() - 1;
  std::size_t slot = (points * 0x9e3779b97f4a7c15u) >> 32 & mask;
  while (walls_[slot].plane != none && (walls_[slot].points != points || walls_[slot].axis != axis)) {
    slot = (slot + 1) & mask;
  }
  Wall& entry = walls_[slot];
  if (entry.plane == none) {
    const PlaneTable::Interned made = planes_.add_wall(low, high, axis);
    entry = {points, made.id, static_cast<std::int8_t>(axis), made.flipped};
    ++wall_count_;
  }
  return {entry.plane, entry.flipped != backwards};
}

void SurfaceList::grow() {
  std::vector<Wall> old(2 * walls_.size());
  old.swap(walls_);
  const std::size_t mask = walls_.size() - 1;
  for (const Wall& entry : old) {
    if (entry.plane == none) continue;
    std::size_t slot = (entry.points * 0x9e3779b97f4a7c15u) >> 32 & mask;
    while (walls_[slot].plane != none) slot = (slot + 1) & mask;
    walls_[slot] = entry;
  }
}

}  // namespace sightline
