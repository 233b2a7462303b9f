#include "verify/scene.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::verify {

Scene::Scene(const Soup& soup, const std::string& snap) : soup_(soup), snapped_(!snap.empty()) {
  if (snapped_) {
    unit_ = parse_decimal(snap);
    if (unit_ <= 0) throw std::invalid_argument("the snap '" + snap + "' is not positive");
  } else {
    for (const auto& p : soup.vertices) {
      for (const double x : p) grid_ = std::max(grid_, fraction_bits(x));
    }
  }
  points_.reserve(soup.vertices.size());
  near_ = soup.vertices;
  for (auto& p : near_) {
    unsigned bits = 0;
    Triple q = place(p, bits);
    if (snapped_) {
      const Integer one = 1;
      p = {nearest_double(q.x, one), nearest_double(q.y, one), nearest_double(q.z, one)};
    } else {
      q = shifted(q, grid_ - bits);
    }
    points_.push_back(std::move(q));
  }
  used_.assign(points_.size(), 0);
  for (const std::uint32_t v : soup.corners) used_[v] = 1;
  shapes_.resize(soup.polygon_count());
}

Triple Scene::place(const std::array<double, 3>& x, unsigned& bits) const {
  bits = 0;
  if (snapped_) return {nearest_multiple(x[0], unit_), nearest_multiple(x[1], unit_), nearest_multiple(x[2], unit_)};
  for (const double c : x) bits = std::max(bits, fraction_bits(c));
  return {scaled_integer(x[0], bits), scaled_integer(x[1], bits), scaled_integer(x[2], bits)};
}

const Shape& Scene::shape(std::uint32_t polygon) const {
  const std::scoped_lock lock(locks_[polygon % locks_.size()]);
  auto& slot = shapes_[polygon];
  if (!slot) slot = std::make_unique<Shape>(make_shape(polygon));
  return *slot;
}

namespace {

bool same(const Triple& a, const Triple& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// The area vector of a closed chain (twice its area).
Triple area_vector(std::span<const Corner> chain) {
  Triple sum;
  for (std::size_t i = 2; i < chain.size(); ++i) {
    sum = sum + cross(chain[i - 1].p - chain[0].p, chain[i].p - chain[0].p);
  }
  return sum;
}

/// Any non-zero normal of three corners; zero where all are collinear.
Triple any_normal(std::span<const Corner> chain) {
  std::size_t second = 1;
  while (second < chain.size() && same(chain[second].p, chain[0].p)) ++second;
  for (std::size_t i = second + 1; i < chain.size(); ++i) {
    Triple n = cross(chain[second].p - chain[0].p, chain[i].p - chain[0].p);
    if (!n.is_zero()) return n;
  }
  return {};
}

/// Leaves out corners that repeat the one before and corners in the middle of a straight line. What remains has no
/// collinear neighbours, but for the tips of spurs.
std::vector<Corner> without_straight_corners(std::vector<Corner> chain) {
  bool changed = true;
  while (changed && chain.size() >= 3) {
    changed = false;
    for (std::size_t i = 0; i < chain.size() && chain.size() >= 3;) {
      const Triple &a = chain[(i + chain.size() - 1) % chain.size()].p, &b = chain[i].p,
                   &c = chain[(i + 1) % chain.size()].p;
      const Triple u = b - a, v = c - b;
      if (u.is_zero() || (cross(u, v).is_zero() && dot(u, v) > 0)) {
        chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(i));
        changed = true;
      } else {
        ++i;
      }
    }
  }
  return chain;
}

/// All turns to the left about the normal, and round just once.
bool strictly_convex(std::span<const Corner> chain, const Triple& normal) {
  const std::size_t n = chain.size();
  if (n < 3) return false;
  std::vector<Triple> side(n);
  for (std::size_t i = 0; i < n; ++i) side[i] = chain[(i + 1) % n].p - chain[i].p;
  // Round once: the chain, seen along the normal, turns from going one way to going the other just twice. Which way
  // is told by a direction in the plane, made lexicographic by a second one.
  const Triple first = side[0], second = cross(normal, first);
  int changes = 0, before = 0, start = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (sign_dot(cross(side[i], side[(i + 1) % n]), normal) <= 0) return false;
    int way = sign_dot(side[i], second);
    if (way == 0) way = sign_dot(side[i], first);
    if (i == 0) {
      start = way;
    } else if (way != before) {
      ++changes;
    }
    before = way;
  }
  if (before != start) ++changes;
  return changes == 2;
}

Surface planar_surface(std::span<const Corner> chain, Triple normal) {
  Surface surface;
  surface.offset = dot(normal, chain[0].p);
  surface.normal = std::move(normal);
  std::vector<Corner> strict = without_straight_corners({chain.begin(), chain.end()});
  if (strictly_convex(strict, surface.normal)) {
    surface.hull = strict;
    surface.inside.push_back(std::move(strict));
  } else {
    cut_into_trapezoids(surface, chain);
  }
  return surface;
}

/// Cuts a polygon that is not planar into triangles: a fan from the first vertex, unless that folds over itself as seen
/// along the axis of the largest component of the area vector; then ears, each time the next one going round from where
/// the last was cut, the second vertex first; and the fan again where there is no ear, since the chain crosses itself.
class Triangulation {
 public:
  using Triangle = std::array<std::size_t, 3>;
  explicit Triangulation(std::span<const Corner> chain) : chain_(chain) {
    const Triple along = area_vector(chain);
    const std::array<const Integer*, 3> parts{&along.x, &along.y, &along.z};
    for (int k = 1; k < 3; ++k) {
      if (abs(*parts[static_cast<std::size_t>(k)]) > abs(*parts[static_cast<std::size_t>(axis_)])) axis_ = k;
    }
    way_ = sgn(*parts[static_cast<std::size_t>(axis_)]);
  }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> fan;
    bool with = false, against = false;
    for (std::size_t i = 1; i + 1 < chain_.size(); ++i) {
      fan.push_back({0, i, i + 1});
      with = with || turn(0, i, i + 1) > 0;
      against = against || turn(0, i, i + 1) < 0;
    }
    if (way_ == 0 || !(with && against)) return fan;
    std::vector<Triangle> out = ears();
    return out.empty() ? fan : out;
  }

 private:
  int turn(std::size_t a, std::size_t b, std::size_t c) const {
    const Triple n = cross(chain_[b].p - chain_[a].p, chain_[c].p - chain_[a].p);
    return way_ * sgn(axis_ == 0 ? n.x : axis_ == 1 ? n.y : n.z);
  }
  /// The same place in the view?
  bool same_place(std::size_t a, std::size_t b) const {
    const Triple d = chain_[a].p - chain_[b].p;
    return (axis_ == 0 || d.x == 0) && (axis_ == 1 || d.y == 0) && (axis_ == 2 || d.z == 0);
  }
  bool is_ear(const std::vector<std::size_t>& left, const Triangle& t) const {
    const int way = turn(t[0], t[1], t[2]);
    if (way <= 0) return way == 0;
    return std::none_of(left.begin(), left.end(), [&](std::size_t p) {
      return !same_place(p, t[0]) && !same_place(p, t[1]) && !same_place(p, t[2]) && turn(t[0], t[1], p) >= 0 &&
             turn(t[1], t[2], p) >= 0 && turn(t[2], t[0], p) >= 0;
    });
  }
  std::vector<Triangle> ears() const {
    std::vector<std::size_t> left(chain_.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    std::vector<Triangle> out;
    for (std::size_t at = 1; left.size() > 3;) {
      const std::size_t n = left.size();
      std::size_t tried = 0;
      const auto ear = [&] { return Triangle{left[(at + n - 1) % n], left[at % n], left[(at + 1) % n]}; };
      while (tried < n && !is_ear(left, ear())) {
        ++at;
        ++tried;
      }
      if (tried == n) return {};
      out.push_back(ear());
      at %= n;
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    }
    if (turn(left[0], left[1], left[2]) < 0) return {};
    out.push_back({left[0], left[1], left[2]});
    return out;
  }

  std::span<const Corner> chain_;
  int axis_ = 0, way_ = 0;
};

/// By place: where a loop passes a place twice, a triangle's side may be an edge of it between two other corners.
bool is_edge(const std::vector<Corner>& chain, const Triple& p, const Triple& q) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Triple &a = chain[i].p, &b = chain[i + 1 == chain.size() ? 0 : i + 1].p;
    if ((same(a, p) && same(b, q)) || (same(a, q) && same(b, p))) return true;
  }
  return false;
}

}  // namespace

Shape Scene::make_shape(std::uint32_t polygon) const {
  Shape shape;
  const auto indices = corners(polygon);
  std::vector<Corner> chain;
  for (const std::uint32_t v : indices) chain.push_back({v, points_[v], 1});
  const Triple any = any_normal(chain);
  if (any.is_zero()) return shape;
  const std::size_t n = chain.size();
  const bool planar = n == 3 || std::all_of(chain.begin(), chain.end(),
                                            [&](const Corner& c) { return sign_dot(any, c.p - chain[0].p) == 0; });
  if (planar) {
    Triple normal = n == 3 ? any : area_vector(chain);
    if (normal.is_zero()) normal = any;
    Surface surface = planar_surface(chain, std::move(normal));
    for (std::size_t i = 0; i < n; ++i) surface.input_edges.push_back({indices[i], indices[(i + 1) % n]});
    if (!surface.inside.empty()) shape.surfaces.push_back(std::move(surface));
    return shape;
  }
  for (const auto& t : Triangulation(chain).triangles()) {
    const std::array<Corner, 3> corner{chain[t[0]], chain[t[1]], chain[t[2]]};
    Triple normal = any_normal(corner);
    if (normal.is_zero()) continue;
    Surface surface = planar_surface(corner, std::move(normal));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3];
      if (is_edge(chain, chain[a].p, chain[b].p)) surface.input_edges.push_back({indices[a], indices[b]});
    }
    shape.surfaces.push_back(std::move(surface));
  }
  return shape;
}

}  // namespace sightline::verify
