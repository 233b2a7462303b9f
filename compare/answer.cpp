#include "compare/answer.hpp"

#include <algorithm>

namespace sightline::comparison {

void draw(const VisibilityMap& map, Drawing& drawing) {
  drawing.corners.clear();
  drawing.edges.clear();
  drawing.polygons.clear();
  for (const MapVertex& v : map.vertices) drawing.corners.push_back(v.st);
  for (const MapEdge& e : map.edges) drawing.edges.push_back({e.vertex[0], e.vertex[1], e.left, e.right});
  for (const MapFace& f : map.faces) drawing.polygons.push_back(f.polygon);
}

void tidy(std::vector<PolygonId>& polygons) {
  // Neighbours are often equal, in pixels above all.
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
  std::sort(polygons.begin(), polygons.end());
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
  if (!polygons.empty() && polygons.back() == none) polygons.pop_back();
}

}  // namespace sightline::comparison
