// One bit a polygon: which are seen. (Meruvia and Strothotte, section 1.)
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace sightline {

/// Laws. 1: join is commutative, associative and idempotent, and loses no bit. 2: list() is ascending and has count()
/// members; setting these gives the field back.
class IdBitfield {
 public:
  explicit IdBitfield(std::uint32_t size = 0) : size_(size), words_((std::size_t{size} + 63) / 64) {}

  std::uint32_t size() const { return size_; }
  void set(std::uint32_t id) { words_[id / 64] |= std::uint64_t{1} << (id % 64); }
  bool test(std::uint32_t id) const { return (words_[id / 64] >> (id % 64) & 1) != 0; }
  /// Sets all bits that are set in the other, which has the same size.
  void join(const IdBitfield& other) {
    for (std::size_t k = 0; k < words_.size(); ++k) words_[k] |= other.words_[k];
  }
  /// Sets the bits of one word; see words().
  void join_word(std::uint32_t place, std::uint64_t word) { words_[place] |= word; }
  std::uint32_t count() const {
    int bits = 0;
    for (const std::uint64_t w : words_) bits += std::popcount(w);
    return static_cast<std::uint32_t>(bits);
  }
  /// The set bits.
  std::vector<std::uint32_t> list() const {
    std::vector<std::uint32_t> ids;
    ids.reserve(count());
    for (std::uint32_t k = 0; k < words_.size(); ++k) {
      for (std::uint64_t w = words_[k]; w != 0; w &= w - 1) {
        ids.push_back(64 * k + static_cast<std::uint32_t>(std::countr_zero(w)));
      }
    }
    return ids;
  }
  /// Bit k is bit k % 64 of word k / 64; those beyond the size are 0.
  std::span<const std::uint64_t> words() const { return words_; }
  std::size_t bytes() const { return words_.size() * sizeof(std::uint64_t); }
  bool operator==(const IdBitfield&) const = default;

 private:
  std::uint32_t size_;
  std::vector<std::uint64_t> words_;
};

}  // namespace sightline
