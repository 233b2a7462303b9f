// The planes through one camera's eye, interned: lines of the window that coincide have one id.
#pragma once

#include "exact/exact_eye.hpp"
#include "exact/leading.hpp"
#include "exact/order_filter.hpp"
#include "exact/predicates.hpp"
#include "exact/stamped_map.hpp"
#include "exact/tally.hpp"

#include <vector>

namespace sightline {

/// All sightlines of one eye. A sightline is a plane through the eye, given by its normal up to a positive factor;
/// normals that are multiples of one another share one id (canonical: the one that came first; refs carry the sign).
/// Reusable: `reset` forgets the lines, keeps the buffers. Not for use by two threads at once.
///
/// A ray r lies in the front of line n when n.r > 0. The *corner* of two refs is the ray  n_b x n_a.
///
/// Laws. 1: exchanging the two points, or planes, turns the line over. 2: ids are equal just if the normals are
/// parallel; the refs' signs tell same from opposite. 3: order changes sign with every exchange and with every ref's
/// sign. 4: it is zero, by identity, for equal ids. 5: side(of_points(a, b), c) alternates in a, b, c. 6: for two
/// planes through the points a and b, of_planes is the line of_points(a, b). 7: a plane through the eye is its line
/// with every other plane. 8: after a reset all answers are those of a new table. 9: approximations hold what approx()
/// promises.
class SightlineTable {
 public:
  explicit SightlineTable(const PlaneTable& planes) { reset(planes, {}); }
  void reset(const PlaneTable& planes, const GridPoint& eye);

  /// Normal (a - eye) x (b - eye). id none: eye, a and b are collinear.
  SightlineRef of_points(PointId a, PointId b);
  /// Normal P(eye) n_q - Q(eye) n_p with P(x) = n_p.x - d_p: the plane of the eye and the line of planes p and q.
  /// id none: the planes are parallel or both contain the eye.
  SightlineRef of_planes(PlaneId p, PlaneId q);
  /// Normal n_p. The caller states that plane p contains the eye.
  SightlineRef of_plane(PlaneId p);
  /// Any integer normal, not zero.
  SightlineRef of_normal(const std::array<Integer, 3>& n);
  /// Of three components of `stride` two's complement words each, which are overwritten.
  SightlineRef of_normal(std::uint64_t* words, std::uint32_t stride) { return intern(words, stride); }

  /// Side of the eye against a plane; remembered.
  Sign eye_side(PlaneId p);
  /// Sign of det(n_a, n_b, n_c) of the oriented normals: 0 at once when two ids are equal, then filter, then exact.
  /// The workhorse: with a = b's neighbour it tells on which side of c the corner of a and b lies.
  Sign order(SightlineRef a, SightlineRef b, SightlineRef c) {
    if (a.id == b.id || b.id == c.id || c.id == a.id) {
      ++tally().identity;
      return 0;
    }
    const Sign s = filter_order(approx(a.id), approx(b.id), approx(c.id));
    if (s == uncertain) [[unlikely]]
      return a.sign * b.sign * c.sign * exact_order(a.id, b.id, c.id);
    ++tally().filter;
    return a.sign * b.sign * c.sign * s;
  }
  /// Side of a line on which a point of the scene is seen: sign of n.(p - eye).
  Sign side(SightlineRef a, PointId p) {
    // The difference point - eye: |.| <= E + 1, within u (2E + 2) with its own rounding; with the normal's u:
    // 3 (3E + 3) u; products 3 (E + 1) u, sums 5 (E + 1) u: 17 u (E + 1), u = 2^-53.
    const glm::dvec3 &n = approx(a.id), &at = planes_->points().approx(p), &eye = exact_eye_.approx;
    const double value = n.x * (at.x - eye.x) + n.y * (at.y - eye.y) + n.z * (at.z - eye.z);
    const double bound = 24 * 0x1p-53 * (exact_eye_.reach + 1);
    if (value > bound || value < -bound) {
      ++tally().filter;
      return value > 0 ? a.sign : -a.sign;
    }
    if (holds(a.id, p)) {
      ++tally().identity;
      return 0;
    }
    return exact_side(a, p);
  }
  /// Is the point p in the eye?
  bool is_eye(PointId p) const;

  std::uint32_t size() const { return static_cast<std::uint32_t>(line_.size()); }
  /// The canonical normal scaled by a power of two to largest component in [1/2, 1], each component within 2^-53.
  const glm::dvec3& approx(SightlineId id) const { return line_[id].approx; }
  /// Points a, b that the line was made of, (a - eye) x (b - eye) its normal up to a positive factor; or none.
  std::array<PointId, 2> points(SightlineId id) const { return {line_[id].a, line_[id].b}; }
  /// By identity: is p one of them?
  bool holds(SightlineId id, PointId p) const { return line_[id].a == p || line_[id].b == p; }
  std::array<Integer, 3> normal(SightlineId id) const;
  /// The ray N_a x N_b of two different lines' canonical normals, however close: scaled and rounded as approx().
  glm::dvec3 corner(SightlineId a, SightlineId b) const;
  /// Bit length of the longest component of the canonical normal.
  std::uint32_t bits(SightlineId id) const { return line_[id].bits; }
  /// The canonical normal's components one after the other, words_for(bits(id)) two's complement words each.
  const std::uint64_t* words(SightlineId id) const { return words_.data() + line_[id].first; }
  const PlaneTable& planes() const { return *planes_; }
  const GridPoint& eye() const { return eye_; }
  /// The eye in unit coordinates, each the nearest double.
  const glm::dvec3& eye_approx() const { return exact_eye_.approx; }

 private:
  struct Line {
    glm::dvec3 approx;
    std::uint64_t first;  // into words_
    std::uint32_t bits;
    Sign leading;  // of the first component that is not zero
    PointId a, b;
  };
  struct Normal {  // about to be looked for: words_for(bits) words a component, what approx() promises
    const std::uint64_t* words;
    std::uint32_t bits;
    Sign sign[3];
    glm::dvec3 approx;
    LeadingBits leading;  // where there are more than word_bits
  };
  SightlineRef intern(std::uint64_t* words, std::uint32_t stride);
  template <class Int>  // int64 or int128
  SightlineRef intern_short(const std::array<Int, 3>& n);
  SightlineRef find_or_add(const Normal& n);
  bool same_line(SightlineId id, const Normal& n) const;
  SightlineRef make_of_points(PointId a, PointId b), make_of_short_points(PointId a, PointId b);
  SightlineRef make_of_planes(PlaneId p, PlaneId q);
  Sign exact_eye_side(PlaneId p) const, exact_side(SightlineRef a, PointId p) const;
  /// As order() of three different lines, each as it is, where doubles do not tell.
  Sign exact_order(SightlineId a, SightlineId b, SightlineId c);
  Sign compute_order(SightlineId a, SightlineId b, SightlineId c) const;
  LeadingBits leading(SightlineId id) const {
    return line_[id].bits > word_bits ? leading_[id] : LeadingBits(words(id), line_[id].bits);
  }

  const PlaneTable* planes_ = nullptr;
  GridPoint eye_;
  ExactEye exact_eye_;
  std::vector<std::uint64_t> scratch_, words_;  // words_: filled up to used_
  std::size_t used_ = 0;
  std::vector<Line> line_;
  std::vector<LeadingBits> leading_;  // by line, where there are more than word_bits
  StampedMap by_direction_, by_points_, by_planes_;
  std::vector<std::uint32_t> side_stamp_;
  std::vector<std::int8_t> side_;
  std::uint32_t stamp_ = 0;
  /// What exact_order has answered lately: half of its questions are asked again, of a corner by the next polygon.
  struct Told {
    SightlineId a, b, c;
    std::uint32_t stamp;
    Sign sign;
  };
  std::vector<Told> told_;
};

}  // namespace sightline
