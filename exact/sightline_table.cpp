#include "exact/sightline_table.hpp"

#include "exact/plane_row.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sightline {
namespace {

constexpr double u = 0x1p-53;  // unit roundoff

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{a} << 32) | b; }

// A ref as one word, and back; none stays none with its sign +1.
std::uint32_t packed(SightlineRef r) { return r.id == none ? none : (r.id << 1) | (r.sign < 0 ? 1u : 0u); }
SightlineRef unpacked(std::uint32_t w) {
  return w == none ? SightlineRef{} : SightlineRef{w >> 1, (w & 1u) != 0 ? -1 : 1};
}

}  // namespace

void SightlineTable::reset(const PlaneTable& planes, const GridPoint& eye) {
  planes_ = &planes;
  eye_ = eye;
  Eye& e = exact_eye_;
  std::uint32_t bits = 0;
  for (const Integer& c : eye.c) bits = std::max(bits, magnitude_bits(c));
  e.bits = static_cast<int>(bits);
  e.shift = eye.shift;
  e.stride = words_for(bits);
  e.words.resize(std::size_t{3} * e.stride);
  e.reach = 0;
  const PointTable& points = planes.points();
  for (std::uint32_t k = 0; k < 3; ++k) {
    std::uint64_t* const w = e.words.data() + k * e.stride;
    store_words(eye.c[k], w, e.stride);
    const double x = words_to_double(w, e.stride, -points.grid().unit_bits() - eye.shift);
    e.approx[static_cast<int>(k)] = x;
    e.reach = std::max(e.reach, std::abs(x));
  }
  e.difference_bits = std::max(points.bits() + eye.shift, e.bits) + 1;
  words_.clear();
  line_.clear();
  approx_.clear();
  by_direction_.clear();
  by_points_.clear();
  by_planes_.clear();
  if (++stamp_ == 0) {
    std::fill(side_stamp_.begin(), side_stamp_.end(), 0);
    stamp_ = 1;
  }
}

SightlineRef SightlineTable::of_points(PointId a, PointId b) {
  const bool swapped = b < a;
  if (swapped) std::swap(a, b);
  SightlineRef found;
  const std::uint64_t key = pair_key(a, b);
  const auto take = [&](std::uint32_t w) {
    found = unpacked(w);
    return true;
  };
  if (!by_points_.find(key, take)) {
    found = make_of_points(a, b);
    by_points_.insert(key, packed(found));
  }
  return swapped && found.id != none ? -found : found;
}

SightlineRef SightlineTable::of_planes(PlaneId p, PlaneId q) {
  const bool swapped = q < p;
  if (swapped) std::swap(p, q);
  SightlineRef found;
  const std::uint64_t key = pair_key(p, q);
  const auto take = [&](std::uint32_t w) {
    found = unpacked(w);
    return true;
  };
  if (!by_planes_.find(key, take)) {
    found = make_of_planes(p, q);
    by_planes_.insert(key, packed(found));
  }
  return swapped && found.id != none ? -found : found;
}

namespace {

// Signs of three components: of the exact words, or, where no rounding can have made a zero of one, of the doubles.
struct Signs {
  Sign of[3];
  Sign leading;  // the first that is not zero: equal lines differ by a factor, and this fixes its sign
  Signs(const std::uint64_t* words, std::uint32_t stride, const glm::dvec3& approx) {
    for (int k = 0; k < 3; ++k) {
      of[k] = stride < 16 ? (approx[k] > 0) - (approx[k] < 0)
                          : sign_of_words(words + static_cast<std::uint32_t>(k) * stride, stride);
    }
    leading = of[0] != 0 ? of[0] : of[1] != 0 ? of[1] : of[2];
  }
};

// The direction (up to sign) in fixed point, as cells of a grid over two coordinates, with the exact signs of the
// components. x / |x|_1 of equal lines differ by rounding only: the components are within 2^-54 of the exact ones,
// |x|_1 >= 1/2, so each quotient is within 2 (2^-54 + 3 2^-54) + 3 2^-53 < 2^-50 of the exact one, and two of them
// within 2^-49: half a step of the fixed point 2^-48, at most 1 after truncation, 2 with room.
struct DirectionKey {
  static constexpr double scale = 0x1p48;
  static constexpr int cell = 16;  // bits of fixed point inside a cell
  std::int64_t s, t;               // fixed point
  std::uint64_t signs;

  DirectionKey(const Signs& sign, const glm::dvec3& approx) {
    const double norm = std::abs(approx.x) + std::abs(approx.y) + std::abs(approx.z);
    const double f = sign.leading * scale / norm;
    // Cell borders are moved away from the simple fractions that models are full of.
    s = static_cast<std::int64_t>(f * approx.x) + 0x5a3d;
    t = static_cast<std::int64_t>(f * approx.y) + 0x3c69;
    signs = 0;
    for (const Sign k : sign.of) signs = 3 * signs + static_cast<std::uint64_t>(sign.leading * k + 1);
  }
  std::uint64_t key(std::int64_t cell_s, std::int64_t cell_t) const {
    return (static_cast<std::uint64_t>(cell_s) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(cell_t)) *
               0xbf58476d1ce4e5b9u ^
           signs;
  }
};

}  // namespace

SightlineRef SightlineTable::find_or_add(const std::uint64_t* words, std::uint32_t bits, const glm::dvec3& approx) {
  const std::uint32_t stride = words_for(bits);
  const Signs signs(words, stride, approx);
  const DirectionKey d(signs, approx);
  constexpr std::int64_t slack = 2;
  const std::int64_t s0 = (d.s - slack) >> d.cell, s1 = (d.s + slack) >> d.cell;
  const std::int64_t t0 = (d.t - slack) >> d.cell, t1 = (d.t + slack) >> d.cell;
  SightlineId found = none;
  const auto same = [&](SightlineId id) {
    if (!same_line(id, words, bits, approx)) return false;
    found = id;
    return true;
  };
  for (std::int64_t s = s0; s <= s1 && found == none; ++s)
    for (std::int64_t t = t0; t <= t1 && found == none; ++t) by_direction_.find(d.key(s, t), same);
  if (found != none) {
    const Line& line = line_[found];
    return {found, signs.leading * Signs(words_.data() + line.first, words_for(line.bits), approx_[found]).leading};
  }
  const SightlineId id = size();
  by_direction_.insert(d.key(d.s >> d.cell, d.t >> d.cell), id);
  line_.push_back({words_.size(), bits});
  words_.insert(words_.end(), words, words + std::size_t{3} * stride);
  approx_.push_back(approx);
  return {id, 1};
}

bool SightlineTable::same_line(SightlineId id, const std::uint64_t* words, std::uint32_t bits,
                               const glm::dvec3& approx) const {
  const Line& line = line_[id];
  const std::uint64_t* const other = words_.data() + line.first;
  const std::uint32_t stride = words_for(bits), other_stride = words_for(line.bits);
  if (bits == line.bits && std::equal(words, words + std::size_t{3} * stride, other)) return true;
  const glm::dvec3& o = approx_[id];
  constexpr double bound = 16 * u;  // as in parallel() of planes
  if (std::abs(o.y * approx.z - o.z * approx.y) > bound || std::abs(o.z * approx.x - o.x * approx.z) > bound ||
      std::abs(o.x * approx.y - o.y * approx.x) > bound)
    return false;
  return at_width(static_cast<int>(bits + line.bits) + 1, [&](auto width) {
    constexpr int W = width();
    return narrowed<W>(static_cast<int>(bits), static_cast<int>(line.bits), [&]<int N, int M>(Words<N>, Words<M>) {
      const Wide3<W> n = cross<W, N>(load3<N>(words, stride), load3<N>(other, other_stride));
      return sign_of<W>(n[0]) == 0 && sign_of<W>(n[1]) == 0 && sign_of<W>(n[2]) == 0;
    });
  });
}

Sign SightlineTable::eye_side(PlaneId p) {
  if (p >= side_stamp_.size()) {
    side_stamp_.resize(planes_->size(), 0);
    side_.resize(planes_->size(), 0);
  }
  if (side_stamp_[p] == stamp_) return side_[p];
  // With E the largest |coordinate| of the eye, each within uE, and the plane's numbers within u (|d|: relative):
  // data 6 uE + u max(1, |d|), products 3 uE, sums (2 + 3 + 3) uE + u |d|.
  const ApproxPlane& q = planes_->approx(p);
  const Eye& e = exact_eye_;
  const double value = q.n[0] * e.approx.x + q.n[1] * e.approx.y + q.n[2] * e.approx.z - q.d;
  const double bound = u * (24 * e.reach + 4 * std::abs(q.d) + 2);
  Sign s = value > bound ? 1 : value < -bound ? -1 : uncertain;
  if (s == uncertain) {
    s = exact_eye_side(p);
  } else {
    ++tally().filter;
  }
  side_stamp_[p] = stamp_;
  side_[p] = static_cast<std::int8_t>(s);
  return s;
}

std::array<Integer, 3> SightlineTable::normal(SightlineId id) const {
  const Line& line = line_[id];
  return load3<0>(words_.data() + line.first, words_for(line.bits));
}

}  // namespace sightline
