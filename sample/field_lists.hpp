// Lists of cells, each held once. For the building of fields.
#pragma once

#include "sample/field.hpp"

#include <unordered_map>

namespace sightline {

/// Adds to a field's lists; the field must outlive it, and none of its lists be added otherwise.
class FieldLists {
 public:
  explicit FieldLists(Field& field);
  /// The number of the list with these members, ascending. Throws std::length_error.
  std::uint32_t number(std::span<const std::uint32_t> members);

 private:
  Field& field_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> by_hash_;
};

/// Adds the mipmaps above the first level.
void add_mipmaps(Field& field);

}  // namespace sightline
