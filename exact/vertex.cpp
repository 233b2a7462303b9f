#include "exact/plane_row.hpp"
#include "exact/predicates.hpp"
#include "exact/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sightline {

Sign exact_normals_orientation(const PlaneRow& a, const PlaneRow& b, const PlaneRow& c) {
  // Six terms, each below 2^(sum of bits).
  return decide(a.normal_bits + b.normal_bits + c.normal_bits + 3, [&](auto width) -> Sign {
    constexpr int W = width();
    return sign_of<W>(det3<W, W, W>(a.normal<W>(), b.normal<W>(), c.normal<W>()));
  });
}

namespace {

constexpr double u = 0x1p-53;  // unit roundoff

// |n.v - d| is known within: data, each n within u (|x| <= X) and each x within error, d within u max(1, |d|):
// 3 uX + 3 error + u(1 + |d|); rounding, products 3 uX, sums (2X + 3X + 3X + |d|) u.
Sign filter_vertex_side(const ApproxPlane& q, const ImplicitVertex& v) {
  const double value = q.n[0] * v.approx.x + q.n[1] * v.approx.y + q.n[2] * v.approx.z - q.d;
  const double reach = std::max({std::abs(v.approx.x), std::abs(v.approx.y), std::abs(v.approx.z)});
  const double bound = 3.25 * v.error + u * (16 * reach + 4 * std::abs(q.d) + 2);
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return uncertain;
}

// det of the rows (n_i, d_i), by Laplace along columns x, y against z, d. A term takes d from one row and n from three:
// at most sum of the normals' bits + max over rows of (offset's - normal's); 24 terms: 5 more.
Sign exact_det4(const std::array<PlaneRow, 4>& row) {
  int bits = 0, longer = -(1 << 30);
  for (const PlaneRow& r : row) {
    bits += r.normal_bits;
    longer = std::max(longer, r.offset_bits - r.normal_bits);
  }
  return decide(bits + std::max(longer, 0) + 5, [&](auto width) -> Sign {
    constexpr int W = width();
    std::array<Wide3<W>, 4> n;
    std::array<Wide<W>, 4> d;
    for (std::size_t i = 0; i < 4; ++i) {
      n[i] = row[i].template normal<W>();
      d[i] = row[i].template offset<W>();
    }
    const auto xy = [&](std::size_t i, std::size_t j) { return minor2<W, W, W>(n[i][0], n[i][1], n[j][0], n[j][1]); };
    const auto zd = [&](std::size_t i, std::size_t j) { return minor2<W, W, W>(n[i][2], d[i], n[j][2], d[j]); };
    const auto term = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      return times<W, W, W>(xy(i, j), zd(k, l));
    };
    const Wide<W> plus = term(0, 1, 2, 3) + term(0, 3, 1, 2) + term(1, 2, 0, 3) + term(2, 3, 0, 1);
    const Wide<W> minus = term(0, 2, 1, 3) + term(1, 3, 0, 2);
    return sign_of<W>(Wide<W>(plus - minus));
  });
}

}  // namespace

Sign vertex_side(const PlaneTable& planes, const ImplicitVertex& v, PlaneId q) {
  if (q == v.plane[0] || q == v.plane[1] || q == v.plane[2]) {
    ++tally().identity;
    return 0;
  }
  const Sign s = filter_vertex_side(planes.approx(q), v);
  if (s != uncertain) {
    ++tally().filter;
    return s;
  }
  // With the solution v of the first three rows taken from the last column, det4 = (d_q - n_q.v) det3.
  const Sign numerator = exact_det4(
      {PlaneRow(planes, v.plane[0]), PlaneRow(planes, v.plane[1]), PlaneRow(planes, v.plane[2]), PlaneRow(planes, q)});
  return numerator == 0 ? 0 : -numerator * planes_orientation(planes, v.plane[0], v.plane[1], v.plane[2]);
}

ImplicitVertex make_vertex(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c) {
  const PlaneRow ra(planes, a), rb(planes, b), rc(planes, c);
  const Wide3<0> na = ra.normal<0>(), nb = rb.normal<0>(), nc = rc.normal<0>();
  const Integer da = ra.offset<0>(), db = rb.offset<0>(), dc = rc.offset<0>();
  const Wide3<0> bc = cross<0, 0>(nb, nc), ca = cross<0, 0>(nc, na), ab = cross<0, 0>(na, nb);
  const Integer det = dot<0, 0, 0>(na, bc);
  if (det == 0) throw std::invalid_argument("the planes do not meet in one point");
  ImplicitVertex v{{a, b, c}, 0, {}};
  const Integer scaled = shifted(det, planes.points().grid().unit_bits());
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = nearest_double(Integer(bc[k] * da + ca[k] * db + ab[k] * dc), scaled);
    v.approx[static_cast<int>(k)] = x;
    v.error = std::max(v.error, u * std::abs(x));
  }
  return v;
}

bool same_vertex(const PlaneTable& planes, const ImplicitVertex& a, const ImplicitVertex& b) {
  const double bound = a.error + b.error;
  for (int k = 0; k < 3; ++k)
    if (std::abs(a.approx[k] - b.approx[k]) * (1 - 4 * u) > bound) {
      ++tally().filter;
      return false;
    }
  return vertex_side(planes, a, b.plane[0]) == 0 && vertex_side(planes, a, b.plane[1]) == 0 &&
         vertex_side(planes, a, b.plane[2]) == 0;
}

}  // namespace sightline
