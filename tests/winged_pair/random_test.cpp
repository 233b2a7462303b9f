// Complexes of scenes in which nothing is in general position: check() finds no fault, and the volumes, computed again
// in another way, add up to the box.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/oracle/scenes.hpp"
#include "tests/winged_pair/samples.hpp"
#include "winged_pair/traverse.hpp"

namespace sightline::testing {
namespace {

std::uint64_t cases(std::uint64_t usual) {
  const char* wanted = std::getenv("SIGHTLINE_CASES");
  return wanted == nullptr ? usual : std::strtoull(wanted, nullptr, 10);
}

using Point = std::array<mpq_class, 3>;

/// Solves the three plane equations by elimination.
Point solve(const PlaneTable& planes, const PlaneId (&plane)[3]) {
  mpq_class m[3][4];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) m[i][k] = planes.integer(plane[i], k);
  }
  for (int k = 0; k < 3; ++k) {
    int pivot = k;
    while (m[pivot][k] == 0) ++pivot;
    std::swap(m[pivot], m[k]);
    for (int i = 0; i < 3; ++i) {
      if (i == k) continue;
      const mpq_class factor = m[i][k] / m[k][k];
      for (int j = k; j < 4; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return {m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
}

/// Six times the volume of the tetrahedron of a point and a triangle.
mpq_class volume(const Point& o, const Point& a, const Point& b, const Point& c) {
  const auto d = [&o](const Point& p, std::size_t k) { return mpq_class(p[k] - o[k]); };
  return d(a, 0) * (d(b, 1) * d(c, 2) - d(b, 2) * d(c, 1)) - d(a, 1) * (d(b, 0) * d(c, 2) - d(b, 2) * d(c, 0)) +
         d(a, 2) * (d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0));
}

void expect_volumes(const Complex& c) {
  std::vector<Point> points;
  for (const Vertex& v : c.vertices) points.push_back(solve(c.planes, v.place.plane));
  mpq_class sum = 0;
  Marks marks;
  std::vector<FaceId> faces;
  for (CellId cell = 0; cell < c.cells.size(); ++cell) {
    mpq_class own = 0;
    faces_of_cell(c, cell, marks, faces);
    const Point& apex = points[pair_tail(c, c.faces[faces[0]].pair)];
    for (const FaceId f : faces) {
      const PairId first = c.faces[f].pair;
      const Sign outward = c.faces[f].cell[0] == cell ? 1 : -1;
      for_pairs_of_face(c, f, [&](PairId p) {
        own += outward * volume(apex, points[pair_tail(c, first)], points[pair_tail(c, p)], points[pair_head(c, p)]);
      });
    }
    EXPECT_GT(own, 0);
    sum += own;
  }
  const Integer box = (c.box[1][0] - c.box[0][0]) * (c.box[1][1] - c.box[0][1]) * (c.box[1][2] - c.box[0][2]);
  EXPECT_EQ(sum, mpq_class(6 * box));
}

TEST(RandomComplexes, AreRight) {
  for (std::uint64_t seed = 0; seed < cases(400); ++seed) {
    const Case sample = make_case(seed);
    const Scene scene = make_scene(sample.soup, sample.options);
    const std::string faults = joined(check(build(scene), scene));
    ASSERT_EQ(faults, "") << "seed " << seed;
  }
}

TEST(RandomComplexes, VolumesAddUp) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Scene scene = make_scene(make_case(seed, 5).soup);
    expect_volumes(build(scene));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace sightline::testing
