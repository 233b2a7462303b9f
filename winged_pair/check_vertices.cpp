// Third stage: vertices and edges lie where their planes say.
#include "winged_pair/check_stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace sightline::check_detail {
namespace {

/// Is the vertex's approximation as near as it claims? Exactly: |c/w * 2^-unit_bits - approx| <= error, and the least
/// positive double more, since a nearer approximation may not exist.
bool approximation_right(const ExactVertex& exact, const ImplicitVertex& place, int unit_bits) {
  if (!std::isfinite(place.error) || place.error < 0) return false;
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(place.approx[k])) return false;
    mpq_class x(exact.c[static_cast<std::size_t>(k)], exact.w);
    x.canonicalize();
    mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(unit_bits));
    if (abs(x - mpq_class(place.approx[k])) >
        mpq_class(place.error) + mpq_class(std::numeric_limits<double>::denorm_min())) {
      return false;
    }
  }
  return true;
}

void check_place(const Complex& c, VertexId v, int unit_bits, Faults& faults) {
  const ImplicitVertex& place = c.vertices[v].place;
  const ExactVertex exact = exact_vertex(c.planes, place.plane);
  if (exact.w == 0) {
    faults.add("vertex ", v, ": its three planes do not meet in one point");
    return;
  }
  if (!approximation_right(exact, place, unit_bits))
    faults.add("vertex ", v, ": approximation off by more than its error");
  for (std::size_t k = 0; k < 3; ++k) {
    if (exact.c[k] < c.box[0][k] * exact.w || exact.c[k] > c.box[1][k] * exact.w) {
      faults.add("vertex ", v, ": outside the box");
      break;
    }
  }
}

/// No two vertices are the same point. Equal points have approximations within twice the largest error; bins of eight
/// times that or more hold such a pair in the same bin or in two that touch.
void check_distinct(const Complex& c, Faults& faults) {
  double error = std::ldexp(1.0, -47);
  for (const Vertex& v : c.vertices) error = std::max(error, v.place.error);
  const double bin = 8 * error;
  using Key = std::array<std::int64_t, 3>;
  const auto hash = [](const Key& key) {
    std::uint64_t h = 0;
    for (const std::int64_t x : key) h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ull, h ^= h >> 29;
    return static_cast<std::size_t>(h);
  };
  std::unordered_map<Key, std::vector<VertexId>, decltype(hash)> bins(2 * c.vertices.size(), hash);
  for (VertexId v = 0; v < c.vertices.size() && !faults.full(); ++v) {
    const glm::dvec3& x = c.vertices[v].place.approx;
    Key low, high, key;
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      low[i] = static_cast<std::int64_t>(std::floor((x[k] - 3 * error) / bin));
      high[i] = static_cast<std::int64_t>(std::floor((x[k] + 3 * error) / bin));
    }
    for (key[0] = low[0]; key[0] <= high[0]; ++key[0]) {
      for (key[1] = low[1]; key[1] <= high[1]; ++key[1]) {
        for (key[2] = low[2]; key[2] <= high[2]; ++key[2]) {
          const auto found = bins.find(key);
          if (found == bins.end()) continue;
          for (const VertexId w : found->second) {
            if (same_vertex(c.planes, c.vertices[v].place, c.vertices[w].place)) {
              faults.add("vertices ", w, " and ", v, ": the same point");
            }
          }
        }
      }
    }
    for (std::size_t i = 0; i < 3; ++i) key[i] = static_cast<std::int64_t>(std::floor(x[static_cast<int>(i)] / bin));
    bins[key].push_back(v);
  }
}

/// An axis along which the line of two planes rises or falls, and the sign with which n[0] x n[1] does; sign 0 if the
/// planes are parallel.
std::pair<int, Sign> rise(const PlaneTable& planes, PlaneId p, PlaneId q) {
  const ApproxPlane &a = planes.approx(p), &b = planes.approx(q);
  int axis = 0;
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double x = a.n[i] * b.n[j] - a.n[j] * b.n[i];
    if (std::abs(x) > std::abs(largest)) largest = x, axis = k;
  }
  // Components are at most 1 and off by 2^-53: two products, each off by 3 * 2^-53 and rounded, make less than 2^-49.
  if (std::abs(largest) > 0x1p-49) return {axis, largest > 0 ? 1 : -1};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Integer x = planes.integer(p, i) * planes.integer(q, j) - planes.integer(p, j) * planes.integer(q, i);
    if (x != 0) return {k, sgn(x)};
  }
  return {0, 0};
}

Sign compare_vertices(const PlaneTable& planes, const ImplicitVertex& a, const ImplicitVertex& b, int axis) {
  const double gap = b.approx[axis] - a.approx[axis];
  // The difference of unit coordinates is rounded by at most 2^-53.
  if (std::abs(gap) > a.error + b.error + 0x1p-52) return gap > 0 ? -1 : 1;
  return compare(exact_vertex(planes, a.plane), exact_vertex(planes, b.plane), axis);
}

void check_edge_place(const Complex& c, const Scene& scene, EdgeId e, Faults& faults) {
  const Edge& edge = c.edges[e];
  const auto [axis, sign] = rise(c.planes, edge.plane[0], edge.plane[1]);
  if (sign == 0) {
    faults.add("edge ", e, ": planes ", edge.plane[0], " and ", edge.plane[1], " do not meet in a line");
    return;
  }
  if (compare_vertices(c.planes, c.vertices[edge.vertex[0]].place, c.vertices[edge.vertex[1]].place, axis) != -sign) {
    faults.add("edge ", e, ": does not run along n[0] x n[1] of its planes");
  }
  for (const PlaneId p : edge.plane) {
    for (const VertexId v : edge.vertex) {
      if (vertex_side(c.planes, c.vertices[v].place, p) != 0) {
        faults.add("edge ", e, ": vertex ", v, " does not lie on its plane ", p);
      }
    }
    for (const PointId point : {edge.a, edge.b}) {
      if (point != none && point_side(c.planes, point, p) != 0) {
        faults.add("edge ", e, ": scene point ", point, " does not lie on its line");
      }
    }
  }
  if (edge.a != none && compare(scene.points(), edge.a, edge.b, axis) != -sign) {
    faults.add("edge ", e, ": scene points ", edge.a, " and ", edge.b, " do not run along it");
  }
}

}  // namespace

void check_vertices(const Complex& c, const Scene& scene, Faults& faults) {
  const int unit_bits = scene.grid().unit_bits();
  for (VertexId v = 0; v < c.vertices.size() && !faults.full(); ++v) check_place(c, v, unit_bits, faults);
  if (!faults.empty()) return;
  check_distinct(c, faults);
  for (EdgeId e = 0; e < c.edges.size() && !faults.full(); ++e) check_edge_place(c, scene, e, faults);
}

}  // namespace sightline::check_detail
