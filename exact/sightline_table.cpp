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
  ExactEye& e = exact_eye_;
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
  e.is_short = e.difference_bits < 64 && e.stride == 1 && points.stride() == 1;
  used_ = 0;
  line_.clear();
  leading_.clear();
  by_direction_.clear();
  by_points_.clear();
  by_planes_.clear();
  if (++stamp_ == 0) {
    std::fill(side_stamp_.begin(), side_stamp_.end(), 0);
    told_.clear();
    stamp_ = 1;
  }
}

SightlineRef SightlineTable::of_points(PointId a, PointId b) {
  const bool swapped = b < a;
  if (swapped) std::swap(a, b);
  const SightlineRef found = unpacked(by_points_.get(pair_key(a, b), [&] {
    const SightlineRef made = exact_eye_.is_short ? make_of_short_points(a, b) : make_of_points(a, b);
    if (made.id != none && line_[made.id].a == none) {
      line_[made.id].a = made.sign > 0 ? a : b;
      line_[made.id].b = made.sign > 0 ? b : a;
    }
    return packed(made);
  }));
  return swapped && found.id != none ? -found : found;
}

SightlineRef SightlineTable::of_planes(PlaneId p, PlaneId q) {
  const bool swapped = q < p;
  if (swapped) std::swap(p, q);
  const SightlineRef found = unpacked(by_planes_.get(pair_key(p, q), [&] { return packed(make_of_planes(p, q)); }));
  return swapped && found.id != none ? -found : found;
}

namespace {

// The direction (up to sign) in fixed point, as cells of a grid over two coordinates, with the exact signs of the
// components. x / |x|_1 of equal lines differ by rounding only: the components are within 2^-53 of the exact ones,
// |x|_1 >= 1/2, so each quotient is within 2 (2^-53 + 3 2^-53) + 3 2^-53 = 11 2^-53 of the exact one, and two of them
// within 22 2^-53 < 2^-48: less than a step of the fixed point 2^-48, at most 1 after truncation, 2 with room.
struct DirectionKey {
  static constexpr double scale = 0x1p48;
  static constexpr int cell = 16;  // bits of fixed point inside a cell
  std::int64_t s, t;               // fixed point
  std::uint64_t signs;

  DirectionKey(const Sign* sign, Sign leading, const glm::dvec3& approx) {
    const double norm = std::abs(approx.x) + std::abs(approx.y) + std::abs(approx.z);
    const double f = leading * scale / norm;
    // Cell borders are moved away from the simple fractions that models are full of.
    s = static_cast<std::int64_t>(f * approx.x) + 0x5a3d;
    t = static_cast<std::int64_t>(f * approx.y) + 0x3c69;
    signs = static_cast<std::uint64_t>(13 + leading * (9 * sign[0] + 3 * sign[1] + sign[2]));
  }
  std::uint64_t key(std::int64_t cell_s, std::int64_t cell_t) const {
    return (static_cast<std::uint64_t>(cell_s) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(cell_t)) *
               0xbf58476d1ce4e5b9u ^
           signs;
  }
};

}  // namespace

SightlineRef SightlineTable::find_or_add(const Normal& n) {
  const Sign leading = n.sign[0] != 0 ? n.sign[0] : n.sign[1] != 0 ? n.sign[1] : n.sign[2];
  const DirectionKey d(n.sign, leading, n.approx);
  constexpr std::int64_t slack = 2;
  const std::int64_t s0 = (d.s - slack) >> d.cell, s1 = (d.s + slack) >> d.cell;
  const std::int64_t t0 = (d.t - slack) >> d.cell, t1 = (d.t + slack) >> d.cell;
  SightlineId found = none;
  const auto same = [&](SightlineId id) {
    if (!same_line(id, n)) return false;
    found = id;
    return true;
  };
  const SightlineId id = size();
  if (s0 == s1 && t0 == t1) {  // as nearly always
    by_direction_.find_or_insert(d.key(s0, t0), id, same);
  } else {
    for (std::int64_t s = s0; s <= s1 && found == none; ++s)
      for (std::int64_t t = t0; t <= t1 && found == none; ++t) by_direction_.find(d.key(s, t), same);
    if (found == none) by_direction_.insert(d.key(d.s >> d.cell, d.t >> d.cell), id);
  }
  if (found != none) return {found, leading * line_[found].leading};
  const std::size_t count = std::size_t{3} * words_for(n.bits);
  if (used_ + count > words_.size()) words_.resize(2 * words_.size() + count + 256);
  std::uint64_t* const to = words_.data() + used_;
  std::copy(n.words, n.words + 3, to);
  if (count > 3) std::copy(n.words + 3, n.words + count, to + 3);
  line_.push_back({n.approx, used_, n.bits, leading, none, none});
  if (n.bits > word_bits) {
    leading_.resize(line_.size());
    leading_.back() = n.leading;
  }
  used_ += count;
  return {id, 1};
}

bool SightlineTable::same_line(SightlineId id, const Normal& n) const {
  const Line& line = line_[id];
  const std::uint64_t *const words = n.words, *const other = words_.data() + line.first;
  const std::uint32_t bits = n.bits, stride = words_for(bits), other_stride = words_for(line.bits);
  if (bits == line.bits && std::equal(words, words + std::size_t{3} * stride, other)) return true;
  const glm::dvec3 &o = line.approx, &approx = n.approx;
  constexpr double bound = 16 * u;  // as in parallel() of planes
  if (std::abs(o.y * approx.z - o.z * approx.y) > bound || std::abs(o.z * approx.x - o.x * approx.z) > bound ||
      std::abs(o.x * approx.y - o.y * approx.x) > bound)
    return false;
  if (bits > word_bits && line.bits > word_bits && leading_apart(n.leading, leading_[id])) return false;
  return at_width(static_cast<int>(bits + line.bits) + 1, [&](auto width) {
    constexpr int W = width();
    return narrowed<W>(static_cast<int>(bits), static_cast<int>(line.bits), [&]<int N, int M>(Words<N>, Words<M>) {
      const Wide3<W> c = cross<W, N>(load3<N>(words, stride), load3<N>(other, other_stride));
      return sign_of<W>(c[0]) == 0 && sign_of<W>(c[1]) == 0 && sign_of<W>(c[2]) == 0;
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
  const ExactEye& e = exact_eye_;
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
