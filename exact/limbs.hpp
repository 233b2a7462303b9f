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
std::uint32_t magnitude_bits(const std::uint64_t* words, std::uint32_t count);
inline std::uint32_t magnitude_bits(std::int64_t x) {
  const auto u = static_cast<std::uint64_t>(x);
  return static_cast<std::uint32_t>(std::bit_width(x < 0 ? 0 - u : u));
}
std::uint32_t magnitude_bits(const Integer& x);
/// Writes x as `count` two's complement words; it must fit.
void store_words(const Integer& x, std::uint64_t* words, std::uint32_t count);
Integer load_integer(const std::uint64_t* words, std::uint32_t count);
void load_integer(Integer& to, const std::uint64_t* words, std::uint32_t count);
Sign sign_of_words(const std::uint64_t* words, std::uint32_t count);
/// value * 2^exponent to the nearest double, ties to even (below the normal range, rounded twice).
double words_to_double(const std::uint64_t* words, std::uint32_t count, int exponent);

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
