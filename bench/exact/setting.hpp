// Points of a given bit length with degenerate companions, for the exact benchmarks.
#pragma once

#include "exact/window.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <cmath>
#include <random>
#include <vector>

namespace sightline::bench {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
inline constexpr int count = 256;  // settings, gone through in turn

/// Points 0..9: 0, 1, 2 span a plane, 3 lies in it, the others are random. Coordinates are integers of `bits` bits.
struct Setting {
  std::vector<glm::dvec3> world;
  std::vector<Kernel::Point_3> point;

  Setting(int bits, std::mt19937_64& random) {
    const auto any = [&] {
      const auto m = static_cast<std::int64_t>(random() >> (66 - bits)) - (std::int64_t{1} << (bits - 3));
      return static_cast<double>(m);
    };
    for (int i = 0; i < 3; ++i) world.emplace_back(any(), any(), any());
    world.push_back(world[0] + world[1] - world[2]);
    for (int i = 0; i < 6; ++i) world.emplace_back(any(), any(), any());
    for (const auto& p : world) point.emplace_back(p.x, p.y, p.z);
  }
};

/// All settings of a bit length in one set of tables: point i of setting s is 10 s + i.
struct Settings {
  std::vector<Setting> all;
  Grid grid;
  PointTable points;
  PlaneTable planes;

  explicit Settings(int bits) : all(make(bits)), grid(Grid::covering(world())), points(grid, world()), planes(points) {}
  Settings(const Settings&) = delete;
  Settings& operator=(const Settings&) = delete;

 private:
  static std::vector<Setting> make(int bits) {
    std::mt19937_64 random(static_cast<unsigned>(bits));
    std::vector<Setting> r;
    for (int i = 0; i < count; ++i) r.emplace_back(bits, random);
    return r;
  }
  std::vector<glm::dvec3> world() const {
    std::vector<glm::dvec3> r;
    for (const Setting& s : all) r.insert(r.end(), s.world.begin(), s.world.end());
    return r;
  }
};

}  // namespace sightline::bench
