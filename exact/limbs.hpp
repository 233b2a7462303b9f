// Integers of any length at rest: two's complement 64-bit words in one arena.
#pragma once

#include "exact/types.hpp"

#include <vector>

namespace sightline {

/// A view of one stored integer: `count` little-endian two's complement words; `bits` is the bit length of its
/// magnitude (0 for zero).
struct Limbs {
  const std::uint64_t* words = nullptr;
  std::uint32_t count = 0;
  std::uint32_t bits = 0;
};

/// An append-only arena of integers, addressed by the order in which they were added.
class LimbStore {
 public:
  std::uint32_t add(const Integer& value);
  Limbs operator[](std::uint32_t index) const;
  Integer integer(std::uint32_t index) const;
  std::uint32_t size() const { return static_cast<std::uint32_t>(entries_.size()); }
  void clear();

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
