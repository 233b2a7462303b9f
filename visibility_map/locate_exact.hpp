// Exact coordinates in the window: the last stage of queries, after their filters. For this folder's own use.
#pragma once

#include "exact/window.hpp"
#include "visibility_map/map.hpp"

namespace sightline {

/// (w, x, y) with w > 0: the point s = 1/2 + x/w, t = 1/2 + y/w.
using WindowPoint = std::array<Integer, 3>;
/// (c, a, b): the line c w + a x + b y = 0.
using WindowLine = std::array<Integer, 3>;

/// Sign of the area of the triangle a, b, c in the window (s right, t up): +1 counter-clockwise.
Sign exact_orientation(const WindowPoint& a, const WindowPoint& b, const WindowPoint& c);
/// Sign of the difference a - b of coordinate 1 (s) or 2 (t).
Sign exact_compare(const WindowPoint& a, const WindowPoint& b, std::size_t coordinate);
/// The point that a double stands for.
WindowPoint exact_point(const glm::dvec2& st);
/// (s,t) of a point, each within 2^-53 for points of the window.
glm::dvec2 rounded(const WindowPoint& p);

/// The lines and vertices of a map, exactly, computed anew at each call. A line through the eye with normal n has the
/// window coordinates (n.forward, n.right, n.up), since a ray is w forward + x right + y up.
/// Errors: std::invalid_argument where a line or vertex of the map is none in this scene.
class ExactWindow {
 public:
  /// Both must outlive this.
  ExactWindow(const VisibilityMap& map, const Scene& scene);
  /// Normal of a line's plane, some multiple of it, in the scene's axes.
  std::array<Integer, 3> normal(const MapLine& line) const;
  /// The same line in the window.
  WindowLine line(const MapLine& line) const;
  WindowLine line(const std::array<Integer, 3>& normal) const;
  WindowPoint vertex(std::uint32_t v) const;
  /// Where two lines meet.
  static WindowPoint meet(const WindowLine& a, const WindowLine& b);

 private:
  std::array<Integer, 3> relative(PointId p) const;  // p - eye, times a power of two

  const VisibilityMap& map_;
  const Scene& scene_;
  GridPoint eye_;
  std::array<std::array<Integer, 3>, 3> vectors_;  // forward, right, up, times one power of two
};

}  // namespace sightline
