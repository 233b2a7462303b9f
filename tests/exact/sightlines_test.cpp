// The laws of exact/sightline_table.hpp, by their numbers.
#include "tables.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sightline::test {
namespace {

int some_bits(std::uint64_t seed) { return bit_lengths[seed % (bit_lengths.size() - 1)]; }

struct Lit {
  Bench bench;
  SightlineTable table;
  std::vector<SightlineRef> refs;
  explicit Lit(std::uint64_t seed, int bits) : bench(seed, bits), table(bench.planes) {
    table.reset(bench.planes, bench.grid.point(bench.scene.eye));
    for (PointId a = 0; a < 6; ++a)
      for (PointId b = 0; b < a; ++b)
        if (const auto r = table.of_points(a, b); r.id != none) refs.push_back(r);
    for (const PlaneId p : bench.ids)
      for (const PlaneId q : bench.ids)
        if (const auto r = table.of_planes(p, q); r.id != none) refs.push_back(r);
  }
};

// Law 1: exchanging the points, or the planes, turns the line over.
RC_GTEST_PROP(SightlineLaws, Law1Turning, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  for (PointId a = 0; a < 6; ++a)
    for (PointId b = 0; b < 6; ++b) {
      const auto r = l.table.of_points(a, b), s = l.table.of_points(b, a);
      RC_ASSERT(r.id == s.id);
      if (r.id != none) RC_ASSERT(r == -s);
    }
  for (const PlaneId p : l.bench.ids)
    for (const PlaneId q : l.bench.ids) {
      const auto r = l.table.of_planes(p, q), s = l.table.of_planes(q, p);
      RC_ASSERT(r.id == s.id);
      if (r.id != none) RC_ASSERT(r == -s);
    }
}

// Law 2: ids are equal just if the normals are parallel; multiples of a normal are found again, with the sign.
RC_GTEST_PROP(SightlineLaws, Law2Identity, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  for (SightlineId a = 0; a < l.table.size(); ++a) {
    const auto n = l.table.normal(a);
    for (SightlineId b = 0; b < a; ++b) RC_ASSERT(!is_zero(cross_product(n, l.table.normal(b))));
    for (const int m : {1, 3, -7, 1 << 20, -1000003}) {
      const SightlineRef again = l.table.of_normal({n[0] * m, n[1] * m, n[2] * m});
      RC_ASSERT(again.id == a && again.sign == (m > 0 ? 1 : -1));
    }
  }
  RC_ASSERT(l.table.of_normal({0, 0, 0}).id == none);
}

// Laws 3, 4: order changes sign with every exchange and with the sign of every ref; zero by identity for equal ids.
RC_GTEST_PROP(SightlineLaws, Law3And4Order, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  RC_PRE(l.refs.size() > 2);
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const auto any = [&] { return l.refs[random() % l.refs.size()]; };
    const SightlineRef a = any(), b = any(), c = any();
    const Sign s = l.table.order(a, b, c);
    RC_ASSERT(s == l.table.order(b, c, a));
    RC_ASSERT(s == -l.table.order(b, a, c));
    RC_ASSERT(s == -l.table.order(-a, b, c));
    RC_ASSERT(s == l.table.order(-a, b, -c));
    const Tally before = tally();
    RC_ASSERT(l.table.order(a, a, b) == 0 && l.table.order(a, -a, b) == 0);
    RC_ASSERT((tally() - before).identity == 2u);
  }
}

// Law 5: side(of_points(a, b), c) is alternating in a, b, c, and zero on a and b.
RC_GTEST_PROP(SightlineLaws, Law5Side, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  for (PointId a = 0; a < 6; ++a)
    for (PointId b = 0; b < 6; ++b) {
      const auto r = l.table.of_points(a, b);
      if (r.id == none) continue;
      RC_ASSERT(l.table.side(r, a) == 0 && l.table.side(r, b) == 0);
      for (PointId c = 0; c < 6; ++c) {
        const auto t = l.table.of_points(b, c);
        RC_ASSERT(l.table.side(r, c) == -l.table.side(-r, c));
        if (t.id != none) RC_ASSERT(l.table.side(r, c) == l.table.side(t, a));
      }
    }
}

// Law 6: where two planes share two points, of_planes is the line of_points of them.
RC_GTEST_PROP(SightlineLaws, Law6PlanesThroughAnEdge, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  for (PointId i = 2; i + 1 < l.bench.points.size(); ++i) {
    const auto p = l.bench.planes.add_points(0, 1, i), q = l.bench.planes.add_points(0, 1, i + 1);
    if (p.id == none || q.id == none) continue;
    const auto r = l.table.of_planes(p.id, q.id);
    if (r.id != none) RC_ASSERT(r.id == l.table.of_points(0, 1).id);
  }
}

// Law 7: a plane that contains the eye is itself every line of it.
RC_GTEST_PROP(SightlineLaws, Law7PlanesThroughTheEye, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  for (const PlaneId p : l.bench.ids) {
    if (l.table.eye_side(p) != 0) continue;
    for (const PlaneId q : l.bench.ids) {
      const auto r = l.table.of_planes(p, q);
      if (r.id != none) RC_ASSERT(r.id == l.table.of_plane(p).id);
    }
  }
}

// Law 8: after a reset all answers are as in a new table.
RC_GTEST_PROP(SightlineLaws, Law8Reset, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  const GridPoint eye = l.bench.grid.point(l.bench.scene.points[0] * 0.5 + l.bench.scene.points[1] * 0.25);
  SightlineTable fresh(l.bench.planes);
  fresh.reset(l.bench.planes, eye);
  l.table.reset(l.bench.planes, eye);
  RC_ASSERT(l.table.size() == 0u);
  for (const PlaneId p : l.bench.ids) RC_ASSERT(l.table.eye_side(p) == fresh.eye_side(p));
  for (PointId a = 0; a < 8; ++a)
    for (PointId b = 0; b < a; ++b) RC_ASSERT(l.table.of_points(a, b) == fresh.of_points(a, b));
}

// Law 9: approximations are within 2^-53 of the normal over 2^bits, the largest in [1/2, 1].
RC_GTEST_PROP(SightlineLaws, Law9Approximations, (std::uint64_t seed)) {
  Lit l(seed, some_bits(seed));
  for (SightlineId a = 0; a < l.table.size(); ++a) {
    const mpq_class scale(Integer(1) << l.table.bits(a)), tolerance(0x1p-53);
    double largest = 0;
    for (int k = 0; k < 3; ++k) {
      const double x = l.table.approx(a)[k];
      RC_ASSERT(abs(mpq_class(x) - mpq_class(l.table.normal(a)[static_cast<std::size_t>(k)]) / scale) <= tolerance);
      largest = std::max(largest, std::abs(x));
    }
    RC_ASSERT(largest >= 0.5 && largest <= 1);
  }
}

// Lines that all but coincide: neighbours in the last bit are told apart, multiples are not.
TEST(Sightlines, NearlyEqualLinesKeepTheirIds) {
  Bench b(1, 20, 0);
  SightlineTable table(b.planes);
  Random random(9);
  for (long i = 0; i < cases(3000); ++i) {
    const Integer x = Integer(random()) << 40, y = Integer(random()) << 40, z = Integer(random()) << 40;
    const auto a = table.of_normal({x, y, z}), c = table.of_normal({x, y + 1, z});
    const auto again = table.of_normal({-x * 5, -y * 5, -z * 5});
    ASSERT_NE(a.id, c.id);
    ASSERT_EQ(again, -a);
    // Simple fractions sit on the borders of any grid of directions.
    const int p = below(random, 9) - 4, q = below(random, 9) - 4, r = 1 + below(random, 4);
    const auto s = table.of_normal({p, q, r});
    const Integer m = 1 + Integer(random());
    ASSERT_EQ(table.of_normal({p * m, q * m, r * m}), s);
  }
}

}  // namespace
}  // namespace sightline::test
