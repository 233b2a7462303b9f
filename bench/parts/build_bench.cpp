// From polygons to the complex: making the scene exact, cutting cells, the whole build.
#include <benchmark/benchmark.h>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "bsp/tree.hpp"
#include "models/model.hpp"
#include "winged_pair/split.hpp"

namespace sightline::bench {
namespace {

PolygonSoup model(const char* name, std::int64_t polygons, double rotate = 0) {
  return make_model(name, {.polygons = static_cast<std::uint32_t>(polygons), .rotate_degrees = rotate}).soup;
}

void scene(benchmark::State& state, const char* name, double rotate) {
  const PolygonSoup soup = model(name, state.range(0), rotate);
  for (auto _ : state) benchmark::DoNotOptimize(make_scene(soup));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK_CAPTURE(scene, building, "building", 0)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scene, building_rotated, "building", 17)->Arg(10'000)->Unit(benchmark::kMillisecond);

/// A box cut by the planes of a random scene, every cell by each of them: nothing but splitting. Items: cells made.
void cut(benchmark::State& state) {
  const Scene random = make_scene(model("random", 100));
  const Integer lower[3] = {-(Integer(1) << 40), -(Integer(1) << 40), -(Integer(1) << 40)};
  const Integer upper[3] = {Integer(1) << 40, Integer(1) << 40, Integer(1) << 40};
  std::int64_t made = 0;
  for (auto _ : state) {
    Complex complex = make_box(random, lower, upper);
    Splitter splitter(complex);
    for (std::int64_t k = 0; k < state.range(0); ++k) {
      const PlaneId plane = random.surfaces()[static_cast<std::size_t>(k)].plane;
      const auto cells = static_cast<CellId>(complex.cells.size());
      for (CellId c = 0; c < cells; ++c) splitter.cut_cell(c, plane);
    }
    made += static_cast<std::int64_t>(complex.cells.size());
    benchmark::DoNotOptimize(complex);
  }
  state.SetItemsProcessed(made);
}
BENCHMARK(cut)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

void build(benchmark::State& state, const char* name, double rotate) {
  const Scene made = make_scene(model(name, state.range(0), rotate));
  for (auto _ : state) benchmark::DoNotOptimize(sightline::build(made));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK_CAPTURE(build, city, "city", 0)->Arg(1'125)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, random, "random", 0)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, building, "building", 0)->Arg(1'000)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build, building_rotated, "building", 17)->Arg(1'000)->Unit(benchmark::kMillisecond);

void tree(benchmark::State& state, const char* name, double rotate, unsigned threads = 1) {
  const Scene made = make_scene(model(name, state.range(0), rotate));
  for (auto _ : state) benchmark::DoNotOptimize(BspTree(made, {.threads = threads}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK_CAPTURE(tree, city, "city", 0)->Arg(1'125)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree, random, "random", 0)->Arg(1'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree, building, "building", 0)
    ->RangeMultiplier(10)
    ->Range(1'000, 1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree, building_rotated, "building", 17)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree, building_by_two, "building", 0, 2)->Arg(100'000)->UseRealTime()->Unit(benchmark::kMillisecond);

/// A lazy tree and the first map on it.
void first_map(benchmark::State& state) {
  const Model building = make_model("building", {.polygons = static_cast<std::uint32_t>(state.range(0))});
  const Scene made = make_scene(building.soup);
  const CameraLine& c = building.cameras.front();
  const Camera camera = make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect);
  for (auto _ : state) {
    const BspTree tree(made, {.lazy = true});
    VisibilityMap map;
    Tracer(tree).trace(camera, map);
    benchmark::DoNotOptimize(map);
  }
}
BENCHMARK(first_map)->RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline::bench
