#include "tests/oracle/view.hpp"

#include <algorithm>
#include <optional>

namespace sightline::oracle {
namespace {

using Rational3 = std::array<mpq_class, 3>;

Rational3 exact(const glm::dvec3& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

Rational3 cross(const Rational3& a, const Rational3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpq_class dot(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

}  // namespace

Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpz_class dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool is_zero(const Vec& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

int compare(const Depth& a, const Depth& b) { return cmp(mpz_class(a.num * b.den), mpz_class(b.num * a.den)); }

View::View(const Scene& scene, const Camera& camera) {
  const PolygonSoup& soup = scene.soup();
  // Cramer's rule: the coordinates are the dot products with these, over the determinant, whose size does not matter.
  const Rational3 f = exact(camera.forward), r = exact(camera.right), u = exact(camera.up), eye = exact(camera.eye);
  std::array<Rational3, 3> rows{cross(r, u), cross(u, f), cross(f, r)};
  const int hand = sgn(dot(f, rows[0]));
  std::vector<Rational3> places;
  mpz_class scale = 1;
  for (const glm::dvec3& v : soup.vertices) {
    const Rational3 x = exact(v), from{x[0] - eye[0], x[1] - eye[1], x[2] - eye[2]};
    Rational3 place;
    for (std::size_t k = 0; k < 3; ++k) {
      place[k] = hand * dot(rows[k], from);
      if (place[k].get_den() > scale) scale = place[k].get_den();  // both are powers of two
    }
    places.push_back(place);
  }
  for (const Rational3& place : places) {
    Vec v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = mpq_class(place[k] * scale).get_num();
    points_.push_back(v);
  }

  used_.assign(points_.size(), 0);
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    const auto corners = scene.corners(p);
    corners_.emplace_back(corners.begin(), corners.end());
    std::vector<Piece> pieces{{p, corners_.back(), {}, 0}};
    if (!spans_plane(pieces[0])) continue;
    const bool planar =
        std::ranges::all_of(corners, [&](PointId v) { return dot(pieces[0].normal, points_[v]) == pieces[0].offset; });
    if (!planar) {  // which triangles a polygon is cut into is the scene's choice
      pieces.clear();
      for (const Surface& s : scene.surfaces(p)) {
        Piece piece{p, {}, {}, 0};
        for (const SurfaceEdge& e : scene.edges(s)) piece.loop.push_back(e.corner);
        if (s.flipped) std::ranges::reverse(piece.loop);  // back to the sense of the polygon
        if (spans_plane(piece)) pieces.push_back(piece);
      }
    }
    if (!scene.surfaces(p).empty()) {
      for (const PointId v : corners) used_[v] = 1;
    }
    for (const Piece& piece : pieces) {
      if (piece.offset == 0) continue;
      if (scene.options().one_sided) {
        Vec turn{0, 0, 0};
        for (std::size_t k = 0; k < piece.loop.size(); ++k) {
          const Vec c = cross(points_[piece.loop[k]], points_[piece.loop[(k + 1) % piece.loop.size()]]);
          for (std::size_t i = 0; i < 3; ++i) turn[i] += c[i];
        }
        // The eye must be where the corners run counter-clockwise; `hand` turns the sense of space back to the world's.
        if (hand * sgn(dot(turn, points_[piece.loop[0]])) >= 0) continue;
      }
      pieces_.push_back(piece);
    }
  }
}

/// Finds the plane of a loop from any three corners that are not in line.
bool View::spans_plane(Piece& piece) const {
  const Vec& o = points_[piece.loop[0]];
  for (std::size_t i = 1; i < piece.loop.size(); ++i) {
    for (std::size_t j = i + 1; j < piece.loop.size(); ++j) {
      piece.normal = cross(minus(points_[piece.loop[i]], o), minus(points_[piece.loop[j]], o));
      if (is_zero(piece.normal)) continue;
      piece.offset = dot(piece.normal, o);
      return true;
    }
  }
  return false;
}

Vec View::line_of_planes(const std::array<PointId, 3>& p, const std::array<PointId, 3>& q) const {
  const auto plane = [this](const std::array<PointId, 3>& three) {
    const Vec& o = points_[three[0]];
    const Vec n = cross(minus(points_[three[1]], o), minus(points_[three[2]], o));
    return std::pair{n, dot(n, o)};
  };
  const auto [n, d] = plane(p);
  const auto [m, e] = plane(q);
  // e (n.x - d) = d (m.x - e) holds in the eye, which is 0, and on the line of both planes.
  return {e * n[0] - d * m[0], e * n[1] - d * m[1], e * n[2] - d * m[2]};
}

Vec View::line_of_window(std::uint32_t side) {
  switch (side) {
    case 0:
      return {1, 2, 0};  // left: v[1] / v[0] = -1/2
    case 1:
      return {1, -2, 0};
    case 2:
      return {1, 0, 2};
    default:
      return {1, 0, -2};
  }
}

std::vector<Segment> View::segments() const {
  const Point corner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Segment> out;
  for (int k = 0; k < 4; ++k) out.emplace_back(corner[k], corner[(k + 1) % 4]);
  for (const Piece& piece : pieces_) {
    for (std::size_t k = 0; k < piece.loop.size(); ++k) {
      add_segment(points_[piece.loop[k]], points_[piece.loop[(k + 1) % piece.loop.size()]], out);
    }
  }
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces_.size(); ++j) add_intersection(pieces_[i], pieces_[j], out);
  }
  return out;
}

/// The part inside the window of the segment from the ray p to the ray q.
void View::add_segment(const Vec& p, const Vec& q, std::vector<Segment>& out) const {
  if (is_zero(cross(p, q))) return;  // seen as a point, or its line passes the eye
  mpq_class low = 0, high = 1;
  for (std::uint32_t side = 0; side < 4; ++side) {
    const Vec normal = line_of_window(side);
    const mpz_class a = dot(normal, p), b = dot(normal, q);
    if (a < 0 && b < 0) return;
    if (a >= 0 && b >= 0) continue;
    mpq_class at(a, mpz_class(a - b));
    at.canonicalize();
    if (a < 0 && at > low) low = at;
    if (b < 0 && at < high) high = at;
  }
  if (low >= high) return;
  const auto place = [&](const mpq_class& at) {
    std::array<mpq_class, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = mpq_class(p[k]) + at * mpq_class(q[k] - p[k]);
    return Point{v[1] / v[0] + mpq_class(1, 2), v[2] / v[0] + mpq_class(1, 2)};
  };
  out.emplace_back(place(low), place(high));
}

/// The line in which two pieces' planes meet, from the first to the last place where both may have it.
void View::add_intersection(const Piece& a, const Piece& b, std::vector<Segment>& out) const {
  const Vec along = cross(a.normal, b.normal);
  if (is_zero(along)) return;
  struct Place {
    Vec x;
    mpz_class w;  // the place is x / w, w > 0
    mpq_class at;
  };
  // Where the border of one piece meets the plane of the other.
  const auto range = [&](const Piece& piece, const Piece& other) -> std::optional<std::pair<Place, Place>> {
    std::vector<Place> places;
    for (std::size_t k = 0; k < piece.loop.size(); ++k) {
      const Vec &p = points_[piece.loop[k]], &q = points_[piece.loop[(k + 1) % piece.loop.size()]];
      const mpz_class f = dot(other.normal, p) - other.offset, g = dot(other.normal, q) - other.offset;
      if (f == 0) places.push_back({p, 1, 0});
      if (sgn(f) * sgn(g) < 0) {
        Place place{{}, abs(f) + abs(g), 0};
        for (std::size_t i = 0; i < 3; ++i) place.x[i] = abs(g) * p[i] + abs(f) * q[i];
        places.push_back(place);
      }
    }
    if (places.empty()) return std::nullopt;
    for (Place& place : places) {
      place.at = mpq_class(dot(along, place.x), place.w);
      place.at.canonicalize();
    }
    const auto [low, high] = std::ranges::minmax_element(places, {}, &Place::at);
    return std::pair{*low, *high};
  };
  const auto first = range(a, b), second = range(b, a);
  if (!first || !second) return;
  const Place& low = first->first.at < second->first.at ? second->first : first->first;
  const Place& high = first->second.at < second->second.at ? first->second : second->second;
  if (low.at < high.at) add_segment(low.x, high.x, out);
}

Vec View::ray(const Point& p) {
  const mpq_class x = p.x - mpq_class(1, 2), y = p.y - mpq_class(1, 2);
  const mpz_class& m = x.get_den();
  const mpz_class& n = y.get_den();
  return {m * n, x.get_num() * n, y.get_num() * m};
}

bool View::hit(const Piece& piece, const Vec& ray, Depth& depth) {
  depth.den = dot(piece.normal, ray);
  depth.num = piece.offset;
  if (depth.den < 0) {
    depth.den = -depth.den;
    depth.num = -depth.num;
  }
  return depth.den != 0 && depth.num > 0;
}

bool View::inside(const Piece& piece, const Vec& ray) const {
  Depth depth;
  if (!hit(piece, ray, depth)) return false;
  std::size_t drop = 0;
  while (piece.normal[drop] == 0) ++drop;
  const std::size_t i = (drop + 1) % 3, j = (drop + 2) % 3;
  const mpz_class x = depth.num * ray[i], y = depth.num * ray[j];
  const mpz_class& w = depth.den;
  bool odd = false;
  for (std::size_t k = 0; k < piece.loop.size(); ++k) {
    const Vec &p = points_[piece.loop[k]], &q = points_[piece.loop[(k + 1) % piece.loop.size()]];
    const bool p_above = p[j] * w > y, q_above = q[j] * w > y;
    if (p_above == q_above) continue;
    const int side = sgn(mpz_class((q[i] - p[i]) * (y - p[j] * w) - (q[j] - p[j]) * (x - p[i] * w)));
    if ((side > 0) == q_above) odd = !odd;
  }
  return odd;
}

}  // namespace sightline::oracle
