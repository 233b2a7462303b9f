#include "sample/sub_scene.hpp"

namespace sightline {

SubScene sub_scene(const Scene& scene, std::span<const PolygonId> polygons) {
  PolygonSoup soup;
  soup.source = scene.soup().source;
  soup.vertices = scene.soup().vertices;
  soup.first.reserve(polygons.size() + 1);
  for (const PolygonId p : polygons) {
    const auto corners = scene.corners(p);
    soup.corners.insert(soup.corners.end(), corners.begin(), corners.end());
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return {make_scene(std::move(soup), scene.options()), {polygons.begin(), polygons.end()}};
}

}  // namespace sightline
