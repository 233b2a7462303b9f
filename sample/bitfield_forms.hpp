// Bitfields that take less room or less time where whole stretches of them are empty. (Meruvia and Strothotte,
// section 5.)
#pragma once

#include "sample/bitfield.hpp"

#include <memory>

namespace sightline {

/// Words that are zero are not kept, nor words of the level above, which has a bit for every word, and so on up to a
/// single word: what is empty is passed over at once.
///
/// Laws. 1: plain() of what was made of a field is that field. 2: test, count and join are those of the plain field.
class HierarchicalBitfield {
 public:
  HierarchicalBitfield() = default;
  explicit HierarchicalBitfield(const IdBitfield& field);

  std::uint32_t size() const { return size_; }
  bool test(std::uint32_t id) const;
  std::uint32_t count() const;
  /// Sets the field's bits in `into`, which has the same size.
  void join_into(IdBitfield& into) const;
  IdBitfield plain() const;
  std::size_t bytes() const;

 private:
  /// The words of a level that are not zero, in order; `before[k]` of them stand before the children of the k-th word
  /// that is kept one level above.
  struct Level {
    std::vector<std::uint64_t> words;
    std::vector<std::uint32_t> before;
  };
  template <class Visit>
  void visit_words(Visit&& visit) const;

  std::uint32_t size_ = 0;
  std::vector<Level> levels_;  // from the single word down to the bits themselves
};

/// CRoaring: per 65,536 bits a list, bits or runs, whichever is the shortest. Same laws.
class CompressedBitfield {
 public:
  CompressedBitfield();
  explicit CompressedBitfield(const IdBitfield& field);
  ~CompressedBitfield();
  CompressedBitfield(CompressedBitfield&&) noexcept;
  CompressedBitfield& operator=(CompressedBitfield&&) noexcept;

  std::uint32_t size() const { return size_; }
  bool test(std::uint32_t id) const;
  std::uint32_t count() const;
  /// Of fields of the same size.
  void join(const CompressedBitfield& other);
  IdBitfield plain() const;
  /// As it would be written.
  std::size_t bytes() const;

 private:
  struct Bitmap;
  std::uint32_t size_ = 0;
  std::unique_ptr<Bitmap> bitmap_;
};

}  // namespace sightline
