// From a camera to a written map: tracing with stitching, stitching alone, writing.
#include <benchmark/benchmark.h>

#include <optional>

#include "beam/trace.hpp"
#include "bench/parts/quilt.hpp"
#include "bsp/build.hpp"
#include "bsp/tree.hpp"
#include "models/model.hpp"
#include "visibility_map/stitch.hpp"
#include "visibility_map/write.hpp"

namespace sightline::bench {
namespace {

enum Engine { front_to_back, cells };

struct Traced {
  explicit Traced(Engine engine, const char* name, const ModelOptions& options = {})
      : Traced(engine, make_model(name, options)) {}
  Traced(Engine engine, Model model) : scene(make_scene(std::move(model.soup))) {
    if (engine == cells) {
      complex = build(scene);
    } else {
      tree.emplace(scene);
    }
    for (const CameraLine& c : model.cameras) {
      cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    }
  }
  Tracer tracer() const { return tree ? Tracer(*tree) : Tracer(scene, complex); }

  Scene scene;
  Complex complex;
  std::optional<BspTree> tree;
  std::vector<Camera> cameras;
};

/// One item is one camera; they take turns.
void trace(benchmark::State& state, Engine engine, const char* name, std::uint32_t polygons, double rotate) {
  const Traced t(engine, name, {.polygons = polygons, .rotate_degrees = rotate});
  Tracer tracer = t.tracer();
  VisibilityMap map;
  for (const Camera& camera : t.cameras) tracer.trace(camera, map);  // buffers grow
  for (auto _ : state) {
    for (const Camera& camera : t.cameras) tracer.trace(camera, map);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(t.cameras.size()));
}
BENCHMARK_CAPTURE(trace, maze, front_to_back, "maze", 0, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, maze_cells, cells, "maze", 0, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, city, front_to_back, "city", 0, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, city_cells, cells, "city", 0, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, building, front_to_back, "building", 10'000, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, building_cells, cells, "building", 10'000, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, building_rotated, front_to_back, "building", 10'000, 17)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, random, front_to_back, "random", 1'000, 0)->Unit(benchmark::kMillisecond);

/// One item is one fragment.
void stitch(benchmark::State& state, bool bumpy) {
  const Scene quilt = make_quilt(static_cast<std::uint32_t>(state.range(0)), bumpy);
  const Camera camera = quilt_camera();
  SightlineTable table(quilt.planes());
  Fragments fragments;
  fragments_of(quilt, camera, table, fragments);
  Stitcher stitcher;
  VisibilityMap map;
  for (auto _ : state) stitcher.stitch(quilt, camera, table, fragments, map);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(fragments.fragments.size()));
  state.counters["faces"] = static_cast<double>(map.faces.size());
}
BENCHMARK_CAPTURE(stitch, one_plane, false)->Arg(4)->Arg(32)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(stitch, bumpy, true)->Arg(4)->Arg(32)->Unit(benchmark::kMicrosecond);

/// Cutting fragments out of the window: the regions' share of tracing. One item is one triangle against all.
void clip(benchmark::State& state) {
  const Scene quilt = make_quilt(static_cast<std::uint32_t>(state.range(0)), true);
  SightlineTable table(quilt.planes());
  Fragments fragments;
  for (auto _ : state) fragments_of(quilt, quilt_camera(), table, fragments);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(quilt.surfaces().size()));
}
BENCHMARK(clip)->Arg(4)->Arg(32)->Unit(benchmark::kMicrosecond);

enum Format { json, svg, csv };
void write(benchmark::State& state, Format format) {
  const Traced t(front_to_back, "city");
  Tracer tracer = t.tracer();
  VisibilityMap map;
  tracer.trace(t.cameras[t.cameras.size() / 2], map);
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::string text = format == json  ? map_json(map, t.scene)
                             : format == svg ? map_svg(map, t.scene)
                                             : map_csv(map, t.scene, 0);
    bytes += text.size();
    benchmark::DoNotOptimize(text.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
  state.counters["faces"] = static_cast<double>(map.faces.size());
}
BENCHMARK_CAPTURE(write, json, json)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(write, svg, svg)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(write, csv, csv)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace sightline::bench
