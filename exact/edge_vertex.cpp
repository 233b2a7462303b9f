#include "exact/edge_vertex.hpp"

#include "exact/plane_row.hpp"
#include "exact/rounding.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {
// With the cut's values A at a and B at b, the place is v = (A b - B a) / (A - B).
// So q's value there is (A q(b) - B q(a)) / (A - B), and A - B has the sign of A.
Sign edge_vertex_side(const PlaneTable& planes, PlaneId cut, PointId a, PointId b, PlaneId q) {
  const PlaneRow c(planes, cut), r(planes, q);
  const PointTable& points = planes.points();
  const int first = value_bits(c, points), second = value_bits(r, points);
  return decide(first + second + 1, [&](auto width) -> Sign {
    constexpr int W = width();
    return narrowed<W>(first, second, [&]<int N, int M>(Words<N>, Words<M>) -> Sign {
      const Wide<N> at_a = value_at<N>(c, points, a), at_b = value_at<N>(c, points, b);
      const Wide<W> value =
          Wide<W>(times<W, N, M>(at_a, value_at<M>(r, points, b)) - times<W, N, M>(at_b, value_at<M>(r, points, a)));
      return sign_of<W>(value) * sign_of<N>(at_a);
    });
  });
}

// Numerator and denominator are exact, and each is rounded once: the error is that of make_vertex.
ImplicitVertex make_edge_vertex(const PlaneTable& planes, PlaneId face, PlaneId wall, PlaneId cut, PointId a,
                                PointId b) {
  const PlaneRow c(planes, cut);
  const PointTable& points = planes.points();
  const int first = value_bits(c, points);
  return at_width(first + points.bits() + 1, [&](auto width) -> ImplicitVertex {
    constexpr int W = width();
    if constexpr (W == 0) {
      return make_vertex(planes, face, wall, cut);
    } else {
      ImplicitVertex v{{face, wall, cut}, 0, {}};
      narrowed<W>(first, points.bits(), [&]<int N, int M>(Words<N>, Words<M>) {
        const Wide<N> at_a = value_at<N>(c, points, a), at_b = value_at<N>(c, points, b);
        const Wide<W> between = Wide<W>(resized<W, N>(at_a) - resized<W, N>(at_b));
        const double denominator = words_to_double(between.word, W, 0);
        const Wide3<M> from = load3<M>(points.words(a), points.stride()),
                       to = load3<M>(points.words(b), points.stride());
        for (std::size_t k = 0; k < 3; ++k) {
          const Wide<W> x = Wide<W>(times<W, N, M>(at_a, to[k]) - times<W, N, M>(at_b, from[k]));
          const double unit = std::ldexp(words_to_double(x.word, W, 0) / denominator, -points.grid().unit_bits());
          v.approx[static_cast<int>(k)] = unit;
          v.error = std::max(v.error, 0x1p-51 * std::abs(unit) + 0x1p-1070);
        }
      });
      return v;
    }
  });
}

}  // namespace sightline
