// Integers of any length at rest: two's complement 64-bit words in one arena.
#pragma once

#include "exact/types.hpp"

#include <bit>
#include <vector>

namespace sightline {

/// A view of one stored integer: `count` little-endian two's complement words; `bits` is the bit length of its
/// magnitude (0 for zero).
struct Limbs {
  const std::uint64_t* words = nullptr;
  std::uint32_t count = 0;
  std::uint32_t bits = 0;
};

/// Words that hold every integer whose magnitude has this many bits.
constexpr std::uint32_t words_for(std::uint32_t bits) { return bits / 64 + 1; }
/// Bit length of the magnitude of `count` >= 1 two's complement words.
inline std::uint32_t magnitude_bits(std::int64_t x) {
  const auto u = static_cast<std::uint64_t>(x);
  return static_cast<std::uint32_t>(std::bit_width(x < 0 ? 0 - u : u));
}
std::uint32_t long_magnitude_bits(const std::uint64_t* words, std::uint32_t count);
inline std::uint32_t magnitude_bits(const std::uint64_t* words, std::uint32_t count) {
  if (count == 1) return magnitude_bits(static_cast<std::int64_t>(words[0]));
  // A number that begins with neither a word of zeros nor one of ones, as most do, has the length of what begins it: a
  // negative one only if it is no power of two, which the words below would tell.
  const std::uint64_t top = words[count - 1];
  if (static_cast<std::int64_t>(top) > 0) return 64 * (count - 1) + static_cast<std::uint32_t>(std::bit_width(top));
  return long_magnitude_bits(words, count);
}
std::uint32_t magnitude_bits(const Integer& x);
/// Writes x as `count` two's complement words; it must fit.
void store_words(const Integer& x, std::uint64_t* words, std::uint32_t count);
Integer load_integer(const std::uint64_t* words, std::uint32_t count);
void load_integer(Integer& to, const std::uint64_t* words, std::uint32_t count);
inline Sign sign_of_words(const std::uint64_t* words, std::uint32_t count) {
  if (static_cast<std::int64_t>(words[count - 1]) < 0) return -1;
  std::uint64_t any = 0;
  for (std::uint32_t i = 0; i < count; ++i) any |= words[i];
  return any != 0;
}
/// value * 2^exponent to the nearest double, ties to even (below the normal range, rounded twice).
double long_words_to_double(const std::uint64_t* words, std::uint32_t count, int exponent);
inline double words_to_double(const std::uint64_t* words, std::uint32_t count, int exponent) {
  if (count > 1 || exponent < -1000 || exponent > 900) return long_words_to_double(words, count, exponent);
  // A power of two within the normal range, and a product within it: rounded only once, by the conversion.
  const auto power = std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
  return static_cast<double>(static_cast<std::int64_t>(words[0])) * power;
}

/// An append-only arena of integers, addressed by the order in which they were added.
class LimbStore {
 public:
  std::uint32_t add(const Integer& value);
  Limbs operator[](std::uint32_t index) const;
  Integer integer(std::uint32_t index) const;
  std::uint32_t size() const { return static_cast<std::uint32_t>(entries_.size()); }
  void clear();

  std::size_t bytes() const { return words_.size() * sizeof(words_[0]) + entries_.size() * sizeof(Entry); }

 private:
  struct Entry {
    std::uint64_t first;
    std::uint32_t count;
    std::uint32_t bits;
  };
  std::vector<std::uint64_t> words_;
  std::vector<Entry> entries_;
};

}  // namespace sightline
