// One direction after the other is put to a tetrahedron: the faces that it sees from outside go, and the edges around
// them are joined to it.
#include "sample/bitfield_hull.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace sightline {
namespace {

// Coordinates are below 2^26 + 1, their differences below 2^28, so that determinants are below 6 * 2^84.
using Product = __int128;

ViewDirection minus(const ViewDirection& a, const ViewDirection& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Product dot(const ViewDirection& a, const ViewDirection& b) {
  return static_cast<Product>(a[0]) * b[0] + static_cast<Product>(a[1]) * b[1] + static_cast<Product>(a[2]) * b[2];
}

int determinant(const ViewDirection& a, const ViewDirection& b, const ViewDirection& c) {
  const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
    return static_cast<Product>(p) * s - static_cast<Product>(q) * r;
  };
  const Product d = minor(b[1], b[2], c[1], c[2]) * a[0] + minor(b[2], b[0], c[2], c[0]) * a[1] +
                    minor(b[0], b[1], c[0], c[1]) * a[2];
  return d > 0 ? 1 : d < 0 ? -1 : 0;
}

/// +1: d is on the outer side of the counter-clockwise triangle a b c.
int outside(const ViewDirection& a, const ViewDirection& b, const ViewDirection& c, const ViewDirection& d) {
  return determinant(minus(b, a), minus(c, a), minus(d, a));
}

using Triangle = std::array<std::uint32_t, 3>;

/// Four directions that are in no plane, the hull's first faces; none if there are none.
std::vector<Triangle> tetrahedron(std::span<const ViewDirection> d) {
  std::uint32_t b = 0;
  while (b < d.size() && d[b] == d[0]) ++b;
  std::uint32_t c = b;
  const auto collinear = [&](std::uint32_t k) {
    const ViewDirection p = minus(d[b], d[0]), q = minus(d[k], d[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (static_cast<Product>(p[i]) * q[j] != static_cast<Product>(p[j]) * q[i]) return false;
    }
    return true;
  };
  while (c < d.size() && collinear(c)) ++c;
  std::uint32_t e = c;
  while (e < d.size() && outside(d[0], d[b], d[c], d[e]) == 0) ++e;
  if (e >= d.size()) return {};
  if (outside(d[0], d[b], d[c], d[e]) > 0) std::swap(b, c);
  return {{0, b, c}, {0, c, e}, {c, b, e}, {b, 0, e}};
}

}  // namespace

ViewDirection view_direction(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0 && largest <= std::numeric_limits<double>::max())) return {0, 0, 0};
  int exponent = 0;
  std::frexp(largest, &exponent);  // so that no square over- or underflows
  const glm::dvec3 unit =
      glm::normalize(glm::dvec3(std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)));
  return {std::llround(unit.x * 0x1p26), std::llround(unit.y * 0x1p26), std::llround(unit.z * 0x1p26)};
}

ViewHull::ViewHull(std::vector<ViewDirection> directions) : directions_(std::move(directions)) {
  const auto& d = directions_;
  std::vector<Triangle> triangles = d.empty() ? std::vector<Triangle>{} : tetrahedron(d);
  if (triangles.empty()) throw std::invalid_argument("the viewpoints do not surround the centre of the scene");
  std::vector<Triangle> kept;
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> seen_edges;
  for (std::uint32_t k = 0; k < d.size(); ++k) {
    // Faces in whose plane the direction lies stay: a new face has then never all its corners on a line, since the edge
    // that it joins belongs to a face that is seen from outside.
    kept.clear();
    seen_edges.clear();
    for (const Triangle& t : triangles) {
      if (outside(d[t[0]], d[t[1]], d[t[2]], d[k]) <= 0) {
        kept.push_back(t);
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) seen_edges[{t[i], t[(i + 1) % 3]}] = true;
    }
    if (seen_edges.empty()) continue;
    for (const auto& [edge, seen] : seen_edges) {
      if (!seen_edges.contains({edge.second, edge.first})) kept.push_back({edge.first, edge.second, k});
    }
    triangles.swap(kept);
  }
  for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::ranges::sort(triangles);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of;
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    if (determinant(d[t[0]], d[t[1]], d[t[2]]) <= 0) {
      throw std::invalid_argument("the viewpoints do not surround the centre of the scene");
    }
    for (std::size_t i = 0; i < 3; ++i) face_of[{t[i], t[(i + 1) % 3]}] = f;
  }
  for (const Triangle& t : triangles) {
    faces_.push_back({t, {face_of[{t[1], t[0]}], face_of[{t[2], t[1]}], face_of[{t[0], t[2]}]}});
  }
}

std::uint32_t ViewHull::face_holding(const ViewDirection& v) const {
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const auto& c = faces_[f].corner;
    const ViewDirection &p = directions_[c[0]], &q = directions_[c[1]], &r = directions_[c[2]];
    if (determinant(p, q, v) >= 0 && determinant(q, r, v) >= 0 && determinant(r, p, v) >= 0) return f;
  }
  return 0;  // not reached: the cones of the faces cover space
}

std::array<std::uint32_t, 6> ViewHull::around(std::uint32_t face) const {
  const Face& f = faces_[face];
  std::array<std::uint32_t, 6> out{f.corner[0], f.corner[1], f.corner[2]};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& corners = faces_[f.neighbour[k]].corner;
    const auto opposite = [&](std::uint32_t c) { return c != f.corner[k] && c != f.corner[(k + 1) % 3]; };
    out[3 + k] = *std::ranges::find_if(corners, opposite);
  }
  return out;
}

std::vector<std::uint32_t> ViewHull::nearest_corners() const {
  std::vector<std::uint32_t> corners;
  for (const Face& f : faces_) corners.insert(corners.end(), f.corner.begin(), f.corner.end());
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<std::uint32_t> nearest(directions_.size());
  for (std::uint32_t k = 0; k < directions_.size(); ++k) {
    if (std::ranges::binary_search(corners, k)) {
      nearest[k] = k;
      continue;
    }
    nearest[k] =
        *std::ranges::max_element(corners, {}, [&](std::uint32_t c) { return dot(directions_[c], directions_[k]); });
  }
  return nearest;
}

}  // namespace sightline
