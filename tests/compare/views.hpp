// Exact maps of models, for tests of what is measured against them.
#pragma once

#include "beam/trace.hpp"
#include "compare/method.hpp"
#include "models/model.hpp"

#include <string>
#include <vector>

namespace sightline::comparison {

/// A model with some of its cameras.
struct Views {
  explicit Views(const std::string& name, const ModelOptions& options = {}, std::size_t count = 3) {
    Model model = make_model(name, options);
    scene = make_scene(std::move(model.soup));
    const std::size_t step = model.cameras.size() / count;
    for (std::size_t k = 0; k < count; ++k) {
      const CameraLine& c = model.cameras[k * step];
      cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    }
  }
  VisibilityMap map(std::size_t camera) const {
    const BspTree tree(scene);
    VisibilityMap result;
    Tracer(tree).trace(cameras[camera], result);
    return result;
  }
  Scene scene;
  std::vector<Camera> cameras;
};

inline Answer answer_of(const VisibilityMap& map) {
  Answer answer;
  for (const MapFace& f : map.faces) answer.reported.push_back(f.polygon);
  tidy(answer.reported);
  draw(map, answer.shown.emplace<Drawing>());
  return answer;
}

}  // namespace sightline::comparison
