// Against CGAL's exact constructions kernel: planes, vertices and sightlines are constructed, sides asked for.
#include "tables.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

namespace sightline::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 point_of(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
int sign_of_side(CGAL::Oriented_side s) {
  return s == CGAL::ON_POSITIVE_SIDE ? 1 : s == CGAL::ON_NEGATIVE_SIDE ? -1 : 0;
}

class AgainstCgal : public testing::TestWithParam<int> {};

TEST_P(AgainstCgal, SidesOfPointsAndVertices) {
  Count points, vertices, orders;
  std::optional<SightlineTable> table;
  for (std::uint64_t seed = 1; vertices.cases < cases(20000) / 20; ++seed) {
    const RandomScene scene(seed * 7919 + static_cast<unsigned>(GetParam()), GetParam());
    const Grid grid = Grid::covering(scene.points);
    const PointTable held(grid, scene.points);
    PlaneTable planes(held);
    std::vector<Kernel::Point_3> p;
    for (const auto& x : scene.points) p.push_back(point_of(x));
    std::vector<PlaneId> ids;
    std::vector<int> turn;
    std::vector<Kernel::Plane_3> exact;
    Random random(seed);
    const auto any = [&] { return static_cast<PointId>(random() % p.size()); };
    for (int i = 0; i < 8; ++i) {
      const PointId a = any(), b = any(), c = any();
      const auto made = planes.add_points(a, b, c);
      ASSERT_EQ(made.id == none, CGAL::collinear(p[a], p[b], p[c]));
      if (made.id == none) continue;
      ids.push_back(made.id);
      turn.push_back(made.flipped ? -1 : 1);
      exact.emplace_back(p[a], p[b], p[c]);
    }
    for (std::size_t i = 0; i < ids.size(); ++i)
      for (PointId x = 0; x < p.size(); ++x)
        points.check(turn[i] * point_side(planes, x, ids[i]), sign_of_side(exact[i].oriented_side(p[x])));
    for (std::size_t i = 0; i + 2 < ids.size(); ++i) {
      const auto meet = CGAL::intersection(exact[i], exact[i + 1], exact[i + 2]);
      const Kernel::Point_3* const at = meet ? boost::get<Kernel::Point_3>(&*meet) : nullptr;
      ASSERT_EQ(at != nullptr, planes_orientation(planes, ids[i], ids[i + 1], ids[i + 2]) != 0);
      if (at == nullptr) continue;
      const ImplicitVertex v = make_vertex(planes, ids[i], ids[i + 1], ids[i + 2]);
      for (std::size_t j = 0; j < ids.size(); ++j)
        vertices.check(turn[j] * vertex_side(planes, v, ids[j]), sign_of_side(exact[j].oriented_side(*at)));
    }
    // A line's side of a point is the orientation of the eye's tetrahedron.
    if (!table) table.emplace(planes);
    table->reset(planes, grid.point(scene.eye));
    const Kernel::Point_3 eye = point_of(scene.eye);
    for (int i = 0; i < 10; ++i) {
      const PointId a = any(), b = any(), c = any();
      const auto ref = table->of_points(a, b);
      ASSERT_EQ(ref.id == none, CGAL::collinear(eye, p[a], p[b]));
      if (ref.id == none) continue;
      points.check(table->side(ref, c), static_cast<int>(CGAL::orientation(eye, p[a], p[b], p[c])));
      const PointId d = any(), e = any();
      const auto other = table->of_points(c, d), third = table->of_points(d, e);
      if (other.id == none || third.id == none) continue;
      const auto normal = [&](PointId x, PointId y) { return CGAL::cross_product(p[x] - eye, p[y] - eye); };
      orders.check(table->order(ref, other, third),
                   static_cast<int>(CGAL::orientation(normal(a, b), normal(c, d), normal(d, e))));
    }
  }
  report_cases("CGAL: points", GetParam(), points);
  report_cases("CGAL: vertices", GetParam(), vertices);
  report_cases("CGAL: orders", GetParam(), orders);
}

INSTANTIATE_TEST_SUITE_P(Bits, AgainstCgal, testing::Values(8, 20, 30, 53, 60, 110));

}  // namespace
}  // namespace sightline::test
