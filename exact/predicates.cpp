#include "exact/predicates.hpp"

#include "exact/plane_row.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {
namespace {

constexpr double u = 0x1p-53;  // unit roundoff

// Data: each n within u, the point within u (|p| <= 1), d within u max(1, |d|): 7 u. Rounding: products 3 u, sums
// (2 + 3 + 5) u: 20 u in all for |d| <= 2. A plane with |d| > 3 has its offset decide: |n.p| <= 3.
Sign filter_point_side(const ApproxPlane& q, const glm::dvec3& p) {
  const double value = q.n[0] * p.x + q.n[1] * p.y + q.n[2] * p.z - q.d;
  constexpr double bound = 32 * u;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return uncertain;
}

// A plane across an axis compares one coordinate.
Sign exact_point_side(const PlaneRow& q, const PointTable& points, PointId p) {
  return decide(value_bits(q, points), [&](auto width) -> Sign {
    constexpr int W = width();
    if (q.axis >= 0) {
      const std::uint64_t* const c = points.words(p) + static_cast<std::uint32_t>(q.axis) * points.stride();
      return sign_of<W>(Wide<W>(load<W>(c, points.stride()) - q.offset<W>()));
    }
    return sign_of<W>(value_at<W>(q, points, p));
  });
}

/// Points through which the plane was first laid: in meshes, most of those that lie in a plane at all.
bool made_through(const PlaneSource& source, PointId p) {
  if (source.kind == PlaneSource::axis) return false;
  return p == source.a || p == source.b || (source.kind == PlaneSource::points && p == source.c);
}

}  // namespace

Sign point_side(const PlaneTable& planes, PointId p, PlaneId q) {
  const PointTable& points = planes.points();
  const Sign s = filter_point_side(planes.approx(q), points.approx(p));
  if (s != uncertain) {
    ++tally().filter;
    return s;
  }
  if (made_through(planes.source(q), p)) {
    ++tally().identity;
    return 0;
  }
  return exact_point_side(PlaneRow(planes, q), points, p);
}

Sign planes_orientation(const PlaneTable& planes, PlaneId a, PlaneId b, PlaneId c) {
  if (a == b || b == c || c == a) {
    ++tally().identity;
    return 0;
  }
  const double* const x = planes.approx(a).n;
  const double* const y = planes.approx(b).n;
  const double* const z = planes.approx(c).n;
  const double det =
      (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] + (x[0] * y[1] - x[1] * y[0]) * z[2];
  // Entries at most 1, each within u: the data's part is 6 terms of 3 u; minors are within 4 u, their products with
  // the third within 6 u, and the two sums add 4 u + 6 u: 18 + 18 + 10 = 46 u.
  constexpr double bound = 64 * u;
  if (std::abs(det) > bound) {
    ++tally().filter;
    return det > 0 ? 1 : -1;
  }
  const PlaneRow ra(planes, a), rb(planes, b), rc(planes, c);
  return exact_normals_orientation(ra, rb, rc);
}

bool parallel(const PlaneTable& planes, PlaneId a, PlaneId b) {
  if (a == b) {
    ++tally().identity;
    return true;
  }
  const double* const x = planes.approx(a).n;
  const double* const y = planes.approx(b).n;
  // Data: two terms of 2 u; rounding 4 u: 8 u a component.
  constexpr double bound = 16 * u;
  if (std::abs(x[1] * y[2] - x[2] * y[1]) > bound || std::abs(x[2] * y[0] - x[0] * y[2]) > bound ||
      std::abs(x[0] * y[1] - x[1] * y[0]) > bound) {
    ++tally().filter;
    return false;
  }
  const PlaneRow ra(planes, a), rb(planes, b);
  return decide(ra.normal_bits + rb.normal_bits + 1, [&](auto width) -> Sign {
           constexpr int W = width();
           return narrowed<W>(ra.normal_bits, rb.normal_bits, [&]<int N, int M>(Words<N>, Words<M>) -> Sign {
             const Wide3<W> n = cross<W, N>(ra.normal<N>(), rb.normal<N>());
             return sign_of<W>(n[0]) != 0 || sign_of<W>(n[1]) != 0 || sign_of<W>(n[2]) != 0;
           });
         }) == 0;
}

Sign orientation(const PointTable& points, PointId a, PointId b, PointId c, int axis) {
  if (a == b || b == c || c == a) {
    ++tally().identity;
    return 0;
  }
  const auto k1 = static_cast<std::uint32_t>((axis + 1) % 3), k2 = static_cast<std::uint32_t>((axis + 2) % 3);
  const std::uint32_t stride = points.stride();
  const std::uint64_t *p = points.words(a), *q = points.words(b), *r = points.words(c);
  // Differences B+1, their products 2B+2, the difference of two 2B+3.
  return decide(2 * points.bits() + 3, [&](auto width) -> Sign {
    constexpr int W = width();
    return narrowed<W>(points.bits() + 1, points.bits() + 1, [&]<int N, int M>(Words<N>, Words<M>) -> Sign {
      const auto difference = [&](const std::uint64_t* to, std::uint32_t k) {
        return Wide<N>(load<N>(to + k * stride, stride) - load<N>(p + k * stride, stride));
      };
      return sign_of<W>(minor2<W, N, N>(difference(q, k1), difference(q, k2), difference(r, k1), difference(r, k2)));
    });
  });
}

Sign compare(const PointTable& points, PointId a, PointId b, int axis) {
  if (a == b) {
    ++tally().identity;
    return 0;
  }
  const std::uint32_t stride = points.stride();
  const std::uint64_t* const p = points.words(a) + static_cast<std::uint32_t>(axis) * stride;
  const std::uint64_t* const q = points.words(b) + static_cast<std::uint32_t>(axis) * stride;
  ++tally().exact[0];  // word by word: nothing is computed
  const auto high = static_cast<std::int64_t>(p[stride - 1]), other = static_cast<std::int64_t>(q[stride - 1]);
  if (high != other) return high < other ? -1 : 1;
  for (std::uint32_t i = stride - 1; i-- > 0;)
    if (p[i] != q[i]) return p[i] < q[i] ? -1 : 1;
  return 0;
}

}  // namespace sightline
