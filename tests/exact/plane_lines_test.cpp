// The laws of exact/plane_lines.hpp against GMP: lines of planes and of sightlines in degenerate scenes, at all lengths.
#include "exact/plane_lines.hpp"

#include "support.hpp"
#include "tables.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

using Rational = mpq_class;

/// Is the double as near as a double can be?
bool nearest(double d, const Rational& x) {
  if (!std::isfinite(d)) return false;
  const Rational off = abs(Rational(x - Rational(d)));
  const auto nearer = [&](double other) {
    return std::isfinite(other) && abs(Rational(x - Rational(other))) < off;
  };
  return !nearer(std::nextafter(d, HUGE_VAL)) && !nearer(std::nextafter(d, -HUGE_VAL));
}

/// Do three planes have a line in common, two of them not parallel?
bool one_line(const Oracle::Plane& p, const Oracle::Plane& a, const Oracle::Plane& b) {
  const auto column = [](const Oracle::Plane& q, std::size_t k) { return k < 3 ? q.n[k] : q.d; };
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    Vector rows[3];
    for (std::size_t k = 0, c = 0; k < 4; ++k) {
      if (k == left_out) continue;
      rows[0][c] = column(p, k), rows[1][c] = column(a, k), rows[2][c] = column(b, k);
      ++c;
    }
    if (triple(rows[0], rows[1], rows[2]) != 0) return false;
  }
  return true;
}

mpz_class shifted_one(int bits) {
  mpz_class one = 1;
  one <<= static_cast<mp_bitcnt_t>(bits);
  return one;
}

class PlaneLinesByBits : public testing::TestWithParam<int> {};

/// The lines of one plane in a scene, each with the plane that it is cut by.
struct Cuts {
  std::vector<SightlineRef> line;
  std::vector<Oracle::Plane> plane;

  Cuts(const Bench& b, SightlineTable& table, PlaneLines& lines, std::size_t own, Random& random, Count& parallels) {
    const auto add = [&](const PlaneLines::Cut& cut, const Oracle::Plane& q) {
      const bool parallel = is_zero(cross_product(b.exact[own].n, q.n));
      EXPECT_EQ(cut.line.id == none, parallel);
      if (!parallel) {
        line.push_back(cut.line);
        plane.push_back(q);
        return;
      }
      const Vector& n = b.exact[own].n;  // d n / n.n lies in our plane
      const mpz_class square = product(n, n);
      parallels.check(cut.side, sgn(mpz_class(product(q.n, n) * b.exact[own].d - q.d * square)));
    };
    for (std::size_t k = 0; k < b.ids.size(); ++k) add(lines.of_plane(b.ids[k]), b.exact[k]);
    for (int i = 0; i < 8; ++i) {
      const PointId p = static_cast<PointId>(random() % b.points.size());
      const PointId q = static_cast<PointId>(random() % b.points.size());
      const SightlineRef sightline = table.of_points(p, q);
      if (sightline.id == none) continue;
      const Vector n = b.oracle.sightline(p, q);
      add(lines.of_sightline(table, sightline), {n, product(n, b.oracle.eye)});
    }
  }
};

TEST_P(PlaneLinesByBits, AgreeWithTheOracle) {
  Count orders, turns, equals, parallels, coordinates;
  const long wanted = cases_at(GetParam()) / 5;
  for (std::uint64_t seed = 1; orders.cases < wanted; ++seed) {
    const Bench b(seed + 1000003u * static_cast<unsigned>(GetParam()), GetParam(), 8);
    if (b.ids.empty()) continue;
    Random random(seed);
    SightlineTable table(b.planes);
    table.reset(b.planes, b.grid.point(b.scene.eye));
    const std::size_t own = random() % b.ids.size();
    const Oracle::Plane& p = b.exact[own];
    int axis = below(random, 3);
    while (p.n[static_cast<std::size_t>(axis)] == 0) axis = (axis + 1) % 3;
    const Sign slope = sgn(p.n[static_cast<std::size_t>(axis)]);
    PlaneLines lines(b.planes, b.ids[own], axis);
    const Cuts cuts(b, table, lines, own, random, parallels);
    const std::size_t n = cuts.line.size();
    for (int i = 0; n > 0 && i < 60; ++i) {
      const std::size_t x = random() % n, y = random() % n, z = random() % n;
      const bool one = one_line(p, cuts.plane[x], cuts.plane[y]);
      equals.check(cuts.line[x].id == cuts.line[y].id ? 0 : 1, one ? 0 : 1);
      const Sign turn = slope * sgn(triple(cuts.plane[x].n, cuts.plane[y].n, p.n));
      turns.check(lines.turn(cuts.line[x], cuts.line[y]), turn);
      if (turn == 0) continue;
      const Oracle::Vertex v = Oracle::meet(p, cuts.plane[x], cuts.plane[y]);
      const Sign order = turn * Oracle::side(cuts.plane[z], v);
      orders.check(lines.order(cuts.line[x], cuts.line[y], cuts.line[z]), order);
      const glm::dvec3 at = lines.corner(cuts.line[x].id, cuts.line[y].id);
      const bool in_box = std::abs(at.x) <= 0.5 && std::abs(at.y) <= 0.5 && std::abs(at.z) <= 0.5;
      if (in_box && turn > 0)
        orders.check(lines.side(at, cuts.line[x], cuts.line[y], cuts.line[z]), order);
      if (i % 8 != 0) continue;
      const std::array<double, 3> world = lines.world(cuts.line[x].id, cuts.line[y].id);
      for (int k = 0; k < 3; ++k) {
        const auto c = static_cast<std::size_t>(k);
        Rational exact(v.x[c], v.w);
        exact.canonicalize();
        if (b.oracle.exponent < 0) {
          mpq_div_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(-b.oracle.exponent));
        } else {
          mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(b.oracle.exponent));
        }
        if (abs(exact) < Rational(1e300) && abs(exact) > Rational(1e-300))
          coordinates.check(nearest(world[c], exact) ? 1 : 0, 1);
        // Unit coordinates: (world - origin step) / (step 2^unit_bits), from the grid's own numbers.
        Rational unit = exact;
        const Rational step(b.grid.step());
        unit = (unit / step - Rational(b.grid.origin()[c])) / Rational(shifted_one(b.grid.unit_bits()));
        if (!in_box || abs(unit) < Rational(1e-300)) continue;
        if (k != axis) {
          coordinates.check(nearest(at[k], unit) ? 1 : 0, 1);
        } else if (std::abs(b.planes.approx(b.ids[own]).n[k]) >= 0.5) {
          coordinates.check(abs(Rational(unit - Rational(at[k]))) <= Rational(0x1p-46) ? 1 : 0, 1);
        }
      }
    }
  }
  report_cases("order in a plane", GetParam(), orders);
  report_cases("turn in a plane", GetParam(), turns);
  report_cases("equal lines of a plane", GetParam(), equals);
  EXPECT_EQ(parallels.disagreements + coordinates.disagreements, 0);
  EXPECT_GT(parallels.cases, 0);
  EXPECT_GT(coordinates.cases, 0);
}

INSTANTIATE_TEST_SUITE_P(Bits, PlaneLinesByBits, testing::ValuesIn(bit_lengths));

}  // namespace
}  // namespace sightline::test
