// The lines in which other planes meet one plane, interned: figures in a plane, cut by planes, in exact arithmetic.
#pragma once

#include "exact/sightline_table.hpp"

namespace sightline {

/// The lines of one plane, each known by two of its points' unit coordinates, x and y: those along the two axes that
/// follow, cyclically, the axis along which the plane is looked at. A line is (a, b, c) up to a positive factor, and
/// its inner side is where a x + b y + c > 0; lines that coincide have one id, and refs carry the side. It is a
/// SightlineTable whose rays are the points (x, y, 1).
///
/// Laws. 1: a plane's line has the plane's front on its inner side; a turned sightline's is turned. 2: ids are equal
/// just if the lines are, whatever planes they come from. 3: a parallel plane has no line but a side, 0 just if it is
/// this plane. 4: with a and b in counter-clockwise order round a convex figure, seen against the axis, order(a, b, c)
/// is the side of c on which their corner lies. 5: corner() has x and y to the nearest double, the third coordinate
/// within 2^-46 for a corner in the unit box. 6: world() is each coordinate of the corner to the nearest double.
class PlaneLines {
 public:
  /// Of plane p, looked at along `axis`, the one of its normal's largest component (rounded) or another that is not 0.
  PlaneLines(const PlaneTable& planes, PlaneId p, int axis);

  struct Cut {
    SightlineRef line;  // id none: the planes are parallel,
    Sign side = 0;      // and this is the side of the other one on which all of this plane lies
  };
  Cut of_plane(PlaneId q);
  /// Of a plane through an eye; `from` must have been reset for the same planes.
  Cut of_sightline(const SightlineTable& from, SightlineRef q);

  /// Sign of det(a, b, c): see law 4.
  Sign order(SightlineRef a, SightlineRef b, SightlineRef c) { return lines_.order(a, b, c); }
  /// The same where `at` is the corner of a and b, within the unit box: quicker, for most.
  Sign side(const glm::dvec3& at, SightlineRef a, SightlineRef b, SightlineRef c) {
    if (a.id == c.id || b.id == c.id) {
      ++tally().identity;
      return 0;
    }
    // u = 2^-53. Coordinates up to 1/2, each within u/2, and components up to 1 within u: data 2 (u/2 + u/2) + u,
    // products u, sums u + 2u: 7u.
    const glm::dvec3& n = lines_.approx(c.id);
    const double value = n.x * at[(axis_ + 1) % 3] + n.y * at[(axis_ + 2) % 3] + n.z;
    constexpr double bound = 8 * 0x1p-53;
    if (value > bound || value < -bound) {
      ++tally().filter;
      return value > 0 ? c.sign : -c.sign;
    }
    return lines_.order(a, b, c);
  }
  /// Sign of the turn from side a of a figure to side b, counter-clockwise seen against the axis; 0: parallel.
  Sign turn(SightlineRef a, SightlineRef b) const;
  /// Where two lines meet that are not parallel, in unit coordinates.
  glm::dvec3 corner(SightlineId a, SightlineId b) const;
  std::array<double, 3> world(SightlineId a, SightlineId b) const;
  /// a, b, c; x and y in unit coordinates.
  std::array<Integer, 3> line(SightlineId id) const { return lines_.normal(id); }

  PlaneId plane() const { return plane_; }
  int axis() const { return axis_; }
  std::uint32_t size() const { return lines_.size(); }

 private:
  Cut intern(const std::uint64_t* normal, std::uint32_t normal_words, int normal_bits, const std::uint64_t* offset,
             std::uint32_t offset_words, int offset_bits, int shift);

  const PlaneTable& planes_;
  PlaneId plane_;
  int axis_;
  Sign slope_;  // of the plane's normal along the axis
  SightlineTable lines_;
  std::vector<std::uint64_t> offset_;
};

}  // namespace sightline
