// Long integers by their first bits: a filter between doubles and all of them. For this folder's own use.
#pragma once

#include "exact/limbs.hpp"
#include "exact/types.hpp"

namespace sightline {

/// Where doubles do not tell, but their exact numbers are long: first the leading 62 bits of the components, then the
/// leading 125. On a building turned by rounded numbers what is asked is mostly about hairs, 2^-48 to 2^-60 of the
/// whole: the first tell three fifths of it, the second nearly all the rest.
inline constexpr std::uint32_t leading_bits = 125, word_bits = 62;

/// The leading 125 bits of three components of one length, rounded down: high * 2^63 + low. The high words by
/// themselves are the leading 62.
struct LeadingBits {
  std::int64_t high[3];
  std::int64_t low[3];  // not negative

  LeadingBits() = default;
  /// Of components of `bits` bits at most, words_for(bits) words each.
  LeadingBits(const std::uint64_t* words, std::uint32_t bits) {
    const std::uint32_t stride = words_for(bits);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint64_t* const w = words + k * stride;
      if (bits > leading_bits) {
        const std::uint32_t first = (bits - leading_bits) / 64, shift = (bits - leading_bits) % 64;
        // Where there is no next word the sign fills up. Two shifts, since by 64 there is none.
        const std::uint64_t above = first + 2 < stride ? w[first + 2] : sign_word(w[first + 1]);
        set(k, (w[first] >> shift) | (w[first + 1] << 1 << (63 - shift)),
            (w[first + 1] >> shift) | (above << 1 << (63 - shift)));
      } else {
        const auto above = static_cast<unsigned __int128>(stride > 1 ? w[1] : sign_word(w[0]));
        const unsigned __int128 shifted = (above << 64 | w[0]) << (leading_bits - bits);
        set(k, static_cast<std::uint64_t>(shifted), static_cast<std::uint64_t>(shifted >> 64));
      }
    }
  }

 private:
  static std::uint64_t sign_word(std::uint64_t top) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(top) >> 63);
  }
  void set(std::uint32_t k, std::uint64_t lower, std::uint64_t upper) {
    high[k] = static_cast<std::int64_t>((upper << 1) | (lower >> 63));
    low[k] = static_cast<std::int64_t>(lower << 1 >> 1);
  }
};

namespace leading_detail {
inline __int128 product(std::int64_t a, std::int64_t b) { return static_cast<__int128>(a) * b; }
inline Sign beyond(__int128 value, int bit) {
  const __int128 bound = static_cast<__int128>(1) << bit;
  return value > bound ? 1 : value < -bound ? -1 : uncertain;
}
}  // namespace leading_detail

/// The sign of det(a, b, c) by leading words, if they tell.
inline Sign leading_order_short(const LeadingBits& a, const LeadingBits& b, const LeadingBits& c) {
  using leading_detail::product;
  // With w = 2^62 above all components, each less than 1 too small: a minor has two products below w^2, each within
  // 2w + 1, so it is below 2w^2 and within 4w + 2; over w, rounded down, below 2w and within 6. Times c: below 2w^2,
  // and within 6w + 2w + 6; the three together below 6w^2 < 2^127 and within 24w + 18 < 32w.
  const auto minor = [&](int i, int j) {
    return static_cast<std::int64_t>((product(a.high[i], b.high[j]) - product(a.high[j], b.high[i])) >> word_bits);
  };
  return leading_detail::beyond(
      product(minor(1, 2), c.high[0]) + product(minor(2, 0), c.high[1]) + product(minor(0, 1), c.high[2]),
      word_bits + 5);
}

/// The sign of det(a, b, c) by all leading bits, if they tell.
inline Sign leading_order(const LeadingBits& a, const LeadingBits& b, const LeadingBits& c) {
  using leading_detail::product;
  // Components are below 2^125 and less than 1 too small: two products, each within 2^126 + 1. In units of 2^126: high
  // by high, below 2^125 together, and 2^-63 of high by low, four of them below 2^127 together. Left out is low by low,
  // within 1, and what the shift drops, below 1: a minor is below 2^126 and within 2 + 1 + 1 and a little, less than 5.
  const auto minor = [&](int i, int j) {
    const __int128 across = product(a.high[i], b.low[j]) + product(a.low[i], b.high[j]) - product(a.high[j], b.low[i]) -
                            product(a.low[j], b.high[i]);
    return product(a.high[i], b.high[j]) - product(a.high[j], b.high[i]) + (across >> 63);
  };
  // The same once more, the minor in two: high below 2^62 + 2, and low. In units of 2^252 the three products are off by
  // 3 (5 * 2^125 + 2^126 + 5) / 2^126 < 12; left out is low by low, up to 1 each, and below 1 by each shift: 17 in all.
  __int128 sum = 0, first = 0, second = 0;
  const auto add = [&](__int128 m, int k) {
    const auto high = static_cast<std::int64_t>(m >> 63);
    const auto low = static_cast<std::int64_t>(static_cast<std::uint64_t>(m) << 1 >> 1);
    sum += product(high, c.high[k]);
    first += product(high, c.low[k]);
    second += product(low, c.high[k]);
  };
  add(minor(1, 2), 0);
  add(minor(2, 0), 1);
  add(minor(0, 1), 2);
  return leading_detail::beyond(sum + (first >> 63) + (second >> 63), 5);
}

/// The sign of the product of two vectors by leading words, if they tell.
inline Sign leading_dot(const std::int64_t* a, const std::int64_t* b) {
  using leading_detail::product;
  // As above: three products below w^2, each within 2w + 1; together within 6w + 3 < 8w.
  return leading_detail::beyond(product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2]), word_bits + 3);
}

/// Do leading bits tell that a and b are not parallel?
inline bool leading_apart(const LeadingBits& a, const LeadingBits& b) {
  using leading_detail::product;
  const auto apart = [&](int i, int j) {
    // Minors as above: of words within 4w + 2 < 8w, of all bits within 5.
    const __int128 words = product(a.high[i], b.high[j]) - product(a.high[j], b.high[i]);
    if (leading_detail::beyond(words, word_bits + 3) != uncertain) return true;
    const __int128 across = product(a.high[i], b.low[j]) + product(a.low[i], b.high[j]) - product(a.high[j], b.low[i]) -
                            product(a.low[j], b.high[i]);
    return leading_detail::beyond(words + (across >> 63), 3) != uncertain;
  };
  return apart(1, 2) || apart(2, 0) || apart(0, 1);
}

}  // namespace sightline
