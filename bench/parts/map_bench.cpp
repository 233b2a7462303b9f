// From a camera to a written map: tracing with stitching, stitching alone, writing.
#include <benchmark/benchmark.h>

#include "beam/trace.hpp"
#include "bench/parts/quilt.hpp"
#include "bsp/build.hpp"
#include "models/model.hpp"
#include "visibility_map/stitch.hpp"
#include "visibility_map/write.hpp"

namespace sightline::bench {
namespace {

struct Traced {
  explicit Traced(const char* name, const ModelOptions& options = {}) : Traced(make_model(name, options)) {}
  explicit Traced(Model model) : scene(make_scene(std::move(model.soup))), complex(build(scene)) {
    for (const CameraLine& c : model.cameras) {
      cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    }
  }
  Scene scene;
  Complex complex;
  std::vector<Camera> cameras;
};

/// One item is one camera; they take turns.
void trace(benchmark::State& state, const char* name, std::uint32_t polygons, double rotate) {
  const Traced t(name, {.polygons = polygons, .rotate_degrees = rotate});
  Tracer tracer(t.scene, t.complex);
  VisibilityMap map;
  for (const Camera& camera : t.cameras) tracer.trace(camera, map);  // buffers grow
  for (auto _ : state) {
    for (const Camera& camera : t.cameras) tracer.trace(camera, map);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(t.cameras.size()));
}
BENCHMARK_CAPTURE(trace, maze, "maze", 0, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, city, "city", 0, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, building, "building", 10'000, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, building_rotated, "building", 1'000, 17)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace, random, "random", 100, 0)->Unit(benchmark::kMillisecond);

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
  const Traced t("city");
  Tracer tracer(t.scene, t.complex);
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
