// Numbers out of binary files.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sightline {

/// The unsigned integer of `size` <= 8 bytes.
inline std::uint64_t load_bytes(const char* bytes, std::size_t size, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t place = big_endian ? size - 1 - k : k;
    value |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << (8 * place);
  }
  return value;
}

}  // namespace sightline
