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
  std::uint32_t bits = 0;
  for (const Integer& c : eye.c) bits = std::max(bits, magnitude_bits(c));
  eye_bits_ = static_cast<int>(bits);
  eye_stride_ = words_for(bits);
  eye_words_.resize(std::size_t{3} * eye_stride_);
  eye_reach_ = 0;
  const PointTable& points = planes.points();
  for (std::uint32_t k = 0; k < 3; ++k) {
    std::uint64_t* const w = eye_words_.data() + k * eye_stride_;
    store_words(eye.c[k], w, eye_stride_);
    const double x = words_to_double(w, eye_stride_, -points.grid().unit_bits() - eye.shift);
    eye_approx_[static_cast<int>(k)] = x;
    eye_reach_ = std::max(eye_reach_, std::abs(x));
  }
  difference_bits_ = std::max(points.bits() + eye.shift, eye_bits_) + 1;
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

template <int W>
Wide3<W> SightlineTable::from_eye(PointId p) const {
  const PointTable& points = planes_->points();
  const Wide3<W> at = load3<W>(points.words(p), points.stride());
  const Wide3<W> from = load3<W>(eye_words_.data(), eye_stride_);
  return {Wide<W>(scaled_up<W>(at[0], eye_.shift) - from[0]), Wide<W>(scaled_up<W>(at[1], eye_.shift) - from[1]),
          Wide<W>(scaled_up<W>(at[2], eye_.shift) - from[2])};
}

namespace {

template <int W>
std::uint32_t write3(const Wide3<W>& n, std::vector<std::uint64_t>& words) {
  if constexpr (W == 0) {
    std::uint32_t bits = 0;
    for (const Integer& c : n) bits = std::max(bits, magnitude_bits(c));
    const std::uint32_t stride = words_for(bits);
    words.resize(std::size_t{3} * stride);
    for (std::uint32_t k = 0; k < 3; ++k) store_words(n[k], words.data() + k * stride, stride);
    return stride;
  } else {
    words.resize(std::size_t{3} * W);
    for (std::size_t k = 0; k < 3; ++k) std::copy(n[k].word, n[k].word + W, words.data() + k * W);
    return W;
  }
}

}  // namespace

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

SightlineRef SightlineTable::make_of_points(PointId a, PointId b) {
  std::vector<std::uint64_t> words;
  std::uint32_t stride = 1;
  // Two products of differences.
  at_width(2 * difference_bits_ + 1, [&](auto width) {
    constexpr int W = width();
    stride = write3<W>(cross<W, W>(from_eye<W>(a), from_eye<W>(b)), words);
    return 0;
  });
  return intern(words.data(), stride);
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

SightlineRef SightlineTable::make_of_planes(PlaneId p, PlaneId q) {
  const PlaneRow rp(*planes_, p), rq(*planes_, q);
  std::vector<std::uint64_t> words;
  std::uint32_t stride = 1;
  // P(eye): three products of normal and eye, the offset times 2^shift.
  const auto value_bits = [&](const PlaneRow& r) {
    return std::max(r.normal_bits + eye_bits_ + 2, r.offset_bits + eye_.shift) + 1;
  };
  const int bits = std::max(value_bits(rp) + rq.normal_bits, value_bits(rq) + rp.normal_bits) + 1;
  at_width(bits, [&](auto width) {
    constexpr int W = width();
    const Wide3<W> eye = load3<W>(eye_words_.data(), eye_stride_), np = rp.normal<W>(), nq = rq.normal<W>();
    const Wide<W> at_p = dot<W, W, W>(np, eye) - scaled_up<W>(rp.offset<W>(), eye_.shift);
    const Wide<W> at_q = dot<W, W, W>(nq, eye) - scaled_up<W>(rq.offset<W>(), eye_.shift);
    Wide3<W> n;
    for (std::size_t k = 0; k < 3; ++k) n[k] = minor2<W, W, W>(at_p, at_q, np[k], nq[k]);
    stride = write3<W>(n, words);
    return 0;
  });
  return intern(words.data(), stride);
}

SightlineRef SightlineTable::of_plane(PlaneId p) {
  const PlaneRow row(*planes_, p);
  std::vector<std::uint64_t> words(row.words, row.words + std::size_t{3} * row.normal_words);
  return intern(words.data(), row.normal_words);
}

SightlineRef SightlineTable::of_normal(const std::array<Integer, 3>& n) {
  std::vector<std::uint64_t> words;
  const std::uint32_t stride = write3<0>(n, words);
  return intern(words.data(), stride);
}

SightlineRef SightlineTable::intern(std::uint64_t* words, std::uint32_t stride) {
  std::uint32_t bits = 0;
  for (std::uint32_t k = 0; k < 3; ++k) bits = std::max(bits, magnitude_bits(words + k * stride, stride));
  if (bits == 0) return {};
  const std::uint32_t tight = words_for(bits);
  for (std::uint32_t k = 1; k < 3; ++k) std::copy(words + k * stride, words + k * stride + tight, words + k * tight);
  glm::dvec3 approx;
  for (std::uint32_t k = 0; k < 3; ++k)
    approx[static_cast<int>(k)] = words_to_double(words + k * tight, tight, -static_cast<int>(bits));
  return find_or_add(words, bits, approx);
}

namespace {

// Exact: the sign of the first component that is not zero. Equal lines differ by a factor; this fixes its sign.
Sign leading_sign(const std::uint64_t* words, std::uint32_t stride) {
  for (std::uint32_t k = 0; k < 3; ++k)
    if (const Sign s = sign_of_words(words + k * stride, stride); s != 0) return s;
  return 0;
}

// The direction (up to sign) in fixed point, as cells of a grid over two coordinates, with the exact signs of the
// components. x / |x|_1 of equal lines differ by rounding only: the components are within 2^-54 of the exact ones,
// |x|_1 >= 1/2, so each quotient is within 2 (2^-54 + 3 2^-54) + 3 2^-53 < 2^-50 of the exact one, and two of them
// within 2^-49: half a step of the fixed point 2^-48, at most 1 after truncation, 2 with room.
struct DirectionKey {
  static constexpr double scale = 0x1p48;
  static constexpr int cell = 16;  // bits of fixed point inside a cell
  std::int64_t s, t;               // fixed point
  std::uint64_t signs;

  DirectionKey(const std::uint64_t* words, std::uint32_t stride, const glm::dvec3& approx, Sign leading) {
    const double norm = std::abs(approx.x) + std::abs(approx.y) + std::abs(approx.z);
    const double f = leading * scale / norm;
    // Cell borders are moved away from the simple fractions that models are full of.
    s = static_cast<std::int64_t>(f * approx.x) + 0x5a3d;
    t = static_cast<std::int64_t>(f * approx.y) + 0x3c69;
    signs = 0;
    for (std::uint32_t k = 0; k < 3; ++k)
      signs = 3 * signs + static_cast<std::uint64_t>(leading * sign_of_words(words + k * stride, stride) + 1);
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
  const Sign leading = leading_sign(words, stride);
  const DirectionKey d(words, stride, approx, leading);
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
    return {found, leading * leading_sign(words_.data() + line.first, words_for(line.bits))};
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
    const Wide3<W> n = cross<W, W>(load3<W>(words, stride), load3<W>(other, other_stride));
    return sign_of<W>(n[0]) == 0 && sign_of<W>(n[1]) == 0 && sign_of<W>(n[2]) == 0;
  });
}

Sign SightlineTable::eye_side(PlaneId p) {
  if (p >= side_stamp_.size()) {
    side_stamp_.resize(planes_->size(), 0);
    side_.resize(planes_->size(), 0);
  }
  if (side_stamp_[p] == stamp_) return side_[p];
  const auto decide_side = [&]() -> Sign {
    // With E the largest |coordinate| of the eye, each within uE, and the plane's numbers within u (|d|: relative):
    // data 6 uE + u max(1, |d|), products 3 uE, sums (2 + 3 + 3) uE + u |d|.
    const ApproxPlane& q = planes_->approx(p);
    const double value = q.n[0] * eye_approx_.x + q.n[1] * eye_approx_.y + q.n[2] * eye_approx_.z - q.d;
    const double bound = u * (24 * eye_reach_ + 4 * std::abs(q.d) + 2);
    if (std::abs(value) > bound) {
      ++tally().filter;
      return value > 0 ? 1 : -1;
    }
    const PlaneRow row(*planes_, p);
    return decide(std::max(row.normal_bits + eye_bits_ + 2, row.offset_bits + eye_.shift) + 1, [&](auto width) -> Sign {
      constexpr int W = width();
      const Wide3<W> eye = load3<W>(eye_words_.data(), eye_stride_);
      return sign_of<W>(Wide<W>(dot<W, W, W>(row.normal<W>(), eye) - scaled_up<W>(row.offset<W>(), eye_.shift)));
    });
  };
  side_stamp_[p] = stamp_;
  side_[p] = static_cast<std::int8_t>(decide_side());
  return side_[p];
}

Sign SightlineTable::order(SightlineRef a, SightlineRef b, SightlineRef c) {
  if (a.id == b.id || b.id == c.id || c.id == a.id) {
    ++tally().identity;
    return 0;
  }
  const glm::dvec3 &x = approx_[a.id], &y = approx_[b.id], &z = approx_[c.id];
  const double det = (x.y * y.z - x.z * y.y) * z.x + (x.z * y.x - x.x * y.z) * z.y + (x.x * y.y - x.y * y.x) * z.z;
  // As in planes_orientation: entries at most 1, each within u: 46 u in all.
  constexpr double bound = 64 * u;
  const Sign signs = a.sign * b.sign * c.sign;
  if (std::abs(det) > bound) {
    ++tally().filter;
    return det > 0 ? signs : -signs;
  }
  return signs * exact_order(a.id, b.id, c.id);
}

Sign SightlineTable::exact_order(SightlineId a, SightlineId b, SightlineId c) const {
  const Line &x = line_[a], &y = line_[b], &z = line_[c];
  return decide(static_cast<int>(x.bits + y.bits + z.bits) + 3, [&](auto width) -> Sign {
    constexpr int W = width();
    const auto at = [&](const Line& l) { return load3<W>(words_.data() + l.first, words_for(l.bits)); };
    return sign_of<W>(det3<W, W, W>(at(x), at(y), at(z)));
  });
}

Sign SightlineTable::side(SightlineRef a, PointId p) {
  // The difference point - eye: |.| <= E + 1, within u (2E + 2) with its own rounding; with the normal's u:
  // 3 (3E + 3) u; products 3 (E + 1) u, sums 5 (E + 1) u.
  const glm::dvec3 &n = approx_[a.id], &at = planes_->points().approx(p);
  const double value = n.x * (at.x - eye_approx_.x) + n.y * (at.y - eye_approx_.y) + n.z * (at.z - eye_approx_.z);
  const double bound = u * (24 * eye_reach_ + 24);
  if (std::abs(value) > bound) {
    ++tally().filter;
    return value > 0 ? a.sign : -a.sign;
  }
  const Line& line = line_[a.id];
  return a.sign * decide(static_cast<int>(line.bits) + difference_bits_ + 2, [&](auto width) -> Sign {
           constexpr int W = width();
           const Wide3<W> normal = load3<W>(words_.data() + line.first, words_for(line.bits));
           return sign_of<W>(dot<W, W, W>(normal, from_eye<W>(p)));
         });
}

bool SightlineTable::is_eye(PointId p) const {
  // Both approximations are the nearest doubles: if they differ, so do the points.
  if (planes_->points().approx(p) != eye_approx_) return false;
  return at_width(difference_bits_, [&](auto width) {
    constexpr int W = width();
    const Wide3<W> d = from_eye<W>(p);
    return sign_of<W>(d[0]) == 0 && sign_of<W>(d[1]) == 0 && sign_of<W>(d[2]) == 0;
  });
}

std::array<Integer, 3> SightlineTable::normal(SightlineId id) const {
  const Line& line = line_[id];
  return load3<0>(words_.data() + line.first, words_for(line.bits));
}

}  // namespace sightline
