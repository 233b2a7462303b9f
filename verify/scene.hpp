// A scene in exact integers, and what its polygons are as surfaces.
#pragma once

#include "verify/exact.hpp"
#include "verify/read.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <span>

namespace sightline::verify {

/// The place p / w; `vertex` is its index where it is a vertex of the file (w is 1 then), else none.
struct Corner {
  static constexpr std::uint32_t none = UINT32_MAX;
  std::uint32_t vertex = none;
  Triple p;
  Integer w = 1;
};

/// A convex region of a plane, counter-clockwise about the plane's normal, no three corners collinear.
using Piece = std::vector<Corner>;

/// A planar surface: normal . p = offset. `inside` tiles it; `outside` tiles what is left of `hull`, a convex polygon
/// around it (the surface itself where that is convex).
struct Surface {
  Triple normal;
  Integer offset;
  std::vector<Piece> inside, outside;
  Piece hull;
  std::vector<std::array<std::uint32_t, 2>> input_edges;  // sides of it that are edges of the polygon
};

/// A polygon: one surface where it is planar, a surface a triangle where it is not, none where it has no area.
struct Shape {
  std::vector<Surface> surfaces;
};

/// Immutable but for shapes, which are made when first asked for (from any thread).
class Scene {
 public:
  /// `snap`: a positive decimal, or empty for none. Throws std::invalid_argument where it is none.
  Scene(const Soup& soup, const std::string& snap);

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(points_.size()); }
  std::uint32_t polygon_count() const { return soup_.polygon_count(); }
  std::span<const std::uint32_t> corners(std::uint32_t polygon) const {
    return std::span(soup_.corners).subspan(soup_.first[polygon], soup_.first[polygon + 1] - soup_.first[polygon]);
  }
  /// On the scene's grid: in units of 2^-grid(), or of the snap.
  const Triple& point(std::uint32_t vertex) const { return points_[vertex]; }
  unsigned grid() const { return grid_; }
  bool snapped() const { return snapped_; }
  /// In world units, or units of the snap; exact without a snap, else to the nearest double.
  const std::array<double, 3>& near(std::uint32_t vertex) const { return near_[vertex]; }
  const Shape& shape(std::uint32_t polygon) const;
  /// Is the vertex a corner of a polygon?
  bool used(std::uint32_t vertex) const { return used_[vertex] != 0; }

  /// A place given in world units on a grid that holds it: snapped as the scene is. `bits`: of that grid.
  Triple place(const std::array<double, 3>& x, unsigned& bits) const;

 private:
  Shape make_shape(std::uint32_t polygon) const;

  const Soup& soup_;
  bool snapped_ = false;
  Rational unit_;
  unsigned grid_ = 0;
  std::vector<Triple> points_;
  std::vector<std::array<double, 3>> near_;
  std::vector<char> used_;
  mutable std::vector<std::unique_ptr<Shape>> shapes_;
  mutable std::array<std::mutex, 64> locks_;
};

/// Fills in inside, outside and hull of a planar surface bounded by a closed chain of corners that is not plainly
/// convex, by the even-odd rule.
void cut_into_trapezoids(Surface& surface, std::span<const Corner> chain);

}  // namespace sightline::verify
