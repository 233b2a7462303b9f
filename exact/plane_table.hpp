// Interned canonical planes: coplanar polygons share one id.
#pragma once

#include "exact/fixed.hpp"
#include "exact/limbs.hpp"
#include "exact/point_table.hpp"

#include <array>
#include <vector>

namespace sightline {

/// A plane n.x = d in unit coordinates, scaled by a power of two so that the largest |n| lies in [1/2, 1]; each of the
/// four numbers is within 2^-53 of the exact one (|d| <= 2: planes of a scene meet its box).
struct ApproxPlane {
  double n[3];
  double d;
};

/// How a plane was first made; enough to make it again exactly from the scene's points. Written to .wp files.
struct PlaneSource {
  enum Kind : std::uint8_t { points, axis, wall } kind = points;
  std::uint32_t a = 0, b = 0, c = 0;  // points: three points; axis: a = axis, value is d; wall: points a, b; c = axis
};

/// Planes n.x = d on the grid, gcd-reduced, with the first non-zero component of n positive; equal planes get one id.
/// The side n.x > d is the plane's front.
///
/// Laws. 1: ids are equal just if the planes are. 2: exchanging two of the defining points turns the plane over: same
/// id, other `flipped`. 3: canonical: no common divisor, first component positive, through its points, walls parallel
/// to their axis. 4: approximations hold what ApproxPlane promises.
class PlaneTable {
 public:
  struct Interned {
    PlaneId id = none;     // none: the plane is not defined (collinear points, a = b, the axis along a-b)
    bool flipped = false;  // the canonical normal is opposite to that of the definition
  };
  PlaneTable() = default;
  /// `points` must outlive the table (a Scene keeps both; copies of a table share the points).
  explicit PlaneTable(const PointTable& points) : points_(&points) {}

  /// The plane through three points; definition's normal (b-a) x (c-a): counter-clockwise seen from its front.
  Interned add_points(PointId a, PointId b, PointId c);
  /// The plane coordinate[axis] = value (grid units); never flipped.
  Interned add_axis(int axis, const Integer& value);
  /// The plane through points a and b that is parallel to an axis; definition's normal (b-a) x e_axis.
  Interned add_wall(PointId a, PointId b, int axis);

  std::uint32_t size() const { return static_cast<std::uint32_t>(approx_.size()); }
  const ApproxPlane& approx(PlaneId p) const { return approx_[p]; }
  const PlaneSource& source(PlaneId p) const { return source_[p]; }
  /// Component k of the plane: 0..2 the normal, 3 the offset d.
  Limbs component(PlaneId p, int k) const;
  Integer integer(PlaneId p, int k) const;
  std::uint32_t normal_bits(PlaneId p) const { return record_[p].normal_bits; }  // the longest component of n
  std::uint32_t offset_bits(PlaneId p) const { return record_[p].offset_bits; }
  /// The three components of n, words_for(normal_bits(p)) words each; then d, words_for(offset_bits(p)) words.
  const std::uint64_t* words(PlaneId p) const { return words_.data() + record_[p].first; }
  /// The axis k with n = e_k, or -1.
  int axis(PlaneId p) const { return axis_[p]; }
  const PointTable& points() const { return *points_; }
  void rebind(const PointTable& points) { points_ = &points; }  // after the points have moved in memory

  /// Memory held, in bytes, the index of the interning left out.
  std::size_t bytes() const {
    return words_.size() * sizeof(words_[0]) +
           size() * (sizeof(Record) + sizeof(ApproxPlane) + sizeof(PlaneSource) + sizeof(axis_[0]));
  }

 private:
  // Where a plane's words stand: words_for(normal_bits) for each component of n, then words_for(offset_bits) for d.
  struct Record {
    std::uint64_t hash;
    std::uint64_t first;
    std::uint32_t normal_bits;
    std::uint32_t offset_bits;
  };
  Interned intern(const std::array<Integer, 3>& n, const Integer& d, const PlaneSource& source);
  Interned intern_short(const std::array<Fixed<1>, 3>& n, const Fixed<2>& d, const PlaneSource& source);
  Interned intern_short(const std::array<Fixed<2>, 3>& n, const Fixed<3>& d, const PlaneSource& source);
  Interned intern_words(const std::uint64_t* words, std::uint32_t normal_bits, std::uint32_t offset_bits, bool flipped,
                        const PlaneSource& source);
  void grow_index();

  const PointTable* points_ = nullptr;
  std::vector<std::uint64_t> words_;
  std::vector<Record> record_;
  std::vector<ApproxPlane> approx_;
  std::vector<PlaneSource> source_;
  std::vector<std::int8_t> axis_;
  std::vector<PlaneId> index_;  // open addressing by hash; a power of two slots
};

}  // namespace sightline
