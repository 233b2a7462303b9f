// Sides of points and vertices. "generic": the filter decides; "zero": only exact arithmetic can; "exact_generic": the
// exact stage where the answer is not zero.
#include "setting.hpp"

#include "exact/plane_row.hpp"

#include <benchmark/benchmark.h>
#include <boost/variant.hpp>

namespace sightline::bench {
namespace {

enum Case { generic, zero, exact_generic };
const char* const case_name[] = {"generic", "zero", "exact_generic"};

template <class F>
void run(benchmark::State& state, F&& decide) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(decide(i));
    i = (i + 1) % count;
  }
}

void point_side_ours(benchmark::State& state) {
  Settings s(static_cast<int>(state.range(0)));
  std::vector<PlaneId> plane;
  for (PointId i = 0; i < count; ++i) plane.push_back(s.planes.add_points(10 * i, 10 * i + 1, 10 * i + 2).id);
  const PointId p = state.range(1) == zero ? 3 : 4;
  run(state, [&](std::size_t i) { return point_side(s.planes, static_cast<PointId>(10 * i) + p, plane[i]); });
  state.SetLabel(case_name[state.range(1)]);
}
void point_side_epeck(benchmark::State& state) {
  const Settings s(static_cast<int>(state.range(0)));
  std::vector<Kernel::Plane_3> plane;
  for (const Setting& x : s.all) plane.emplace_back(x.point[0], x.point[1], x.point[2]);
  const std::size_t p = state.range(1) == zero ? 3 : 4;
  run(state, [&](std::size_t i) {
    // A fresh point each time, so that no exact value is remembered from the round before.
    const auto& w = s.all[i].world[p];
    return static_cast<int>(plane[i].oriented_side(Kernel::Point_3(w.x, w.y, w.z)));
  });
  state.SetLabel(case_name[state.range(1)]);
}

// Three planes through point 0, and a fourth through it (zero) or not.
void vertex_side_ours(benchmark::State& state) {
  Settings s(static_cast<int>(state.range(0)));
  std::vector<ImplicitVertex> vertex;
  std::vector<PlaneId> plane;
  for (PointId i = 0; i < count; ++i) {
    const PointId o = 10 * i;
    const auto add = [&](PointId a, PointId b, PointId c) { return s.planes.add_points(o + a, o + b, o + c).id; };
    vertex.push_back(make_vertex(s.planes, add(0, 4, 5), add(0, 6, 7), add(0, 8, 9)));
    plane.push_back(state.range(1) == zero ? add(0, 1, 2) : add(4, 6, 8));
  }
  if (state.range(1) == exact_generic) {
    run(state, [&](std::size_t i) {
      const ImplicitVertex& v = vertex[i];
      return exact_rows_orientation({PlaneRow(s.planes, v.plane[0]), PlaneRow(s.planes, v.plane[1]),
                                     PlaneRow(s.planes, v.plane[2]), PlaneRow(s.planes, plane[i])});
    });
  } else {
    run(state, [&](std::size_t i) { return vertex_side(s.planes, vertex[i], plane[i]); });
  }
  state.SetLabel(case_name[state.range(1)]);
}
void vertex_side_epeck(benchmark::State& state) {
  const Settings s(static_cast<int>(state.range(0)));
  std::vector<std::array<Kernel::Plane_3, 4>> planes;
  for (const Setting& x : s.all) {
    const auto& p = x.point;
    planes.push_back({Kernel::Plane_3(p[0], p[4], p[5]), Kernel::Plane_3(p[0], p[6], p[7]),
                      Kernel::Plane_3(p[0], p[8], p[9]),
                      state.range(1) == zero ? Kernel::Plane_3(p[0], p[1], p[2]) : Kernel::Plane_3(p[4], p[6], p[8])});
  }
  run(state, [&](std::size_t i) {
    // The vertex is constructed each time: lazily, and exactly only where that is needed.
    const auto& q = planes[i];
    const auto meet = CGAL::intersection(q[0], q[1], q[2]);
    return static_cast<int>(q[3].oriented_side(*boost::get<Kernel::Point_3>(&*meet)));
  });
  state.SetLabel(case_name[state.range(1)]);
}

void make_vertex_ours(benchmark::State& state) {
  Settings s(static_cast<int>(state.range(0)));
  std::vector<std::array<PlaneId, 3>> planes;
  for (PointId i = 0; i < count; ++i) {
    const PointId o = 10 * i;
    const auto add = [&](PointId a, PointId b, PointId c) { return s.planes.add_points(o + a, o + b, o + c).id; };
    planes.push_back({add(0, 4, 5), add(0, 6, 7), add(0, 8, 9)});
  }
  run(state, [&](std::size_t i) { return make_vertex(s.planes, planes[i][0], planes[i][1], planes[i][2]).approx.x; });
}

void orientation_ours(benchmark::State& state) {
  const Settings s(static_cast<int>(state.range(0)));
  run(state, [&](std::size_t i) {
    const auto o = static_cast<PointId>(10 * i);
    return orientation(s.points, o, o + 1, o + 2, 2);
  });
}

void stages(benchmark::internal::Benchmark* b) {
  for (const int bits : {8, 15, 20, 27, 30, 40, 53})
    for (const int which : {generic, zero}) b->Args({bits, which});
}
void widths(benchmark::internal::Benchmark* b) {
  for (const int bits : {8, 15, 20, 27, 30, 40, 53}) b->Arg(bits);
}
void all_stages(benchmark::internal::Benchmark* b) {
  for (const int bits : {8, 15, 20, 27, 30, 40, 53})
    for (const int which : {generic, zero, exact_generic}) b->Args({bits, which});
}
BENCHMARK(point_side_ours)->Apply(stages);
BENCHMARK(point_side_epeck)->Apply(stages);
BENCHMARK(vertex_side_ours)->Apply(all_stages);
BENCHMARK(vertex_side_epeck)->Apply(stages);
BENCHMARK(make_vertex_ours)->Apply(widths);
BENCHMARK(orientation_ours)->Apply(widths);

}  // namespace
}  // namespace sightline::bench
