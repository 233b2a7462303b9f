#include "exact/plane_lines.hpp"

#include "exact/plane_row.hpp"
#include "exact/quotient.hpp"
#include "exact/rounding.hpp"

#include <algorithm>

namespace sightline {

PlaneLines::PlaneLines(const PlaneTable& planes, PlaneId p, int axis)
    : planes_(planes),
      plane_(p),
      axis_(axis),
      slope_(sign_of_words(planes.component(p, axis).words, planes.component(p, axis).count)),
      lines_(planes) {}

// With the plane N.x = D, the other n.x = d, and k the axis along which we look: N_k (n.x - d) has no x_k left once
// x_k is put in from the plane, and is a x + b y + c with
//   a = N_k n_i - n_k N_i,  b = N_k n_j - n_k N_j,  c = n_k D - N_k d,
// times the sign of N_k. Grid coordinates are unit coordinates times 2^unit_bits, so a and b take that factor; where d
// is in steps of 2^-shift everything else takes 2^shift.
PlaneLines::Cut PlaneLines::intern(const std::uint64_t* normal, std::uint32_t normal_words, int normal_bits,
                                   const std::uint64_t* offset, std::uint32_t offset_words, int offset_bits,
                                   int shift) {
  const PlaneRow own(planes_, plane_);
  const int up = planes_.points().grid().unit_bits() + shift;
  const auto k = static_cast<std::size_t>(axis_), i = (k + 1) % 3, j = (k + 2) % 3;
  const int bits = std::max({own.normal_bits + normal_bits + up, normal_bits + own.offset_bits + shift,
                             own.normal_bits + offset_bits}) +
                   1;
  return at_width(bits, [&](auto width) -> Cut {
    constexpr int W = width();
    const Wide3<W> m = own.normal<W>(), n = load3<W>(normal, normal_words);
    const Wide<W> d = load<W>(offset, offset_words);
    Wide3<W> l{minor2<W, W, W>(m[k], n[k], m[i], n[i]), minor2<W, W, W>(m[k], n[k], m[j], n[j]),
               Wide<W>(scaled_up<W>(times<W, W, W>(n[k], own.offset<W>()), shift) - times<W, W, W>(m[k], d))};
    // minor2(m_k, n_k, m_i, n_i) is m_k n_i - m_i n_k.
    l[0] = scaled_up<W>(l[0], up);
    l[1] = scaled_up<W>(l[1], up);
    if (slope_ < 0)
      for (auto& c : l) c = Wide<W>(-c);
    if (sign_of<W>(l[0]) == 0 && sign_of<W>(l[1]) == 0) return {{}, sign_of<W>(l[2])};
    if constexpr (W == 0) {
      return {lines_.of_normal(l), 0};
    } else {
      std::array<std::uint64_t, 3 * W> words;
      for (std::size_t c = 0; c < 3; ++c) std::copy(l[c].word, l[c].word + W, words.data() + c * W);
      return {lines_.of_normal(words.data(), W), 0};
    }
  });
}

PlaneLines::Cut PlaneLines::of_plane(PlaneId q) {
  if (q == plane_) return {};
  const std::uint32_t stride = words_for(planes_.normal_bits(q));
  return intern(planes_.words(q), stride, static_cast<int>(planes_.normal_bits(q)),
                planes_.words(q) + std::size_t{3} * stride, words_for(planes_.offset_bits(q)),
                static_cast<int>(planes_.offset_bits(q)), 0);
}

PlaneLines::Cut PlaneLines::of_sightline(const SightlineTable& from, SightlineRef q) {
  const std::uint64_t* const normal = from.words(q.id);
  const std::uint32_t stride = words_for(from.bits(q.id));
  const auto bits = static_cast<int>(from.bits(q.id));
  // The offset n.eye, in steps of the eye's grid: three products.
  int eye_bits = 0;
  for (const Integer& c : from.eye().c) eye_bits = std::max(eye_bits, static_cast<int>(magnitude_bits(c)));
  const int offset_bits = bits + eye_bits + 2;
  const std::uint32_t words = words_for(static_cast<std::uint32_t>(offset_bits));
  offset_.assign(words, 0);
  at_width(offset_bits, [&](auto width) {
    constexpr int W = width();
    const Wide3<W> n = load3<W>(normal, stride);
    Wide3<W> eye;
    for (std::size_t c = 0; c < 3; ++c) {
      if constexpr (W == 0) {
        eye[c] = from.eye().c[c];
      } else {
        store_words(from.eye().c[c], eye[c].word, W);
      }
    }
    const Wide<W> d = dot<W, W, W>(n, eye);
    if constexpr (W == 0) {
      store_words(d, offset_.data(), words);
    } else {
      const Wide<W> e = d;
      std::copy(e.word, e.word + words, offset_.data());
    }
  });
  Cut cut = intern(normal, stride, bits, offset_.data(), words, offset_bits, from.eye().shift);
  if (q.sign < 0) cut = {cut.line.id == none ? cut.line : -cut.line, -cut.side};
  return cut;
}

Sign PlaneLines::turn(SightlineRef a, SightlineRef b) const {
  if (a.id == b.id) {
    ++tally().identity;
    return 0;
  }
  return a.sign * b.sign * decide(static_cast<int>(lines_.bits(a.id) + lines_.bits(b.id)) + 1, [&](auto width) -> Sign {
           constexpr int W = width();
           const auto at = [&](SightlineId id) { return load3<W>(lines_.words(id), words_for(lines_.bits(id))); };
           const Wide3<W> x = at(a.id), y = at(b.id);
           return sign_of<W>(minor2<W, W, W>(x[0], x[1], y[0], y[1]));
         });
}

glm::dvec3 PlaneLines::corner(SightlineId a, SightlineId b) const {
  const int bits = static_cast<int>(lines_.bits(a) + lines_.bits(b)) + 1;
  glm::dvec3 at;
  at_width(bits, [&](auto width) {
    constexpr int W = width();
    const Wide3<W> x = load3<W>(lines_.words(a), words_for(lines_.bits(a)));
    const Wide3<W> y = load3<W>(lines_.words(b), words_for(lines_.bits(b)));
    const Wide3<W> meet = cross<W, W>(x, y);
    at[(axis_ + 1) % 3] = nearest_quotient<W>(meet[0], meet[2]);
    at[(axis_ + 2) % 3] = nearest_quotient<W>(meet[1], meet[2]);
  });
  // x and y are within u/2, u = 2^-53, the plane's numbers within u (d, up to 2, within 2u). The sum of three: data
  // 2 (u + u/2) + 2u, rounding 2u + 4u: below 12 u; over n_k >= 1/2, rounded: below 25 u, less than 2^-48.
  const ApproxPlane& p = planes_.approx(plane_);
  const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
  at[axis_] = (p.d - p.n[i] * at[i] - p.n[j] * at[j]) / p.n[axis_];
  return at;
}

std::array<double, 3> PlaneLines::world(SightlineId a, SightlineId b) const {
  const Grid& grid = planes_.points().grid();
  const auto meet = cross<0, 0>(lines_.normal(a), lines_.normal(b));
  const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
  const Integer x = shifted(meet[0], grid.unit_bits()), y = shifted(meet[1], grid.unit_bits());
  std::array<double, 3> at;
  at[static_cast<std::size_t>(i)] = grid.world(x, meet[2], i);
  at[static_cast<std::size_t>(j)] = grid.world(y, meet[2], j);
  const Integer height =
      planes_.integer(plane_, 3) * meet[2] - planes_.integer(plane_, i) * x - planes_.integer(plane_, j) * y;
  at[static_cast<std::size_t>(axis_)] = grid.world(height, Integer(planes_.integer(plane_, axis_) * meet[2]), axis_);
  return at;
}

}  // namespace sightline
