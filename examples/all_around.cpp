// Everything that is seen from a point, in all directions: a room of the model `rooms`, from its first camera's eye.
#include "sightline.hpp"

#include <cstdio>
#include <numbers>

int main() {
  using namespace sightline;
  Model model = make_model("rooms");
  const glm::dvec3 eye = model.cameras.front().eye;
  const Scene scene = make_scene(std::move(model.soup));
  const Complex complex = build(scene);
  VisibilityMap map;
  Tracer(scene, complex).trace_sphere(eye, map);
  for (const MapFace& face : map.faces) {
    const double share = 100 * face.solid_angle / (4 * std::numbers::pi);
    if (face.polygon == none) {
      std::printf("open sky   %6.2f %% of the sphere\n", share);
    } else {
      std::printf("polygon %2u %6.2f %% of the sphere\n", face.polygon, share);
    }
  }
}
