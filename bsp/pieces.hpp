// Convex pieces of surfaces, cut to the cells in which they lie.
#pragma once

#include <cmath>

#include "bsp/corner_sides.hpp"

namespace sightline {

/// A part of a surface: corners[first .. first + count), counter-clockwise seen from the front of its plane; bounds in
/// unit coordinates, rounded, for choosing where to cut, never for deciding what is where.
struct Piece {
  SurfaceId surface;
  PlaneId plane;
  std::uint32_t first, count;
  glm::dvec3 low, high;
  double known_area = -1;  // for who asks often; less than 0 until then
};

/// The axis along which a normal is longest.
inline int main_axis(const double n[3]) {
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(n[i]) > std::abs(n[k])) k = i;
  }
  return k;
}
/// Half the surface of a box of that size.
inline double surface(const glm::dvec3& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }

/// On which side of a plane a box lies whose bounds are rounded as those of pieces and faces are: 0 where the plane is
/// not clear of it.
class BoxSide {
 public:
  explicit BoxSide(const ApproxPlane& plane) : p_(plane) {}
  Sign of(const glm::dvec3& low, const glm::dvec3& high) const {
    double least = -p_.d, most = -p_.d;
    for (int k = 0; k < 3; ++k) {
      const double a = p_.n[k] * low[k], b = p_.n[k] * high[k];
      least += std::min(a, b);
      most += std::max(a, b);
    }
    return least > clear ? 1 : most < -clear ? -1 : 0;
  }

 private:
  // A corner is known within 2^-48 along each axis, components of n, at most 1, and d, at most 3, within 2^-53; three
  // products and three sums of at most 6 are rounded: 3 x 2^-48 + 7 x 2^-53 + 21 x 2^-53 < 2^-46.
  static constexpr double clear = 0x1p-40;
  ApproxPlane p_;
};

/// The arena in which the corners of all pieces lie. `planes` is the growing table of the complex.
class Pieces {
 public:
  Pieces(const Scene& scene, const PlaneTable& planes) : scene_(scene), planes_(planes) {}

  /// Room for so many corners, beforehand.
  void reserve(std::size_t corners) { corners_.reserve(corners); }
  Piece whole(SurfaceId surface);
  /// One that was made before, of a surface, by its corners.
  Piece piece(SurfaceId surface, std::uint32_t first, std::uint32_t count) const;
  Sign side(const PieceCorner& corner, PlaneId plane) const {
    return corner.point != none ? point_side(planes_, corner.point, plane) : vertex_side(planes_, corner.place, plane);
  }
  /// Where the piece lies: bit 0 set: partly behind the plane, bit 1: partly in front; 0: in the plane.
  int sides(const Piece& piece, PlaneId plane);
  /// The same for one that is only looked at: nothing is kept for split().
  int exact_sides(const Piece& piece, PlaneId plane) const;
  /// Cuts the piece, which lies on both sides, as found by the call of sides() just before.
  void split(const Piece& piece, PlaneId plane, Piece& behind, Piece& front);
  double area(const Piece& piece) const;  // rounded
  /// The arena may be given away, and cut back to what it was.
  void swap_corners(std::vector<PieceCorner>& other) { corners_.swap(other); }
  std::size_t corner_count() const { return corners_.size(); }
  void truncate(std::size_t count) {
    corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(count), corners_.end());
  }
  std::span<const PieceCorner> corners(const Piece& p) const { return std::span(corners_).subspan(p.first, p.count); }

 private:
  void bound(Piece& piece) const;
  ImplicitVertex meet(const Piece& piece, PlaneId side, PlaneId plane) const;

  const Scene& scene_;
  const PlaneTable& planes_;
  std::vector<PieceCorner> corners_;
  std::vector<std::int8_t> sign_;  // of the corners, by the latest call of sides()
  std::vector<PieceCorner> halves_[2];
};

}  // namespace sightline
