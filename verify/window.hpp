// The window: lines and points in it, exact, each with doubles that decide most signs.
//
// A camera's rays are corner + s right + t up (each of the three doubled, so that they stay integers). A point of the
// window is the triple (X, Y, Z), Z > 0, with s = X/Z and t = Y/Z; a line is the covector (A, B, C) with
// A s + B t + C = 0, which is the plane through the eye that is seen as that line.
#pragma once

#include "verify/scene.hpp"

#include <deque>
#include <optional>

namespace sightline::verify {

/// `a b c` are proportional to n, the largest of magnitude 1/2 to 1, each truncated: off by less than 2^-52.
struct Line {
  Triple n;
  double a = 0, b = 0, c = 0;
};
Line make_line(Triple n);

/// A point of the closed window; s and t are off by less than 2^-50.
struct Point {
  Triple r;
  double s = 0, t = 0;
};
/// Takes r or -r, whichever has Z > 0 (Z is not 0), and divides.
Point make_point(Triple r);
/// The point where two lines cross that are not parallel.
Point crossing(const Line& a, const Line& b);

/// Bound on the error of a s + b t + c for a line and a point of the window: coefficients 3 * 2^-52, s and t
/// 2 * 2^-50, five roundings of values up to 3: 2^-50. Together below 4 * 2^-50.
inline constexpr double line_error = 0x1p-48;

inline double rough_side(const Line& line, const Point& p) { return line.a * p.s + line.b * p.t + line.c; }
/// Sign of the line at the point.
int side(const Line& line, const Point& p);
/// Order by s, then by t.
int compare_s(const Point& a, const Point& b);
int compare_t(const Point& a, const Point& b);
int compare(const Point& a, const Point& b);

/// A convex polygon in the window with its interior: on the positive side of all lines. Side i joins corner i to
/// corner i + 1.
struct Convex {
  std::vector<const Line*> sides;
  std::vector<Point> corners;
};
/// What lies on the positive side of `line`: true and `out` where that has area.
bool clip(const Convex& convex, const Line* line, Convex& out);
/// A point of the interior.
Point middle(const Convex& convex);

/// Does the open convex region {all lines > 0} meet the segment between two points? Lines may be any number.
bool meets_segment(std::span<const Line* const> lines, const Point& u, const Point& v);

/// A plane seen from the eye: 1/distance along a ray is (Triple . (s, t, 1)) / height, height > 0, linear in the
/// window. `front`: the eye is on the side from which the polygon runs counter-clockwise.
struct Depth {
  Triple form;
  Integer height;
  double a = 0, b = 0, c = 0, scale = 0;  // form / height, off by less than 2^-50 each, and the largest magnitude
  bool front = false;
};
/// Sign of (inverse distance of a) - (inverse distance of b): 1 where a is nearer.
int compare_depth(const Depth& a, const Depth& b, const Point& p);
/// The line on whose positive side a is nearer; zero where the planes are the same.
Triple depth_line(const Depth& a, const Depth& b);
bool same_plane(const Depth& a, const Depth& b);

/// The scene as a camera sees it.
class View {
 public:
  /// Throws std::invalid_argument where the three directions are linearly dependent.
  View(const Scene& scene, const std::array<double, 3>& eye, const std::array<double, 3>& forward,
       const std::array<double, 3>& right, const std::array<double, 3>& up);

  const Scene& scene() const { return scene_; }
  /// From the eye to a place.
  Triple ray(const Corner& corner) const;
  Triple ray(std::uint32_t vertex) const;
  /// The line of a plane through the eye with this normal.
  Triple line(const Triple& normal) const;
  /// The window's coordinates of a ray; Z has the sign of what is in front.
  Triple window(const Triple& ray) const;
  /// The plane of a surface; none where it contains the eye.
  std::optional<Depth> depth(const Surface& surface) const;
  /// The sides of a piece of a surface, the piece on their positive sides. `front` as in Depth.
  std::deque<Line> sides(const Piece& piece, bool front) const;
  /// left, right, bottom, top; the window on the positive side.
  const std::array<Line, 4>& border() const { return border_; }
  const Convex& square() const { return square_; }

  /// Doubles of window(ray(vertex)), all off by at most `error`, and of the factor k with k / z the inverse distance.
  struct Near {
    double x, y, z, error;
  };
  Near near(std::uint32_t vertex) const;
  double inverse_factor() const { return factor_; }

 private:
  const Scene& scene_;
  unsigned lift_ = 0;  // scene's grid to the common grid of scene and eye
  long depth_shift_ = 0;
  Triple eye_, right_, up_, corner_;
  Triple to_x_, to_y_, to_z_;
  std::array<double, 3> near_eye_{}, near_x_{}, near_y_{}, near_z_{};
  double factor_ = 0;
  std::array<Line, 4> border_;
  Convex square_;
};

}  // namespace sightline::verify
