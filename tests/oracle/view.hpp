// A scene as one camera sees it, in integers: the oracle's own arithmetic, which knows nothing of the kernel's tables.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"
#include "tests/oracle/arrangement.hpp"

namespace sightline::oracle {

/// Coordinates along forward, right and up from the eye, times one positive number that makes them integers. A ray with
/// v[0] > 0 passes the window's plane at s = v[1] / v[0] + 1/2, t = v[2] / v[0] + 1/2.
using Vec = std::array<mpz_class, 3>;
Vec cross(const Vec& a, const Vec& b);
mpz_class dot(const Vec& a, const Vec& b);
bool is_zero(const Vec& a);

/// A planar figure of a polygon, filled by the even-odd rule: the polygon itself, or one of its triangles if its
/// vertices do not lie in a plane.
struct Piece {
  PolygonId polygon;
  std::vector<PointId> loop;
  Vec normal;
  mpz_class offset;  // normal . x = offset
};

/// A place where a ray hits the piece's plane: at depth num / den times the ray, den > 0.
struct Depth {
  mpz_class num, den;
};
int compare(const Depth& a, const Depth& b);

class View {
 public:
  View(const Scene& scene, const Camera& camera);

  /// Pieces that can be seen at all: not edge-on, and not from behind in one-sided scenes.
  const std::vector<Piece>& pieces() const { return pieces_; }
  const Vec& point(PointId v) const { return points_[v]; }
  std::uint32_t point_count() const { return static_cast<std::uint32_t>(points_.size()); }
  /// Is the vertex a corner of a polygon that has an area?
  bool used(PointId v) const { return used_[v]; }
  const std::vector<PointId>& corners(PolygonId p) const { return corners_[p]; }

  /// The line in which the plane of the eye and two points meets the window, and so on, as normals of planes through
  /// the eye; zero where not defined.
  Vec line_of_points(PointId a, PointId b) const { return cross(points_[a], points_[b]); }
  Vec line_of_planes(const std::array<PointId, 3>& p, const std::array<PointId, 3>& q) const;
  static Vec line_of_window(std::uint32_t side);

  /// All segments in the window that the border of a visible region may lie on, the window's own border first.
  std::vector<Segment> segments() const;

  /// The ray through a point of the window, scaled to integers.
  static Vec ray(const Point& p);
  /// Depth at which the ray meets the plane of the piece; false if it does not, in front of the eye.
  static bool hit(const Piece& piece, const Vec& ray, Depth& depth);
  /// Is the place where the ray meets the piece's plane inside of it? It must not be on its border.
  bool inside(const Piece& piece, const Vec& ray) const;

 private:
  void add_segment(const Vec& p, const Vec& q, std::vector<Segment>& out) const;
  void add_intersection(const Piece& a, const Piece& b, std::vector<Segment>& out) const;
  bool spans_plane(Piece& piece) const;

  std::vector<Vec> points_;
  std::vector<char> used_;
  std::vector<std::vector<PointId>> corners_;
  std::vector<Piece> pieces_;
};

}  // namespace sightline::oracle
