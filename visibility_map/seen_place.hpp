// Where two lines meet in the window, by numbers twice as long as doubles. Internal to visibility_map/.
#pragma once

#include "visibility_map/stitch_state.hpp"
#include "visibility_map/stitch_twofold.hpp"

#include <bit>
#include <cmath>

namespace sightline::stitching {

/// Two's complement words times 2^-bits, |.| <= 1, rounded down to a multiple of 2^-106.
inline Twofold from_words(const std::uint64_t* words, std::uint32_t count, std::uint32_t bits) {
  // The words at and above bit `bits - 106`, as one number of at most 107 bits and a sign.
  const int low = static_cast<int>(bits) - 106;
  const auto word = [&](int k) -> std::uint64_t {
    if (k < 0) return 0;
    if (k >= static_cast<int>(count)) return words[count - 1] >> 63 ? ~std::uint64_t{0} : 0;
    return words[k];
  };
  const int first = low >> 6, shift = low & 63;
  std::uint64_t part[2];
  for (int k = 0; k < 2; ++k) {
    part[k] = word(first + k) >> shift;
    if (shift != 0) part[k] |= word(first + k + 1) << (64 - shift);
  }
  // Upper and lower part of 53 bits; the upper one keeps the sign.
  const auto upper = static_cast<std::int64_t>(part[1] << 11 | part[0] >> 53);
  const std::uint64_t lower = part[0] & ((std::uint64_t{1} << 53) - 1);
  return fast_sum(static_cast<double>(upper) * 0x1p-53,
                  static_cast<double>(static_cast<std::int64_t>(lower)) * 0x1p-106);
}

/// The same of one word, which loses nothing, and of two; both halves of what is summed are exact.
[[gnu::always_inline]] inline Twofold from_word(std::uint64_t word, double power) {
  const auto x = static_cast<std::int64_t>(word);
  return fast_sum(static_cast<double>(x >> 10) * (0x1p10 * power), static_cast<double>(x & 1023) * power);
}
[[gnu::always_inline]] inline Twofold from_two_words(std::uint64_t low, std::uint64_t high, std::uint32_t bits) {
  // Moved up, so that the sign is followed by the first bit.
  const std::uint64_t top = (high << (127 - bits)) | (low >> 1 >> (bits - 64)), rest = low << (127 - bits);
  const auto upper = static_cast<std::int64_t>(top) >> 10;
  const auto lower = static_cast<std::int64_t>((top & 1023) << 43 | rest >> 21);
  return fast_sum(static_cast<double>(upper) * 0x1p-53, static_cast<double>(lower) * 0x1p-106);
}

struct Normal {
  Twofold x, y, z;
};
[[gnu::always_inline]] inline Normal normal(const SightlineTable& table, SightlineId id) {
  const std::uint32_t bits = table.bits(id);
  const std::uint64_t* const w = table.words(id);
  if (bits < 64) {
    const auto power = std::bit_cast<double>(std::uint64_t{1023 - bits} << 52);
    return {from_word(w[0], power), from_word(w[1], power), from_word(w[2], power)};
  }
  if (bits < 128) {
    return {from_two_words(w[0], w[1], bits), from_two_words(w[2], w[3], bits), from_two_words(w[4], w[5], bits)};
  }
  const std::uint32_t count = words_for(bits);
  return {from_words(w, count, bits), from_words(w + count, count, bits), from_words(w + 2 * count, count, bits)};
}

/// With u = 2^-53, v = u^2, F the largest component of f: normals are at most 1, within v. Products and the sums of
/// their upper parts lose nothing; what they leave is at most 3 (1 + 1) uF and (2 + 3) uF, 11 uF in all, and is put
/// together with three products and seven sums: 3 vF + 77 vF. With the data's 3 vF: within 96 vF.
template <bool fused>
[[gnu::always_inline]] inline Twofold dot(const Normal& n, const glm::dvec3& f) {
  const Twofold x = two_product<fused>(n.x.high, f.x), y = two_product<fused>(n.y.high, f.y),
                z = two_product<fused>(n.z.high, f.z);
  const Twofold xy = two_sum(x.high, y.high), xyz = two_sum(xy.high, z.high);
  const double low = (x.low + n.x.low * f.x) + (y.low + n.y.low * f.y) + (z.low + n.z.low * f.z);
  return two_sum(xyz.high, low + (xy.low + xyz.low));
}

/// a b - c d. Where neither product is above D: what the upper parts leave is 2 uD + 2 uD, the four products of an
/// upper and a lower part uD each, 8 uD in all, put together with four products and seven sums: 4 vD + 56 vD; two
/// products of lower parts are left out: within 64 vD.
template <bool fused>
[[gnu::always_inline]] inline Twofold minor(const Twofold& a, const Twofold& b, const Twofold& c, const Twofold& d) {
  const Twofold p = two_product<fused>(a.high, b.high), q = two_product<fused>(c.high, d.high);
  const Twofold s = two_sum(p.high, -q.high);
  const double low = (a.high * b.low + a.low * b.high) - (c.high * d.low + c.low * d.high);
  return two_sum(s.high, s.low + ((p.low - q.low) + low));
}

/// a / b, within 2^-100 of it: the difference from the first quotient's product is exact in its upper part (Sterbenz),
/// at most 5 u |a| in all, and four roundings of that, and of its quotient, are below 64 v.
template <bool fused>
[[gnu::always_inline]] inline Twofold quotient(const Twofold& a, const Twofold& b) {
  const double first = a.high / b.high;
  const Twofold p = two_product<fused>(first, b.high);
  return fast_sum(first, (((a.high - p.high) - p.low) + (a.low - first * b.low)) / b.high);
}

/// A line is l_f + (s - 1/2) l_r + (t - 1/2) l_u = 0 in the window, with l_f, l_r, l_u its normal's products with
/// forward, right and up. Two lines a, b meet where
///   (s - 1/2) : (t - 1/2) : 1 = a_u b_f - a_f b_u : a_f b_r - a_r b_f : a_r b_u - a_u b_r.
/// With F, R, U the largest components of the three vectors, products are at most 3 F, within 96 vF (see dot), and so
/// on. In the last minor no product is above 9 RU: with the data's 2 2 3 96 vRU and its own 64 9 vRU it is within 2^11
/// vRU = 2^-95 RU. The others alike: State::place_error.
struct SeenPlace {
  Twofold s{0, 0}, t{0, 0};                       // s - 1/2, t - 1/2
  double s_error = HUGE_VAL, t_error = HUGE_VAL;  // what they are within
};
template <bool fused>
[[gnu::always_inline]] inline SeenPlace seen_place(const State& s, const WindowLine& a, const WindowLine& b) {
  const Twofold depth = minor<fused>(a.right, b.up, a.up, b.right);
  const double depth_error = s.place_error[0], size_of_depth = std::abs(depth.high);
  if (!(size_of_depth > 2 * depth_error)) return {};
  SeenPlace place;
  const auto set = [&](Twofold & q, double& within, const Twofold& x, double error) __attribute__((always_inline)) {
    q = quotient<fused>(x, depth);
    const double size = std::abs(q.high);
    within = 4 * (error + size * depth_error) / size_of_depth + 0x1p-100 * size;
  };
  set(place.s, place.s_error, minor<fused>(a.up, b.forward, a.forward, b.up), s.place_error[1]);
  set(place.t, place.t_error, minor<fused>(a.forward, b.right, a.right, b.forward), s.place_error[2]);
  return place;
}

template <bool fused>
[[gnu::always_inline]] inline const WindowLine& window_line(State& s, SightlineId id) {
  std::uint32_t& at = s.window_line_of[id];
  if (at == none) {
    at = static_cast<std::uint32_t>(s.window_lines.size());
    const Normal n = normal(*s.table, id);
    s.window_lines.push_back({dot<fused>(n, s.frame[0]), dot<fused>(n, s.frame[1]), dot<fused>(n, s.frame[2])});
  }
  return s.window_lines[at];
}

/// The ray of a corner as a primitive integer vector.
std::array<Integer, 3> exact_ray(const State& s, CornerId c);

}  // namespace sightline::stitching
