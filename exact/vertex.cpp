#include "exact/plane_row.hpp"
#include "exact/predicates.hpp"
#include "exact/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sightline {

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

// The vertex of three planes from exact determinants: x_k = X_k / D, each of both rounded once, so x_k within
// ((1 + u)^2 / (1 - u) - 1) |x_k| < 4u |x_k|. X_k has six terms of two normals and an offset: bits as given.
bool fixed_vertex(const std::array<PlaneRow, 3>& row, int unit_bits, ImplicitVertex& v) {
  int bits = 3, longer = 0, longest = 0, longest_offset = 0;
  for (const PlaneRow& r : row) {
    bits += r.normal_bits;
    longer = std::max(longer, r.offset_bits - r.normal_bits);
    longest = std::max(longest, r.normal_bits);
    longest_offset = std::max(longest_offset, r.offset_bits);
  }
  return at_width(bits + longer, [&](auto width) -> bool {
    constexpr int W = width();
    if constexpr (W == 0) {
      return false;
    } else {
      return narrowed_to_thirds<W>(longest, [&]<int N>(Words<N>) -> bool {
        constexpr int M = product_words<W, N, N>;
        const Wide3<N> a = row[0].template normal<N>(), b = row[1].template normal<N>(),
                       c = row[2].template normal<N>();
        const Wide3<M> bc = cross<M, N>(b, c), ca = cross<M, N>(c, a), ab = cross<M, N>(a, b);
        const Wide<W> det = dot<W, M, N>(bc, a);
        if (sign(det) == 0) throw std::invalid_argument("the planes do not meet in one point");
        const double d = words_to_double(det.word, W, 0);  // below 2^1023
        const auto coordinates = [&]<int Q>(Words<Q>) {
          const Wide<Q> da = row[0].template offset<Q>(), db = row[1].template offset<Q>(),
                        dc = row[2].template offset<Q>();
          for (std::size_t k = 0; k < 3; ++k) {
            const Wide<W> x = times<W, M, Q>(bc[k], da) + times<W, M, Q>(ca[k], db) + times<W, M, Q>(ab[k], dc);
            v.approx[static_cast<int>(k)] = std::ldexp(words_to_double(x.word, W, 0) / d, -unit_bits);
          }
        };
        constexpr int half = (W + 1) / 2;
        if (longest_offset < 64 * half) {
          coordinates(Words<half>{});
        } else {
          coordinates(Words<W>{});
        }
        return true;
      });
    }
  });
}

struct Oversized {
  Integer determinant;
  Wide3<0> numerator;
};
Oversized oversized_vertex(const std::array<PlaneRow, 3>& row) {
  const Wide3<0> a = row[0].normal<0>(), b = row[1].normal<0>(), c = row[2].normal<0>();
  const Wide3<0> bc = cross<0, 0>(b, c), ca = cross<0, 0>(c, a), ab = cross<0, 0>(a, b);
  Oversized r{dot<0, 0, 0>(a, bc), {}};
  if (r.determinant == 0) throw std::invalid_argument("the planes do not meet in one point");
  for (std::size_t k = 0; k < 3; ++k)
    r.numerator[k] = bc[k] * row[0].offset<0>() + ca[k] * row[1].offset<0>() + ab[k] * row[2].offset<0>();
  return r;
}

// Three planes along three axes: the coordinates are the offsets.
bool axis_vertex(const PlaneTable& planes, ImplicitVertex& v) {
  bool seen[3] = {false, false, false};
  for (const PlaneId p : v.plane) {
    const int k = planes.axis(p);
    if (k < 0 || seen[k]) return false;
    seen[k] = true;
    v.approx[k] = 2 * planes.approx(p).d;  // n = 1 is scaled to 1/2; rounded once
  }
  return true;
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
  const Sign numerator = exact_rows_orientation(
      {PlaneRow(planes, v.plane[0]), PlaneRow(planes, v.plane[1]), PlaneRow(planes, v.plane[2]), PlaneRow(planes, q)});
  return numerator == 0 ? 0 : -numerator * planes_orientation(planes, v.plane[0], v.plane[1], v.plane[2]);
}

ImplicitVertex make_vertex(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c) {
  ImplicitVertex v{{a, b, c}, 0, {}};
  const int unit_bits = planes.points().grid().unit_bits();
  if (!axis_vertex(planes, v)) {
    const std::array<PlaneRow, 3> row{PlaneRow(planes, a), PlaneRow(planes, b), PlaneRow(planes, c)};
    if (!fixed_vertex(row, unit_bits, v)) {
      const Oversized exact = oversized_vertex(row);
      const Integer scaled = shifted(exact.determinant, unit_bits);
      for (std::size_t k = 0; k < 3; ++k) v.approx[static_cast<int>(k)] = nearest_double(exact.numerator[k], scaled);
    }
  }
  // 4u |x|; and what the ends of the range of doubles take away.
  for (int k = 0; k < 3; ++k) v.error = std::max(v.error, 4 * u * std::abs(v.approx[k]) + 0x1p-1070);
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
