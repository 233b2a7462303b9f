// The laws of exact/plane_table.hpp and exact/predicates.hpp, by their numbers.
#include "tables.hpp"

#include "exact/edge_vertex.hpp"
#include "exact/rounding.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sightline::test {
namespace {

int some_bits(std::uint64_t seed) { return bit_lengths[seed % (bit_lengths.size() - 1)]; }
template <class T>
const T& any_of(const std::vector<T>& v, Random& random) {
  return v[random() % v.size()];
}

// Law 1: ids are equal just if the planes are.
RC_GTEST_PROP(PlaneTableLaws, Law1IdsArePlanes, (std::uint64_t seed)) {
  const RandomScene scene(seed, some_bits(seed));
  const Oracle oracle(scene);
  const Grid grid = Grid::covering(scene.points);
  const PointTable points(grid, scene.points);
  PlaneTable planes(points);
  std::vector<std::pair<PlaneId, Oracle::Plane>> made;
  for (PointId a = 0; a < 6; ++a)
    for (PointId b = 0; b < a; ++b)
      for (PointId c = 0; c < b; ++c) {
        const auto p = planes.add_points(a, b, c);
        const Oracle::Plane exact = oracle.through(a, b, c);
        RC_ASSERT((p.id == none) == is_zero(exact.n));
        if (p.id == none) continue;
        RC_ASSERT(p.flipped == (sign_of_first(exact.n) < 0));
        made.emplace_back(p.id, exact);
      }
  for (const auto& [p, exact] : made)
    for (const auto& [q, other] : made) RC_ASSERT((p == q) == Oracle::same(exact, other));
}

// Law 2: exchanging two of the points, or a wall's points, turns the plane over: same id, other `flipped`.
RC_GTEST_PROP(PlaneTableLaws, Law2Turning, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed), 0);
  const auto p = b.planes.add_points(0, 1, 2), q = b.planes.add_points(1, 0, 2), r = b.planes.add_points(1, 2, 0);
  RC_ASSERT(p.id == q.id && p.id == r.id);
  if (p.id != none) RC_ASSERT(p.flipped != q.flipped && p.flipped == r.flipped);
  const auto w = b.planes.add_wall(0, 1, 2), v = b.planes.add_wall(1, 0, 2);
  RC_ASSERT(w.id == v.id);
  if (w.id != none) RC_ASSERT(w.flipped != v.flipped);
}

// Law 3: canonical: no common divisor, the first component positive, through its points; walls parallel to their axis.
RC_GTEST_PROP(PlaneTableLaws, Law3Canonical, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  for (const PlaneId p : b.ids) {
    const Vector n{b.planes.integer(p, 0), b.planes.integer(p, 1), b.planes.integer(p, 2)};
    const Integer d = b.planes.integer(p, 3);
    RC_ASSERT(gcd(gcd(n[0], n[1]), gcd(n[2], d)) == 1);
    RC_ASSERT(sign_of_first(n) == 1);
    const PlaneSource& s = b.planes.source(p);
    const auto on = [&](PointId x) { return product(n, b.points.point(x)) == d; };
    if (s.kind == PlaneSource::points) RC_ASSERT(on(s.a) && on(s.b) && on(s.c));
    if (s.kind == PlaneSource::wall) RC_ASSERT(on(s.a) && on(s.b) && n[s.c] == 0);
    if (s.kind == PlaneSource::axis) RC_ASSERT(b.planes.axis(p) == static_cast<int>(s.a));
    const int axis = b.planes.axis(p);
    RC_ASSERT((axis >= 0) == ((n[0] == 0) + (n[1] == 0) + (n[2] == 0) == 2));
  }
}

// Divisors that are powers of two, beyond a word and alone or not.
TEST(PlaneTable, DivisorsOfManyTwos) {
  for (const double scale : {0x1p3, 0x1p40, 0x1p63, 0x1p64, 0x1p100}) {
    for (const double factor : {1.0, 15.0}) {
      const double s = scale * factor;
      const std::vector<glm::dvec3> world{{0, 0, 0}, {s, 0, 0}, {0, 2 * s, 0}, {0, 0, 3 * s}, {1, 1, 1}};
      const Grid grid = Grid::covering(world);
      const PointTable points(grid, world);
      PlaneTable planes(points);
      const PlaneId p = planes.add_points(1, 2, 3).id, wall = planes.add_wall(1, 2, 2).id;
      const auto normal = [&](PlaneId q) {
        return Vector{planes.integer(q, 0), planes.integer(q, 1), planes.integer(q, 2)};
      };
      EXPECT_EQ(normal(p), (Vector{6, 3, 2})) << s;  // x / s + y / 2s + z / 3s = 1
      EXPECT_EQ(normal(wall), (Vector{2, 1, 0})) << s;
      for (const PointId k : {1u, 2u, 3u}) EXPECT_EQ(product(normal(p), points.point(k)), planes.integer(p, 3)) << s;
      for (const PointId k : {1u, 2u}) EXPECT_EQ(product(normal(wall), points.point(k)), planes.integer(wall, 3)) << s;
    }
  }
}

// Law 4: approximations are within 2^-53, and the largest |n| is in [1/2, 1].
RC_GTEST_PROP(PlaneTableLaws, Law4Approximations, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  for (const PlaneId p : b.ids) {
    const ApproxPlane& q = b.planes.approx(p);
    const mpq_class scale(Integer(1) << b.planes.normal_bits(p));
    const mpq_class unit(Integer(1) << static_cast<unsigned>(b.grid.unit_bits())), tolerance(0x1p-53);
    double largest = 0;
    for (int k = 0; k < 3; ++k) {
      RC_ASSERT(abs(mpq_class(q.n[k]) - mpq_class(b.planes.integer(p, k)) / scale) <= tolerance);
      largest = std::max(largest, std::abs(q.n[k]));
    }
    RC_ASSERT(largest >= 0.5 && largest <= 1);
    RC_ASSERT(std::abs(q.d) <= 2);
    RC_ASSERT(abs(mpq_class(q.d) - mpq_class(b.planes.integer(p, 3)) / scale / unit) <= tolerance);
  }
}

// Law 1: a plane's own points lie on it.
RC_GTEST_PROP(PredicateLaws, Law1OwnPoints, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  for (const PlaneId p : b.ids) {
    const PlaneSource& s = b.planes.source(p);
    if (s.kind == PlaneSource::points)
      for (const PointId x : {s.a, s.b, s.c}) RC_ASSERT(point_side(b.planes, x, p) == 0);
  }
}

// Laws 2, 3: vertex_side does not depend on the order of the vertex's planes; own planes are zero by identity.
RC_GTEST_PROP(PredicateLaws, Law2And3VertexSide, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  Random random(seed);
  RC_PRE(b.ids.size() >= 4);
  for (int i = 0; i < 10; ++i) {
    const PlaneId x = any_of(b.ids, random), y = any_of(b.ids, random), z = any_of(b.ids, random);
    if (planes_orientation(b.planes, x, y, z) == 0) continue;
    const ImplicitVertex v = make_vertex(b.planes, x, y, z), w = make_vertex(b.planes, z, x, y),
                         u = make_vertex(b.planes, y, x, z);
    for (const PlaneId q : b.ids) {
      const Sign s = vertex_side(b.planes, v, q);
      RC_ASSERT(s == vertex_side(b.planes, w, q));
      RC_ASSERT(s == vertex_side(b.planes, u, q));
    }
    const Tally before = tally();
    RC_ASSERT(vertex_side(b.planes, v, x) == 0 && vertex_side(b.planes, v, y) == 0);
    RC_ASSERT((tally() - before).identity == 2u);
    RC_ASSERT(same_vertex(b.planes, v, w) && same_vertex(b.planes, u, v));
  }
}

// Law 4: the vertex of three planes through one point of the scene lies where that point lies.
RC_GTEST_PROP(PredicateLaws, Law4VertexAtPoint, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  std::vector<PlaneId> through;
  for (const PlaneId p : b.ids)
    if (point_side(b.planes, 0, p) == 0) through.push_back(p);
  for (PointId i = 1; i + 1 < b.points.size(); ++i)
    if (const auto p = b.planes.add_points(0, i, i + 1); p.id != none) through.push_back(p.id);
  for (std::size_t i = 0; i + 2 < through.size(); ++i) {
    if (planes_orientation(b.planes, through[i], through[i + 1], through[i + 2]) == 0) continue;
    const ImplicitVertex v = make_vertex(b.planes, through[i], through[i + 1], through[i + 2]);
    for (const PlaneId q : b.ids) RC_ASSERT(vertex_side(b.planes, v, q) == point_side(b.planes, 0, q));
  }
}

// The law of exact/edge_vertex.hpp: a place told by two points of the scene is the vertex of its three planes.
RC_GTEST_PROP(PredicateLaws, EdgeVertex, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  Random random(seed);
  for (int i = 0; i < 10; ++i) {
    const auto any = [&] { return static_cast<PointId>(random() % b.points.size()); };
    const PointId from = any(), to = any();
    const PlaneId face = b.planes.add_points(from, to, any()).id,
                  wall = b.planes.add_wall(from, to, below(random, 3)).id;
    const PlaneId cut = any_of(b.ids, random);
    if (face == none || wall == none || planes_orientation(b.planes, face, wall, cut) == 0) continue;
    if (point_side(b.planes, from, cut) * point_side(b.planes, to, cut) >= 0) continue;
    const ImplicitVertex v = make_vertex(b.planes, face, wall, cut),
                         w = make_edge_vertex(b.planes, face, wall, cut, from, to);
    RC_ASSERT(same_vertex(b.planes, v, w));
    for (int k = 0; k < 3; ++k) RC_ASSERT(std::abs(v.approx[k] - w.approx[k]) <= v.error + w.error);
    for (const PlaneId q : b.ids) {
      RC_ASSERT(edge_vertex_side(b.planes, cut, from, to, q) == vertex_side(b.planes, v, q));
    }
  }
}

// Laws 5, 6: planes_orientation changes sign with every exchange; parallel planes make it zero with every third.
RC_GTEST_PROP(PredicateLaws, Law5And6Orientation, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  for (const PlaneId x : b.ids)
    for (const PlaneId y : b.ids) {
      RC_ASSERT(parallel(b.planes, x, y) == parallel(b.planes, y, x));
      for (const PlaneId z : b.ids) {
        const Sign s = planes_orientation(b.planes, x, y, z);
        RC_ASSERT(s == -planes_orientation(b.planes, y, x, z));
        RC_ASSERT(s == planes_orientation(b.planes, y, z, x));
        if (parallel(b.planes, x, y)) RC_ASSERT(s == 0);
      }
    }
}

// Law 7: the vertex is within its error, and that is below 2^-48 in the unit box.
RC_GTEST_PROP(PredicateLaws, Law7VertexError, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed));
  Random random(seed);
  RC_PRE(b.ids.size() >= 3);
  const mpq_class unit(Integer(1) << static_cast<unsigned>(b.grid.unit_bits()));
  for (int i = 0; i < 10; ++i) {
    const PlaneId id[3] = {any_of(b.ids, random), any_of(b.ids, random), any_of(b.ids, random)};
    if (planes_orientation(b.planes, id[0], id[1], id[2]) == 0) continue;
    const ImplicitVertex v = make_vertex(b.planes, id[0], id[1], id[2]);
    Oracle::Plane p[3];
    for (std::size_t j = 0; j < 3; ++j)
      p[j] = {{b.planes.integer(id[j], 0), b.planes.integer(id[j], 1), b.planes.integer(id[j], 2)},
              b.planes.integer(id[j], 3)};
    const Oracle::Vertex exact = Oracle::meet(p[0], p[1], p[2]);
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      mpq_class x(exact.x[k], exact.w);
      x.canonicalize();
      x /= unit;
      const double approx = v.approx[static_cast<int>(k)];
      RC_ASSERT(abs(mpq_class(approx) - x) <= mpq_class(v.error));
      inside = inside && std::abs(approx) <= 1;
    }
    if (inside) RC_ASSERT(v.error < 0x1p-48);
  }
}

// Laws 8, 9: orientation changes sign with every exchange; compare is a total order.
RC_GTEST_PROP(PredicateLaws, Law8And9Points, (std::uint64_t seed)) {
  Bench b(seed, some_bits(seed), 0);
  for (PointId p = 0; p < b.points.size(); ++p)
    for (PointId q = 0; q < b.points.size(); ++q)
      for (int axis = 0; axis < 3; ++axis) {
        const double x = b.scene.points[p][axis], y = b.scene.points[q][axis];
        RC_ASSERT(compare(b.points, p, q, axis) == (x > y) - (x < y));
        const PointId r = (p + q) % b.points.size();
        const Sign s = orientation(b.points, p, q, r, axis);
        RC_ASSERT(s == -orientation(b.points, q, p, r, axis));
        RC_ASSERT(s == orientation(b.points, q, r, p, axis));
      }
}

TEST(Predicates, RefuseDegenerateVertices) {
  Bench b(1, 20, 0);
  const PlaneId x = b.planes.add_axis(0, 1).id, y = b.planes.add_axis(0, 2).id, z = b.planes.add_axis(1, 2).id;
  EXPECT_THROW((void)make_vertex(b.planes, x, y, z), std::invalid_argument);
  EXPECT_THROW((void)make_vertex(b.planes, x, x, z), std::invalid_argument);
  EXPECT_THROW((void)b.planes.add_axis(3, 1), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::test
