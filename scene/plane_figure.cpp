#include "scene/plane_figure.hpp"

#include <cmath>
#include <utility>

namespace sightline {

std::array<Integer, 2> PlaneView::grid(PointId p) const {
  auto c = points_.point(p);
  return {std::move(c[static_cast<std::size_t>(x_)]), std::move(c[static_cast<std::size_t>(y_)])};
}

/// Points of the scene's box have unit coordinates up to 1/2, those around it (the corners of a decomposition's frame)
/// up to 1. get_d truncates, which is an error below 2^-53; ldexp adds none (a result that is not normal is within
/// 2^-1074).
double PlaneView::unit(const mpq_class& x) const {
  mpq_class scaled;
  mpq_div_2exp(scaled.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(points_.grid().unit_bits()));
  return scaled.get_d();
}

PlanePoint PlaneView::point(mpq_class x, mpq_class y) const {
  const double near_x = unit(x), near_y = unit(y);
  return {std::move(x), std::move(y), near_x, near_y};
}

PlanePoint PlaneView::point(const std::array<Integer, 2>& grid) const {
  return point(mpq_class(grid[0]), mpq_class(grid[1]));
}

PlaneLine PlaneView::line(const std::array<Integer, 2>& p, const std::array<Integer, 2>& q) const {
  PlaneLine l{p[1] - q[1], q[0] - p[0], 0, 0, 0, unit(p[0]), unit(p[1])};
  l.c = l.a * p[0] + l.b * p[1];
  l.near_a = unit(l.a) / 2;
  l.near_b = unit(l.b) / 2;
  return l;
}

PlanePoint PlaneView::meet(const PlaneLine& l, const PlaneLine& m) const {
  const Integer determinant = l.a * m.b - m.a * l.b;
  mpq_class x(Integer(l.c * m.b - m.c * l.b), determinant);
  mpq_class y(Integer(l.a * m.c - m.a * l.c), determinant);
  x.canonicalize();
  y.canonicalize();
  return point(std::move(x), std::move(y));
}

/// The filter's error. With |x|, |y| <= 1 for both points: near_a and near_b are differences up to 2, halved, so up to
/// 1, and within 2^-53 of the exact ones; x - near_x is up to 2 and within 2 * 2^-52 + 2^-53 (rounding), below 2^-50;
/// each product is up to 2 and within 1 * 2^-50 + 2 * 2^-53 + 2^-53 + 2^-53 (rounding), below 2^-49, the sum up to 4
/// and within 2 * 2^-49 + 2^-51 < 2^-47.
Sign side(const PlaneLine& line, const PlanePoint& p) {
  constexpr double bound = 0x1p-47;
  const double value = line.near_a * (p.near_x - line.near_x) + line.near_b * (p.near_y - line.near_y);
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return sgn(mpq_class(line.a * p.x + line.b * p.y - line.c));
}

}  // namespace sightline
