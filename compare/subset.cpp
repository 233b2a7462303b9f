#include "compare/subset.hpp"

#include "beam/trace.hpp"
#include "bsp/tree.hpp"
#include "sample/sub_scene.hpp"

namespace sightline::comparison {

void draw_subset(const Scene& scene, std::span<const PolygonId> polygons, const Camera& camera, Drawing& drawing) {
  const SubScene part = sub_scene(scene, polygons);
  const BspTree tree(part.scene, {.lazy = true, .threads = 1});
  VisibilityMap map;
  Tracer(tree).trace(camera, map);
  draw(map, drawing);
  for (PolygonId& p : drawing.polygons) {
    if (p != none) p = part.original[p];
  }
}

}  // namespace sightline::comparison
