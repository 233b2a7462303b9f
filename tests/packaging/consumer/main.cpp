// Uses each folder of the library: a model is made, built, traced, written and read back.
#include "sightline.hpp"

#include <cmath>
#include <iostream>

int main() {
  using namespace sightline;
  Model model = make_model("rooms");
  const CameraLine& line = model.cameras.front();
  const Camera camera = make_camera(line.eye, line.forward, line.up, line.vertical_fov_degrees, line.aspect);
  const Scene scene = make_scene(std::move(model.soup));
  const Complex complex = build(scene);
  VisibilityMap map;
  Tracer(scene, complex).trace(camera, map);
  double area = 0;
  for (const MapFace& face : map.faces) area += face.area;
  const std::string json = map_json(map, scene);
  std::cout << map.faces.size() << " faces, area " << area << ", " << json.size() << " bytes\n";
  return std::abs(area - 1) < 1e-9 && !map.faces.empty() && !json.empty() ? 0 : 1;
}
