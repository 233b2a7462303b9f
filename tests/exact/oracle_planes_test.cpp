// Points, planes and vertices against GMP: every decision of many degenerate scenes.
#include "support.hpp"
#include "tables.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

class ByBits : public testing::TestWithParam<int> {
 protected:
  static long wanted() { return cases_at(GetParam()); }
  static void report(const char* what, const Count& c) { report_cases(what, GetParam(), c); }
};

TEST_P(ByBits, PointSide) {
  Count count;
  for (std::uint64_t seed = 1; count.cases < wanted(); ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam());
    for (const PlaneId q : b.ids)
      for (PointId p = 0; p < b.points.size(); ++p)
        count.check(point_side(b.planes, p, q), Oracle::side(b.exact[q], b.oracle.point[p]));
  }
  report("point_side", count);
}

TEST_P(ByBits, VertexSide) {
  Count count, orientations;
  for (std::uint64_t seed = 1; std::min(count.cases, orientations.cases) < wanted(); ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam(), 7);
    Random random(seed);
    if (b.ids.size() < 4) continue;
    for (int i = 0; i < 6; ++i) {
      std::array<PlaneId, 3> p;
      for (PlaneId& x : p) x = b.ids[random() % b.ids.size()];
      const Oracle::Vertex truth = Oracle::meet(b.exact[p[0]], b.exact[p[1]], b.exact[p[2]]);
      orientations.check(planes_orientation(b.planes, p[0], p[1], p[2]), sgn(truth.w));
      if (truth.w == 0) {
        EXPECT_THROW((void)make_vertex(b.planes, p[0], p[1], p[2]), std::invalid_argument);
        continue;
      }
      const ImplicitVertex v = make_vertex(b.planes, p[0], p[1], p[2]);
      for (const PlaneId q : b.ids) count.check(vertex_side(b.planes, v, q), Oracle::side(b.exact[q], truth));
    }
  }
  report("vertex_side", count);
  report("planes_orientation", orientations);
}

TEST_P(ByBits, SameVertexAndParallel) {
  Count same, parallels;
  for (std::uint64_t seed = 1; std::min(same.cases, parallels.cases) < wanted(); ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam(), 7);
    Random random(seed);
    if (b.ids.size() < 4) continue;
    for (const PlaneId p : b.ids)
      for (const PlaneId q : b.ids)
        parallels.check(parallel(b.planes, p, q) ? 0 : 1, is_zero(cross_product(b.exact[p].n, b.exact[q].n)) ? 0 : 1);
    std::vector<ImplicitVertex> vertices;
    std::vector<Oracle::Vertex> truth;
    for (int i = 0; i < 12; ++i) {
      std::array<PlaneId, 3> p;
      for (PlaneId& x : p) x = b.ids[random() % b.ids.size()];
      const Oracle::Vertex v = Oracle::meet(b.exact[p[0]], b.exact[p[1]], b.exact[p[2]]);
      if (v.w == 0) continue;
      truth.push_back(v);
      vertices.push_back(make_vertex(b.planes, p[0], p[1], p[2]));
    }
    for (std::size_t i = 0; i < truth.size(); ++i)
      for (std::size_t j = 0; j < truth.size(); ++j) {
        const bool equal = truth[i].x[0] * truth[j].w == truth[j].x[0] * truth[i].w &&
                           truth[i].x[1] * truth[j].w == truth[j].x[1] * truth[i].w &&
                           truth[i].x[2] * truth[j].w == truth[j].x[2] * truth[i].w;
        same.check(same_vertex(b.planes, vertices[i], vertices[j]) ? 0 : 1, equal ? 0 : 1);
      }
  }
  report("same_vertex", same);
  report("parallel", parallels);
}

TEST_P(ByBits, OrientationAndCompare) {
  Count orientations, comparisons;
  for (std::uint64_t seed = 1; orientations.cases < wanted(); ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam(), 0);
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const auto any = [&] { return static_cast<PointId>(random() % b.points.size()); };
      const PointId p = any(), q = any(), r = any();
      const int axis = below(random, 3);
      const auto k = static_cast<std::size_t>(axis);
      const auto& x = b.oracle.point;
      const mpz_class truth = cross_product(minus(x[q], x[p]), minus(x[r], x[p]))[k];
      orientations.check(orientation(b.points, p, q, r, axis), sgn(truth));
      comparisons.check(compare(b.points, p, q, axis), sgn(mpz_class(x[p][k] - x[q][k])));
    }
  }
  report("orientation", orientations);
  report("compare", comparisons);
}

INSTANTIATE_TEST_SUITE_P(Bits, ByBits, testing::ValuesIn(bit_lengths));

}  // namespace
}  // namespace sightline::test
