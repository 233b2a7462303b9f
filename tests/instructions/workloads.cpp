#include "tests/instructions/workloads.hpp"

#include <memory>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "bsp/tree.hpp"
#include "models/model.hpp"
#include "visibility_map/write.hpp"

namespace sightline::instructions {
namespace {

struct Prepared {
  explicit Prepared(Model model) : scene(make_scene(std::move(model.soup))) {
    for (const CameraLine& c : model.cameras) {
      cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    }
  }
  Scene scene;
  Complex complex;
  std::vector<Camera> cameras;
};

Model model(const char* name, std::uint32_t polygons, double rotate) {
  return make_model(name, {.polygons = polygons, .rotate_degrees = rotate});
}

Workload scene_of(std::string name, const char* of, std::uint32_t polygons, double rotate) {
  return {std::move(name), [=]() -> std::function<void()> {
            auto made = std::make_shared<PolygonSoup>(model(of, polygons, rotate).soup);
            return [made] { make_scene(std::move(*made)); };
          }};
}

Workload build_of(std::string name, const char* of, std::uint32_t polygons, double rotate) {
  return {std::move(name), [=]() -> std::function<void()> {
            auto made = std::make_shared<Prepared>(model(of, polygons, rotate));
            return [made] { made->complex = build(made->scene); };
          }};
}

Workload tree_of(std::string name, const char* of, std::uint32_t polygons, double rotate) {
  return {std::move(name), [=]() -> std::function<void()> {
            auto made = std::make_shared<Prepared>(model(of, polygons, rotate));
            return [made] { const BspTree tree(made->scene); };
          }};
}

enum class Engine { front_to_back, cells };

/// `views` cameras, evenly spread, after each has been traced once: buffers have grown.
Workload trace_of(std::string name, Engine engine, const char* of, std::uint32_t polygons, double rotate,
                  std::size_t views) {
  return {std::move(name), [=]() -> std::function<void()> {
            auto made = std::make_shared<Prepared>(model(of, polygons, rotate));
            std::shared_ptr<Tracer> tracer;
            std::shared_ptr<BspTree> tree;
            if (engine == Engine::cells) {
              made->complex = build(made->scene);
              tracer = std::make_shared<Tracer>(made->scene, made->complex);
            } else {
              tree = std::make_shared<BspTree>(made->scene);
              tracer = std::make_shared<Tracer>(*tree);
            }
            auto map = std::make_shared<VisibilityMap>();
            const auto all = [made, tree, tracer, map, views] {
              for (std::size_t k = 0; k < views; ++k) {
                tracer->trace(made->cameras[k * made->cameras.size() / views], *map);
              }
            };
            all();
            return all;
          }};
}

Workload write_of(std::string name, const char* of) {
  return {std::move(name), [=]() -> std::function<void()> {
            auto made = std::make_shared<Prepared>(model(of, 0, 0));
            made->complex = build(made->scene);
            Tracer tracer(made->scene, made->complex);
            auto map = std::make_shared<VisibilityMap>();
            tracer.trace(made->cameras[made->cameras.size() / 2], *map);
            return [made, map] {
              map_json(*map, made->scene);
              map_svg(*map, made->scene);
              map_csv(*map, made->scene, 0);
            };
          }};
}

}  // namespace

std::vector<Workload> workloads() {
  return {
      scene_of("scene_building", "building", 2'000, 0),
      scene_of("scene_building_rotated", "building", 1'000, 17),
      build_of("build_building", "building", 2'000, 0),
      build_of("build_building_rotated", "building", 200, 17),
      build_of("build_random", "random", 50, 0),
      tree_of("tree_building", "building", 2'000, 0),
      tree_of("tree_building_rotated", "building", 1'000, 17),
      trace_of("cells_building", Engine::cells, "building", 2'000, 0, 20),
      trace_of("cells_building_rotated", Engine::cells, "building", 200, 17, 4),
      trace_of("cells_city", Engine::cells, "city", 0, 0, 4),
      trace_of("trace_building", Engine::front_to_back, "building", 2'000, 0, 50),
      trace_of("trace_building_rotated", Engine::front_to_back, "building", 1'000, 17, 20),
      trace_of("trace_city", Engine::front_to_back, "city", 0, 0, 20),
      trace_of("trace_random", Engine::front_to_back, "random", 200, 0, 4),
      write_of("write_city", "city"),
  };
}

}  // namespace sightline::instructions
