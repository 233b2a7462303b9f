#include "sample/bitfield_patches.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace sightline {
namespace {

struct Place {
  PolygonId polygon;
  int facing;  // 0 to 5
  glm::dvec3 middle;
};

Place place_of(const Scene& scene, PolygonId p) {
  const auto corners = scene.corners(p);
  const PointTable& points = scene.points();
  glm::dvec3 sum(0), normal(0);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3 &a = points.approx(corners[k]), &b = points.approx(corners[(k + 1) % corners.size()]);
    sum += a;
    normal += glm::cross(a, b);
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  }
  return {p, 2 * axis + (normal[axis] < 0 ? 1 : 0), sum / static_cast<double>(corners.size())};
}

void halve(std::span<Place> places, std::size_t most, std::vector<std::span<Place>>& out) {
  if (places.empty()) return;
  if (places.size() <= most) {
    out.push_back(places);
    return;
  }
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const Place& p : places) {
    low = glm::min(low, p.middle);
    high = glm::max(high, p.middle);
  }
  const glm::dvec3 wide = high - low;
  const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::nth_element(places.begin(), middle, places.end(), [axis](const Place& a, const Place& b) {
    return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.polygon < b.polygon;
  });
  halve(places.first(places.size() / 2), most, out);
  halve(places.subspan(places.size() / 2), most, out);
}

}  // namespace

PolygonPatches::PolygonPatches(const Scene& scene, std::uint32_t most) : patch_of_(scene.polygon_count()) {
  std::vector<Place> places;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) places.push_back(place_of(scene, p));
  std::ranges::stable_sort(places, {}, &Place::facing);
  std::vector<std::span<Place>> groups;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && places[end].facing == places[begin].facing) ++end;
    halve(std::span(places).subspan(begin, end - begin), most, groups);
  }
  for (const auto& group : groups) {
    const auto start = static_cast<std::ptrdiff_t>(members_.size());
    for (const Place& p : group) {
      patch_of_[p.polygon] = size();
      members_.push_back(p.polygon);
    }
    std::sort(members_.begin() + start, members_.end());
    first_.push_back(static_cast<std::uint32_t>(members_.size()));
  }
}

IdBitfield PolygonPatches::patches(const IdBitfield& polygons) const {
  IdBitfield out(size());
  for (const PolygonId p : polygons.list()) out.set(patch_of_[p]);
  return out;
}

IdBitfield PolygonPatches::polygons(const IdBitfield& patches) const {
  IdBitfield out(static_cast<std::uint32_t>(patch_of_.size()));
  for (const std::uint32_t k : patches.list()) {
    for (const PolygonId p : members(k)) out.set(p);
  }
  return out;
}

}  // namespace sightline
