// Scenes with photographs that give away where each of their colours comes from.
#pragma once

#include <cmath>

#include "beam/trace.hpp"
#include "models/model.hpp"
#include "photos/photos.hpp"
#include "photos/render.hpp"

namespace sightline::testing {

/// A pattern for each polygon: one of 27 colours, any two 80 apart in some channel, with waves of `amplitude` on it.
struct Pattern {
  static constexpr double amplitude = 25;
  static constexpr double wave = 1;  // radians a unit of length

  static glm::dvec3 base(PolygonId polygon) {
    const std::uint32_t k = polygon * 10 % 27;  // neighbours in the file differ in more than one channel
    return {40 + 80.0 * (k % 3), 40 + 80.0 * (k / 3 % 3), 40 + 80.0 * (k / 9)};
  }
  static glm::dvec3 at(PolygonId polygon, const glm::dvec3& x) {
    return base(polygon) + amplitude * glm::dvec3(std::sin(wave * x.x), std::sin(wave * x.y), std::sin(wave * x.z));
  }
  /// How far apart, in any channel, two points of a polygon at this distance may be.
  static double change(double distance) { return std::min(2 * amplitude, amplitude * wave * distance); }
};

struct Shots {
  Scene scene;
  std::vector<Camera> cameras;
  std::vector<VisibilityMap> maps;
  ClipResult clipped;

  Shots(Scene s, std::vector<Camera> c, const ClipOptions& options = {})
      : scene(std::move(s)), cameras(std::move(c)), clipped(clip(scene, cameras, options)) {
    for (const Camera& camera : cameras) maps.push_back(map(camera));
  }
  VisibilityMap map(const Camera& camera) const {
    const BspTree tree(scene);
    VisibilityMap result;
    Tracer(tree).trace(camera, result);
    return result;
  }
  std::vector<Photograph> photographs(int width, int height, int guard) const {
    std::vector<Photograph> result;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      result.emplace_back(scene, cameras[c], render(maps[c], scene, width, height, Pattern::at),
                          pixel_owners(maps[c], scene, width, height, guard));
    }
    return result;
  }
};

inline Shots model_shots(const std::string& name, std::size_t first, std::size_t every, std::size_t count,
                         std::uint32_t polygons = 0) {
  ModelOptions options;
  options.polygons = polygons;
  Model made = make_model(name, options);
  std::vector<Camera> cameras;
  for (std::size_t k = first; k < made.cameras.size() && cameras.size() < count; k += every) {
    const CameraLine& c = made.cameras[k];
    cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  return {make_scene(std::move(made.soup)), std::move(cameras)};
}

inline double difference(const glm::dvec3& a, const glm::dvec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace sightline::testing
