// Orders of sightlines, the tracers' hot decision, and what it takes to make and find lines. "zero": three lines
// through one point; "generic": lines apart.
#include "setting.hpp"

#include <benchmark/benchmark.h>

namespace sightline::bench {
namespace {

enum Case { generic, zero };
const char* const case_name[] = {"generic", "zero"};

GridPoint eye_of(const Settings& s, bool fine) {
  const glm::dvec3 at = s.all[0].world[9];
  return s.grid.point(fine ? at + glm::dvec3(0x1.23456p-10, 0x1.abcdp-10, -0x1.3579bp-10) : at);
}

// Setting 0 holds the eye; the lines are those of the others. k of the three lines are of planes.
void order_ours(benchmark::State& state) {
  Settings s(static_cast<int>(state.range(0)));
  const auto k = state.range(2);
  SightlineTable table(s.planes);
  std::vector<std::array<SightlineRef, 3>> lines;
  std::vector<std::array<PlaneId, 4>> planes;
  for (PointId o = 10; o < 10 * count; o += 10)
    planes.push_back({s.planes.add_points(o, o + 1, o + 4).id, s.planes.add_points(o, o + 2, o + 5).id,
                      s.planes.add_points(o, o + 6, o + 7).id, s.planes.add_points(o + 8, o + 6, o + 5).id});
  table.reset(s.planes, eye_of(s, false));
  for (PointId i = 1; i < count; ++i) {
    const PointId o = 10 * i;
    const auto& p = planes[i - 1];
    const SightlineRef third = table.of_points(state.range(1) == zero ? o : o + 8, o + 6);
    lines.push_back({k > 0 ? table.of_planes(p[0], p[1]) : table.of_points(o, o + 4),
                     k > 1 ? table.of_planes(p[1], p[2]) : table.of_points(o, o + 5), third});
  }
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(table.order(lines[i][0], lines[i][1], lines[i][2]));
    if (++i == lines.size()) i = 0;
  }
  state.SetLabel(case_name[state.range(1)]);
}

// Lines of points only: the orientation of their normals, constructed lazily each time as a program would.
void order_epeck(benchmark::State& state) {
  const Settings s(static_cast<int>(state.range(0)));
  const Kernel::Point_3 eye = s.all[0].point[9];
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& p = s.all[1 + i].point;
    const auto normal = [&](std::size_t a, std::size_t b) { return CGAL::cross_product(p[a] - eye, p[b] - eye); };
    const auto third = state.range(1) == zero ? normal(0, 6) : normal(8, 6);
    benchmark::DoNotOptimize(CGAL::orientation(normal(0, 4), normal(0, 5), third));
    if (++i == count - 1) i = 0;
  }
  state.SetLabel(case_name[state.range(1)]);
}

// All lines of all settings once after a reset; the time is that of one line.
void of_points_new(benchmark::State& state) {
  const Settings s(static_cast<int>(state.range(0)));
  SightlineTable table(s.planes);
  const GridPoint eye = eye_of(s, state.range(1) != 0);
  for (auto _ : state) {
    table.reset(s.planes, eye);
    for (PointId o = 10; o < 10 * count; o += 10)
      for (PointId i = 0; i < 4; ++i) benchmark::DoNotOptimize(table.of_points(o + i, o + i + 4));
  }
  state.SetItemsProcessed(state.iterations() * 4 * (count - 1));
  state.SetLabel(state.range(1) != 0 ? "eye finer than the grid" : "eye on the grid");
}

void of_points_again(benchmark::State& state) {
  const Settings s(static_cast<int>(state.range(0)));
  SightlineTable table(s.planes);
  table.reset(s.planes, eye_of(s, false));
  PointId o = 10;
  for (auto _ : state) {
    benchmark::DoNotOptimize(table.of_points(o, o + 4));
    o = o == 10 * (count - 1) ? 10 : o + 10;
  }
}

void window_st(benchmark::State& state) {
  const Settings s(static_cast<int>(state.range(0)));
  SightlineTable table(s.planes);
  table.reset(s.planes, eye_of(s, false));
  const Window window({0x1.234567p-1, 0x1.3p-2, -0x1.89abcep-1}, {0x1.98p-1, 0x1.33p-4, 0x1.77777p-1},
                      {0x1.1p-6, 0x1.fffp-1, 0x1.8p-3});
  std::vector<std::array<SightlineId, 2>> pairs;
  for (PointId o = 10; o < 10 * count; o += 10)
    pairs.push_back({table.of_points(o, o + 4).id, table.of_points(o, o + 5).id});
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(window.st(table, pairs[i][0], pairs[i][1]));
    if (++i == pairs.size()) i = 0;
  }
}

void orders(benchmark::internal::Benchmark* b) {
  for (const int bits : {8, 15, 20, 27, 30, 40, 53}) {
    b->Args({bits, generic, 0});
    for (const int k : {0, 1, 2}) b->Args({bits, zero, k});
  }
}
void stages(benchmark::internal::Benchmark* b) {
  for (const int bits : {8, 15, 20, 27, 30, 40, 53})
    for (const int which : {generic, zero}) b->Args({bits, which});
}
void widths(benchmark::internal::Benchmark* b) {
  for (const int bits : {15, 20, 30, 53}) b->Arg(bits);
}
BENCHMARK(order_ours)->Apply(orders);
BENCHMARK(order_epeck)->Apply(stages);
BENCHMARK(of_points_new)->ArgsProduct({{15, 20, 30, 53}, {0, 1}});
BENCHMARK(of_points_again)->Apply(widths);
BENCHMARK(window_st)->Apply(widths);

}  // namespace
}  // namespace sightline::bench
