#include "sample/field_lists.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace sightline {
namespace {

std::uint64_t hash_of(std::span<const std::uint32_t> members) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::uint32_t m : members) hash = (hash ^ m) * 0x100000001b3 + (hash >> 29);
  return hash;
}

/// The cells of up to 16 samples together.
class Merger {
 public:
  Merger(Field& field, FieldLists& lists) : field_(field), lists_(lists) {}

  std::uint32_t merged(std::vector<std::uint32_t>& below) {
    std::ranges::sort(below);
    below.erase(std::unique(below.begin(), below.end()), below.end());
    if (below.size() == 1) return below.front();
    members_.clear();
    for (const std::uint32_t k : below) {
      const auto list = field_.list(k);
      members_.insert(members_.end(), list.begin(), list.end());
    }
    std::ranges::sort(members_);
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
    return lists_.number(members_);
  }

 private:
  Field& field_;
  FieldLists& lists_;
  std::vector<std::uint32_t> members_;
};

FieldLevel level_above(const FieldLevel& below, std::size_t slabs, Merger& merger) {
  FieldLevel level;
  for (std::size_t k = 0; k < 4; ++k) level.size[k] = (below.size[k] + 1) / 2;
  level.lists.reserve(slabs * level.samples_of_slab());
  std::vector<std::uint32_t> parts;
  const auto [U, V, S, T] = level.size;
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    for (std::uint32_t u = 0; u < U; ++u) {
      for (std::uint32_t v = 0; v < V; ++v) {
        for (std::uint32_t t = 0; t < T; ++t) {
          for (std::uint32_t s = 0; s < S; ++s) {
            parts.clear();
            for (unsigned k = 0; k < 16; ++k) {
              const std::array<std::uint32_t, 4> at{2 * u + (k & 1U), 2 * v + (k >> 1U & 1U), 2 * s + (k >> 2U & 1U),
                                                    2 * t + (k >> 3U)};
              bool there = true;
              for (std::size_t axis = 0; axis < 4; ++axis) there = there && at[axis] < below.size[axis];
              if (there) parts.push_back(below.lists[below.place(slab, at)]);
            }
            level.lists.push_back(merger.merged(parts));
          }
        }
      }
    }
  }
  return level;
}

}  // namespace

FieldLists::FieldLists(Field& field) : field_(field) {
  if (field_.list_count() == 0) field_.first.push_back(0);  // the empty one
  for (std::uint32_t k = 0; k < field_.list_count(); ++k) by_hash_.emplace(hash_of(field_.list(k)), k);
}

std::uint32_t FieldLists::number(std::span<const std::uint32_t> members) {
  const std::uint64_t hash = hash_of(members);
  for (auto [k, end] = by_hash_.equal_range(hash); k != end; ++k) {
    if (std::ranges::equal(field_.list(k->second), members)) return k->second;
  }
  if (field_.members.size() + members.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("the lists of the field's samples");
  }
  const auto number = static_cast<std::uint32_t>(field_.list_count());
  field_.members.insert(field_.members.end(), members.begin(), members.end());
  field_.first.push_back(static_cast<std::uint32_t>(field_.members.size()));
  by_hash_.emplace(hash, number);
  return number;
}

void add_mipmaps(Field& field) {
  FieldLists lists(field);
  Merger merger(field, lists);
  while (field.levels.back().samples_of_slab() > 1) {
    field.levels.push_back(level_above(field.levels.back(), field.slabs.size(), merger));
  }
}

}  // namespace sightline
