#include "sample/bitfield_forms.hpp"

#include <algorithm>
#include <roaring/roaring.hh>

namespace sightline {

HierarchicalBitfield::HierarchicalBitfield(const IdBitfield& field) : size_(field.size()) {
  // From the bits upwards: a level is all words, the next one a bit for each of them.
  std::vector<std::vector<std::uint64_t>> whole{{field.words().begin(), field.words().end()}};
  while (whole.back().size() > 1) {
    const auto& below = whole.back();
    std::vector<std::uint64_t> above((below.size() + 63) / 64);
    for (std::size_t k = 0; k < below.size(); ++k) {
      if (below[k] != 0) above[k / 64] |= std::uint64_t{1} << (k % 64);
    }
    whole.push_back(std::move(above));
  }
  levels_.resize(whole.size());
  for (std::size_t level = 0; level < whole.size(); ++level) {
    Level& kept = levels_[level];
    for (const std::uint64_t w : whole[whole.size() - 1 - level]) {
      if (w != 0) kept.words.push_back(w);
    }
    if (level == 0) continue;
    std::uint32_t children = 0;
    for (const std::uint64_t w : levels_[level - 1].words) {
      kept.before.push_back(children);
      children += static_cast<std::uint32_t>(std::popcount(w));
    }
  }
}

bool HierarchicalBitfield::test(std::uint32_t id) const {
  std::size_t at = 0;  // of the word to look into, among those kept of its level
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    const Level& here = levels_[level];
    if (at >= here.words.size()) return false;  // no bit at all is set
    // Bit `id` lies below bit (id / 64^(levels - 1 - level)) of this level.
    const auto drop = static_cast<unsigned>(6 * (levels_.size() - 1 - level));
    const std::uint32_t bit = (id >> drop) % 64;
    const std::uint64_t word = here.words[at];
    if ((word >> bit & 1) == 0) return false;
    if (level + 1 == levels_.size()) break;
    const std::uint64_t earlier = word & ((std::uint64_t{1} << bit) - 1);
    at = levels_[level + 1].before[at] + static_cast<std::uint32_t>(std::popcount(earlier));
  }
  return size_ > 0;
}

template <class Visit>
void HierarchicalBitfield::visit_words(Visit&& visit) const {
  if (levels_.empty() || levels_[0].words.empty()) return;
  std::vector<std::uint32_t> places{0}, next;  // of the kept words of a level, among all words of that level
  for (std::size_t level = 0; level + 1 < levels_.size(); ++level) {
    next.clear();
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (std::uint64_t w = levels_[level].words[k]; w != 0; w &= w - 1) {
        next.push_back(64 * places[k] + static_cast<std::uint32_t>(std::countr_zero(w)));
      }
    }
    places.swap(next);
  }
  for (std::size_t k = 0; k < places.size(); ++k) visit(places[k], levels_.back().words[k]);
}

std::uint32_t HierarchicalBitfield::count() const {
  int bits = 0;
  if (!levels_.empty()) {
    for (const std::uint64_t w : levels_.back().words) bits += std::popcount(w);
  }
  return static_cast<std::uint32_t>(bits);
}

void HierarchicalBitfield::join_into(IdBitfield& into) const {
  visit_words([&](std::uint32_t place, std::uint64_t word) { into.join_word(place, word); });
}

IdBitfield HierarchicalBitfield::plain() const {
  IdBitfield field(size_);
  join_into(field);
  return field;
}

std::size_t HierarchicalBitfield::bytes() const {
  std::size_t sum = 0;
  for (const Level& l : levels_)
    sum += l.words.size() * sizeof(std::uint64_t) + l.before.size() * sizeof(std::uint32_t);
  return sum;
}

struct CompressedBitfield::Bitmap {
  Roaring bits;
};

CompressedBitfield::CompressedBitfield() : bitmap_(std::make_unique<Bitmap>()) {}
CompressedBitfield::CompressedBitfield(const IdBitfield& field) : CompressedBitfield() {
  size_ = field.size();
  const std::vector<std::uint32_t> ids = field.list();
  bitmap_->bits.addMany(ids.size(), ids.data());
  bitmap_->bits.runOptimize();
  bitmap_->bits.shrinkToFit();
}
CompressedBitfield::~CompressedBitfield() = default;
CompressedBitfield::CompressedBitfield(CompressedBitfield&&) noexcept = default;
CompressedBitfield& CompressedBitfield::operator=(CompressedBitfield&&) noexcept = default;

bool CompressedBitfield::test(std::uint32_t id) const { return bitmap_->bits.contains(id); }
std::uint32_t CompressedBitfield::count() const { return static_cast<std::uint32_t>(bitmap_->bits.cardinality()); }
void CompressedBitfield::join(const CompressedBitfield& other) { bitmap_->bits |= other.bitmap_->bits; }

IdBitfield CompressedBitfield::plain() const {
  IdBitfield field(size_);
  std::vector<std::uint32_t> ids(count());
  bitmap_->bits.toUint32Array(ids.data());
  for (const std::uint32_t id : ids) field.set(id);
  return field;
}

std::size_t CompressedBitfield::bytes() const { return bitmap_->bits.getSizeInBytes(); }

}  // namespace sightline
