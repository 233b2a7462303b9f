// The pieces of a clip once more, in plain rationals, from the names of their sides alone; and brute force for what is
// seen of them.
#pragma once

#include <gmpxx.h>

#include <array>
#include <string>

#include "clip/t_free.hpp"

namespace sightline::testing {

using Rational = mpq_class;
using Point = std::array<Rational, 3>;

Point operator-(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);
Rational dot(const Point& a, const Point& b);
Point exact(const glm::dvec3& v);

/// n.x = d.
struct ExactPlane {
  Point n;
  Rational d;
  Rational at(const Point& x) const { return dot(n, x) - d; }
};

class ExactPieces {
 public:
  ExactPieces(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options,
              const ClipResult& result);

  /// Every fault of the laws of clip() that can be told without rays, one a line: corners that are not the nearest
  /// doubles, pieces that are not convex, or overlap, or do not tile; surfaces that none sees and that are cut.
  std::string faults();
  /// The same for `rays` random points of each piece that is looked at, one in `one_in`: is each seen by those cameras
  /// that the piece lists, and no other?
  std::string wrong_rays(std::uint64_t seed, int rays, int one_in = 1);
  /// Every fault of the laws of t_free(), one a line.
  std::string t_faults(const TFreePieces& joined) const;
  /// The part of the window in which a camera sees the polygon.
  Rational exact_area(PolygonId polygon, std::uint32_t camera) const;
  double area(PolygonId polygon, std::uint32_t camera) const { return exact_area(polygon, camera).get_d(); }
  bool lists(const ClipPiece& piece, std::uint32_t camera) const;

 private:
  ExactPlane plane_through(const Point& a, const Point& b, const Point& c) const;
  ExactPlane side_plane(const ClipSide& side, const ExactPlane& own) const;
  Point ray(std::uint32_t camera, const glm::dvec2& st) const;
  bool in_frame(std::uint32_t camera, const Point& x) const;
  bool sees(std::uint32_t camera, const Point& x, SurfaceId surface) const;
  std::span<const Point> outline(std::size_t piece) const {
    return std::span(corner_).subspan(result_.pieces[piece].first_corner, result_.pieces[piece].corner_count);
  }
  Point vertex(PointId p) const { return exact(scene_.soup().vertices[p]); }

  const Scene& scene_;
  std::span<const Camera> cameras_;
  const ClipOptions& options_;
  const ClipResult& result_;
  std::vector<ExactPlane> surface_;              // of each surface, its front as the kernel's
  std::vector<std::vector<ExactPlane>> bounds_;  // of each surface: through its sides, inside positive
  std::vector<Point> eye_;
  std::vector<Point> corner_;  // of the result's corners
};

}  // namespace sightline::testing
