// Making the tables of a scene of 100,000 quadrilaterals: points, then each one's plane and its four walls.
#include "exact/plane_table.hpp"

#include <benchmark/benchmark.h>
#include <random>

namespace sightline::bench {
namespace {

constexpr PointId polygons = 100000;

std::vector<glm::dvec3> corners(int bits) {
  std::mt19937_64 random(7);
  std::vector<glm::dvec3> r(4 * polygons);
  for (glm::dvec3& p : r)
    for (int k = 0; k < 3; ++k)
      p[k] = static_cast<double>(static_cast<std::int64_t>(random() >> (64 - bits)) - (std::int64_t{1} << (bits - 1)));
  return r;
}

void point_table(benchmark::State& state) {
  const auto world = corners(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const PointTable points(Grid::covering(world), world);
    benchmark::DoNotOptimize(points.size());
  }
}

void plane_table(benchmark::State& state) {
  const auto world = corners(static_cast<int>(state.range(0)));
  const PointTable points(Grid::covering(world), world);
  for (auto _ : state) {
    PlaneTable planes(points);
    for (PointId p = 0; p < 4 * polygons; p += 4) {
      planes.add_points(p, p + 1, p + 2);
      for (PointId k = 0; k < 4; ++k) planes.add_wall(p + k, p + (k + 1) % 4, 2);
    }
    benchmark::DoNotOptimize(planes.size());
  }
}

BENCHMARK(point_table)->Arg(20)->Arg(53)->Unit(benchmark::kMillisecond);
BENCHMARK(plane_table)->Arg(15)->Arg(20)->Arg(30)->Arg(53)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline::bench
