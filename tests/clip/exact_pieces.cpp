#include "tests/clip/exact_pieces.hpp"

#include <algorithm>
#include <map>

#include "exact/window.hpp"
#include "tests/oracle/scenes.hpp"

namespace sightline::testing {

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point exact(const glm::dvec3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

namespace {

Point meet(const ExactPlane& a, const ExactPlane& b, const ExactPlane& c) {
  const Point bc = cross(b.n, c.n), ca = cross(c.n, a.n), ab = cross(a.n, b.n);
  const Rational w = dot(a.n, bc);
  Point x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = (bc[k] * a.d + ca[k] * b.d + ab[k] * c.d) / w;
  return x;
}

/// Is d a nearest double of x? Neighbours are not nearer.
bool nearest(double d, const Rational& x) {
  const Rational off = abs(Rational(x - Rational(d)));
  return off <= abs(Rational(x - Rational(std::nextafter(d, 1e308)))) &&
         off <= abs(Rational(x - Rational(std::nextafter(d, -1e308))));
}

/// Twice the area times the normal's square length, of a figure that runs counter-clockwise around the normal.
Rational doubled_area(std::span<const Point> figure, const Point& normal) {
  Rational sum = 0;
  for (std::size_t k = 2; k < figure.size(); ++k)
    sum += dot(cross(figure[k - 1] - figure[0], figure[k] - figure[0]), normal);
  return sum;
}

/// Do the lines along the sides of `a` part it from `b`?
bool parts(std::span<const Point> a, std::span<const Point> b, const Point& normal) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Point& from = a[k];
    const Point inwards = cross(normal, a[(k + 1) % a.size()] - from);
    if (std::all_of(b.begin(), b.end(), [&](const Point& x) { return dot(inwards, x - from) <= 0; })) return true;
  }
  return false;
}

}  // namespace

ExactPieces::ExactPieces(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options,
                         const ClipResult& result)
    : scene_(scene), cameras_(cameras), options_(options), result_(result) {
  for (const Camera& c : cameras) eye_.push_back(exact(c.eye));
  for (const Surface& s : scene.surfaces()) {
    const auto edges = scene.edges(s);
    const Point a = vertex(edges[0].a), b = vertex(edges[0].b);
    Point c = a;
    for (const SurfaceEdge& e : edges) {
      c = vertex(e.a);
      const Point n = cross(b - a, c - a);
      if (n != Point{0, 0, 0}) break;
      c = vertex(e.b);
      if (cross(b - a, c - a) != Point{0, 0, 0}) break;
    }
    ExactPlane plane = plane_through(a, b, c);
    Rational along = 0;
    for (int k = 0; k < 3; ++k) along += plane.n[static_cast<std::size_t>(k)] * scene.planes().integer(s.plane, k);
    if (along < 0) plane = {Point{-plane.n[0], -plane.n[1], -plane.n[2]}, -plane.d};
    surface_.push_back(plane);
    bounds_.emplace_back();
    for (const SurfaceEdge& e : edges) {
      const Point inwards = cross(plane.n, vertex(e.b) - vertex(e.a));
      bounds_.back().push_back({inwards, dot(inwards, vertex(e.a))});
    }
  }
  for (const ClipPiece& piece : result.pieces) {
    const ExactPlane& own = surface_[piece.surface];
    std::vector<ExactPlane> sides;
    for (std::uint32_t k = 0; k < piece.corner_count; ++k)
      sides.push_back(side_plane(result.corners[piece.first_corner + k].side, own));
    for (std::size_t k = 0; k < sides.size(); ++k)
      corner_.push_back(meet(own, sides[(k + sides.size() - 1) % sides.size()], sides[k]));
  }
}

ExactPlane ExactPieces::plane_through(const Point& a, const Point& b, const Point& c) const {
  const Point n = cross(b - a, c - a);
  return {n, dot(n, a)};
}

Point ExactPieces::ray(std::uint32_t camera, const glm::dvec2& st) const {
  const Camera& c = cameras_[camera];
  const Point f = exact(c.forward), r = exact(c.right), u = exact(c.up);
  const Rational s = Rational(st.x) - Rational(1, 2), t = Rational(st.y) - Rational(1, 2);
  Point p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = f[k] + s * r[k] + t * u[k];
  return p;
}

ExactPlane ExactPieces::side_plane(const ClipSide& side, const ExactPlane& own) const {
  const auto through_eye = [&](const Point& a, const Point& b) {
    const Point n = cross(a, b);
    return ExactPlane{n, dot(n, eye_[side.camera])};
  };
  switch (side.kind) {
    case ClipSide::edge: {
      const Point n = cross(own.n, vertex(side.b) - vertex(side.a));
      return {n, dot(n, vertex(side.a))};
    }
    case ClipSide::wedge:
      return through_eye(vertex(side.a) - eye_[side.camera], vertex(side.b) - eye_[side.camera]);
    case ClipSide::window: {
      static constexpr double ends[4][4] = {{0, 0, 0, 1}, {1, 0, 1, 1}, {0, 0, 1, 0}, {0, 1, 1, 1}};
      const double* const e = ends[side.a];
      return through_eye(ray(side.camera, {e[0], e[1]}), ray(side.camera, {e[2], e[3]}));
    }
    case ClipSide::region: {
      const auto& points = options_.regions[side.camera][side.a].points;
      return through_eye(ray(side.camera, points[side.b]), ray(side.camera, points[(side.b + 1) % points.size()]));
    }
    case ClipSide::intersection:
      return surface_[side.a];
  }
  return own;
}

bool ExactPieces::lists(const ClipPiece& piece, std::uint32_t camera) const {
  const auto first = result_.cameras.begin() + piece.first_camera;
  return std::find(first, first + piece.camera_count, camera) != first + piece.camera_count;
}

std::string ExactPieces::faults() {
  std::string text;
  const auto fault = [&](std::size_t piece, const std::string& what) {
    text += "piece " + std::to_string(piece) + " of surface " + std::to_string(result_.pieces[piece].surface) + ": " +
            what + "\n";
  };
  std::map<SurfaceId, std::vector<std::size_t>> of_surface;
  for (std::size_t p = 0; p < result_.pieces.size(); ++p) {
    const ClipPiece& piece = result_.pieces[p];
    of_surface[piece.surface].push_back(p);
    if (piece.polygon != scene_.surfaces()[piece.surface].polygon) fault(p, "another polygon's");
    const auto figure = outline(p);
    const Point& normal = surface_[piece.surface].n;
    for (std::size_t k = 0; k < figure.size(); ++k) {
      const std::array<double, 3>& at = result_.corners[piece.first_corner + k].at;
      for (std::size_t i = 0; i < 3; ++i)
        if (!nearest(at[i], figure[k][i])) fault(p, "a coordinate is not the nearest double");
      const Point &next = figure[(k + 1) % figure.size()], &third = figure[(k + 2) % figure.size()];
      const Rational turn = dot(cross(next - figure[k], third - next), normal);
      if (turn <= 0) fault(p, "not convex");
    }
  }
  for (SurfaceId s = 0; s < scene_.surfaces().size(); ++s) {
    const auto& pieces = of_surface[s];
    const Point& normal = surface_[s].n;
    std::vector<Point> whole;
    const auto& bounds = bounds_[s];
    for (std::size_t k = 0; k < bounds.size(); ++k)
      whole.push_back(meet(surface_[s], bounds[(k + bounds.size() - 1) % bounds.size()], bounds[k]));
    Rational sum = 0;
    bool seen = false;
    for (const std::size_t p : pieces) {
      sum += doubled_area(outline(p), normal);
      seen = seen || result_.pieces[p].camera_count + result_.pieces[p].partly_count > 0;
      for (const Point& x : outline(p))
        if (std::any_of(bounds.begin(), bounds.end(), [&](const ExactPlane& b) { return b.at(x) < 0; }))
          fault(p, "reaches beyond its surface");
    }
    if (sum != doubled_area(whole, normal)) text += "surface " + std::to_string(s) + ": areas do not add up\n";
    if (!seen && pieces.size() != 1) text += "surface " + std::to_string(s) + ": hidden, but cut\n";
    if (pieces.size() > 60) continue;  // a matter of time only
    for (std::size_t a = 0; a < pieces.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (!parts(outline(pieces[a]), outline(pieces[b]), normal) &&
            !parts(outline(pieces[b]), outline(pieces[a]), normal))
          fault(pieces[a], "overlaps piece " + std::to_string(pieces[b]));
  }
  return text;
}

namespace {

/// Strictly inside the segment?
bool inside(const Point& x, const Point& from, const Point& to) {
  for (std::size_t k = 0; k < 3; ++k)
    if (x[k] < std::min(from[k], to[k]) || x[k] > std::max(from[k], to[k])) return false;
  return x != from && x != to && cross(x - from, to - from) == Point{0, 0, 0};
}

}  // namespace

std::string ExactPieces::t_faults(const TFreePieces& joined) const {
  std::string text;
  std::map<Point, std::uint32_t> places;
  for (const std::uint32_t c : joined.corners)
    if (places.try_emplace(corner_[c], c).first->second != c) text += "a place with two names\n";
  for (std::size_t p = 0; p < result_.pieces.size(); ++p) {
    const std::string name = "piece " + std::to_string(p) + ": ";
    const auto own = std::span(joined.corners).subspan(joined.first[p], joined.first[p + 1] - joined.first[p]);
    const auto figure = outline(p);
    std::size_t at = 0;
    for (std::size_t k = 0; k < own.size(); ++k) {
      const Point &from = corner_[own[k]], &to = corner_[own[(k + 1) % own.size()]];
      for (const auto& [x, corner] : places)
        if (inside(x, from, to)) text += name + "a corner inside a side\n";
      if (at < figure.size() && from == figure[at]) {
        ++at;
      } else if (at == 0 || !inside(from, figure[at - 1], figure[at % figure.size()]) ||
                 !inside(from, corner_[own[k - 1]], figure[at % figure.size()])) {
        text += name + "a corner that is not its own, nor on a side\n";
      }
    }
    if (at != figure.size()) text += name + "a corner has gone\n";
  }
  return text;
}

bool ExactPieces::in_frame(std::uint32_t camera, const Point& x) const {
  // x - eye = w (forward + (s - 1/2) right + (t - 1/2) up)
  const Camera& c = cameras_[camera];
  const Point f = exact(c.forward), r = exact(c.right), u = exact(c.up), v = x - eye_[camera];
  const Rational det = dot(cross(f, r), u);
  const Rational w = dot(cross(v, r), u) / det;
  if (w <= 0) return false;
  const Rational s = dot(cross(f, v), u) / det / w + Rational(1, 2), t = dot(cross(f, r), v) / det / w + Rational(1, 2);
  if (s < 0 || s > 1 || t < 0 || t > 1) return false;
  if (camera >= options_.regions.size()) return true;
  for (const TextureRegion& region : options_.regions[camera]) {
    int left = 0, right = 0;
    for (std::size_t k = 0; k < region.points.size(); ++k) {
      const glm::dvec2 a = region.points[k], b = region.points[(k + 1) % region.points.size()];
      const Rational turn =
          (Rational(b.x) - Rational(a.x)) * (t - Rational(a.y)) - (Rational(b.y) - Rational(a.y)) * (s - Rational(a.x));
      left += turn > 0;
      right += turn < 0;
    }
    if ((left == 0 || right == 0) != region.interior) return false;
  }
  return true;
}

/// Of a point within a surface, by looking at every other surface.
bool ExactPieces::sees(std::uint32_t camera, const Point& x, SurfaceId surface) const {
  const Point& eye = eye_[camera];
  const auto opaque = [&](SurfaceId s) {
    const Rational side = surface_[s].at(eye);
    return side != 0 && !(scene_.options().one_sided && (side > 0) == scene_.surfaces()[s].flipped);
  };
  const auto covers = [&](SurfaceId s, const Point& p) {
    return std::all_of(bounds_[s].begin(), bounds_[s].end(), [&](const ExactPlane& b) { return b.at(p) >= 0; });
  };
  if (!opaque(surface) || !in_frame(camera, x)) return false;
  for (SurfaceId s = 0; s < scene_.surfaces().size(); ++s) {
    if (s == surface || !opaque(s)) continue;
    if (scene_.surfaces()[s].plane == scene_.surfaces()[surface].plane) {
      if (s < surface && covers(s, x)) return false;
      continue;
    }
    const Rational from = surface_[s].at(eye), to = surface_[s].at(x);
    if (sgn(from) * sgn(to) >= 0) continue;
    const Rational part = from / (from - to);
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = eye[k] + part * (x[k] - eye[k]);
    if (covers(s, p)) return false;
  }
  return true;
}

std::string ExactPieces::wrong_rays(std::uint64_t seed, int rays, int one_in) {
  std::string text;
  Random random(seed);
  for (std::size_t p = 0; p < result_.pieces.size(); ++p) {
    if (!random.once_in(one_in)) continue;
    const ClipPiece& piece = result_.pieces[p];
    const auto figure = outline(p);
    for (int ray = 0; ray < rays; ++ray) {
      Point x{0, 0, 0};
      Rational weights = 0;
      for (const Point& corner : figure) {
        const Rational weight(1 + random.below(1 << 20));
        weights += weight;
        for (std::size_t k = 0; k < 3; ++k) x[k] += weight * corner[k];
      }
      for (Rational& c : x) c /= weights;
      for (std::uint32_t c = 0; c < cameras_.size(); ++c) {
        if (sees(c, x, piece.surface) == lists(piece, c)) continue;
        text += "piece " + std::to_string(p) + " of surface " + std::to_string(piece.surface) + ": camera " +
                std::to_string(c) +
                (lists(piece, c) ? " is listed and does not see it\n" : " sees it and is not listed\n");
      }
    }
  }
  return text;
}

Rational ExactPieces::exact_area(PolygonId polygon, std::uint32_t camera) const {
  const Camera& c = cameras_[camera];
  const Point f = exact(c.forward), r = exact(c.right), u = exact(c.up);
  Rational sum = 0;
  const auto first = std::ranges::lower_bound(result_.pieces, polygon, {}, &ClipPiece::polygon);
  const auto last = std::ranges::upper_bound(result_.pieces, polygon, {}, &ClipPiece::polygon);
  for (auto piece = first; piece != last; ++piece) {
    if (!lists(*piece, camera)) continue;
    const auto p = static_cast<std::size_t>(piece - result_.pieces.begin());
    std::vector<std::array<Rational, 2>> st;
    for (const Point& x : outline(p)) {
      const Point v = x - eye_[camera];
      const Rational w = dot(cross(v, r), u);
      st.push_back({dot(cross(f, v), u) / w, dot(cross(f, r), v) / w});
    }
    Rational twice = 0;
    for (std::size_t k = 2; k < st.size(); ++k)
      twice += (st[k - 1][0] - st[0][0]) * (st[k][1] - st[0][1]) - (st[k - 1][1] - st[0][1]) * (st[k][0] - st[0][0]);
    sum += abs(twice) / 2;
  }
  return sum;
}

}  // namespace sightline::testing
