// What writing and reading of field files have in common.
#pragma once

#include "sample/field.hpp"

#include <string_view>

namespace sightline {

inline constexpr std::string_view field_file_line = "sightline-field 1\n";
/// The longest run of equal samples: longer ones are several, so that no file is much smaller than what it becomes in
/// memory, and its size bounds what reading it takes.
inline constexpr std::size_t longest_field_run = 1024;

/// FNV-1a, 64 bits.
inline std::uint64_t field_checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return sum;
}

}  // namespace sightline
