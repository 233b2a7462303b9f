// A random scene in the tables under test beside the oracle, and counts of cases.
#pragma once

#include "exact/window.hpp"
#include "support.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdio>
#include <optional>

namespace sightline::test {

struct Count {
  long cases = 0, zeros = 0, disagreements = 0;
  void check(Sign ours, Sign truth) {
    ++cases;
    zeros += truth == 0;
    disagreements += ours != truth;
  }
};

/// Cases at a bit length, of every predicate of a test at least: long numbers are slow and get fewer.
inline long cases_at(int bits) { return bits > 1000 ? cases(5000) / 20 : cases(5000); }

inline void report_cases(const char* what, int bits, const Count& c) {
  std::printf("%s, %d bits: %ld cases, %ld zeros, %ld disagreements\n", what, bits, c.cases, c.zeros, c.disagreements);
  EXPECT_EQ(c.disagreements, 0);
  if (c.cases < 200) return;
  EXPECT_GT(c.zeros, c.cases / 500) << "too little degeneracy";
  EXPECT_LT(c.zeros, c.cases);
}

/// The same scene in the tables under test, with its planes beside the oracle's.
struct Bench {
  RandomScene scene;
  Oracle oracle;
  Grid grid;
  PointTable points;
  PlaneTable planes;
  std::vector<PlaneId> ids;          // distinct
  std::vector<Oracle::Plane> exact;  // by PlaneId

  Bench(std::uint64_t seed, int bits, int wanted = 10)
      : scene(seed, bits),
        oracle(scene),
        grid(Grid::covering(scene.points)),
        points(grid, scene.points),
        planes(points) {
    Random random(seed ^ 0x5bd1e995);
    const auto any = [&] { return static_cast<PointId>(random() % scene.points.size()); };
    for (int i = 0; i < wanted; ++i) {
      const PointId a = any(), b = any(), c = any();
      const int axis = below(random, 3);
      switch (below(random, 5)) {
        case 0:
          add(planes.add_wall(a, b, axis), oracle.wall(a, b, axis));
          break;
        case 1: {
          Oracle::Plane p{{0, 0, 0}, oracle.point[a][static_cast<std::size_t>(axis)]};
          p.n[static_cast<std::size_t>(axis)] = 1;
          add(planes.add_axis(axis, points.point(a)[static_cast<std::size_t>(axis)]), p);
          break;
        }
        default:
          add(planes.add_points(a, b, c), oracle.through(a, b, c));
          break;
      }
    }
  }

 private:
  void add(PlaneTable::Interned made, const Oracle::Plane& p) {
    if (made.id == none || made.id < exact.size()) return;
    ids.push_back(made.id);
    exact.push_back(Oracle::oriented(p));
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;
};

}  // namespace sightline::test
