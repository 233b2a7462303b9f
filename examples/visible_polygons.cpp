// Which objects does each camera see, and how much of the window does each fill?
//   example_visible_polygons SCENE.obj SCENE.cameras
#include "sightline.hpp"

#include <cstdio>
#include <exception>
#include <map>
#include <string>

namespace {

using namespace sightline;

std::string object_name(const Scene& scene, PolygonId polygon) {
  const PolygonSoup& soup = scene.soup();
  if (soup.object_of.empty() || soup.object_of[polygon] == none) return "polygon " + std::to_string(polygon);
  return soup.objects[soup.object_of[polygon]];
}

void print_views(const Scene& scene, const std::vector<Camera>& cameras) {
  const BspTree tree(scene);
  Tracer tracer(tree);
  VisibilityMap map;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    tracer.trace(cameras[k], map);
    std::map<std::string, double> share;
    for (const PolygonVisibility& seen : visible_polygons(map, scene)) {
      share[object_name(scene, seen.polygon)] += seen.area;
    }
    std::printf("camera %zu:\n", k);
    for (const auto& [name, area] : share) std::printf("  %-24s %6.2f %%\n", name.c_str(), 100 * area);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s SCENE CAMERAS\n", argv[0]);
    return 2;
  }
  try {
    print_views(make_scene(read_polygons(argv[1])), read_cameras(argv[2]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
