// Models turned in rounded doubles, with some of their cameras.
#pragma once

#include <optional>
#include <vector>

#include "models/model.hpp"

namespace sightline {

struct Turned {
  Turned(const char* name, std::uint32_t polygons, double degrees) {
    ModelOptions options;
    options.polygons = polygons;
    options.rotate_degrees = degrees;
    const Model model = make_model(name, options);
    for (std::size_t k = 0; k < model.cameras.size(); k += 5) {
      const auto& c = model.cameras[k];
      cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    }
    soup = model.soup;
    scene.emplace(make_scene(soup));
  }
  PolygonSoup soup;
  std::optional<Scene> scene;
  std::vector<Camera> cameras;
};

}  // namespace sightline
