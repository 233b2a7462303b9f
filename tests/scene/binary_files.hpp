// Small binary files for the tests of readers.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace sightline::test {

inline void put(std::string& to, std::uint64_t word, std::size_t size, bool big_endian = false) {
  for (std::size_t k = 0; k < size; ++k) {
    to += static_cast<char>(word >> (8 * (big_endian ? size - 1 - k : k)) & 0xff);
  }
}
inline void put_real(std::string& to, float value, bool big_endian = false) {
  put(to, std::bit_cast<std::uint32_t>(value), 4, big_endian);
}
inline void put_real(std::string& to, double value, bool big_endian = false) {
  put(to, std::bit_cast<std::uint64_t>(value), 8, big_endian);
}

/// Two facets: (0,0,0) (1,0,0) (0,1,0) and (0,0,0.1f) (1,0,0.1f) (0,1,0.1f).
inline std::string binary_stl() {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // as some programs write it
  put(bytes, 2, 4);
  for (const float height : {0.0f, 0.1f}) {
    for (const float x : {0.0f, 0.0f, 1.0f, 0.0f, 0.0f, height, 1.0f, 0.0f, height, 0.0f, 1.0f, height})
      put_real(bytes, x);
    put(bytes, 0, 2);
  }
  return bytes;
}

/// Four vertices (double, with a colour behind) and a square of them, a pentagon's worth of other data between.
inline std::string binary_ply(bool big_endian) {
  std::string bytes = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                      "_endian 1.0\ncomment by hand\nelement vertex 4\nproperty double x\nproperty float y\n"
                      "property short z\nproperty uchar red\nelement extra 1\nproperty list uchar ushort data\n"
                      "element face 1\nproperty int flags\nproperty list uint16 int32 vertex_index\nend_header\n";
  const double x[] = {0.1, 1.25, 1.25, 0.1};
  const float y[] = {0.1f, 0.1f, 2.5f, 2.5f};
  for (int k = 0; k < 4; ++k) {
    put_real(bytes, x[k], big_endian);
    put_real(bytes, y[k], big_endian);
    put(bytes, static_cast<std::uint16_t>(-7), 2, big_endian);
    put(bytes, 255, 1, big_endian);
  }
  put(bytes, 3, 1, big_endian);
  for (int k = 0; k < 3; ++k) put(bytes, 9, 2, big_endian);
  put(bytes, 0xffffffffu, 4, big_endian);
  put(bytes, 4, 2, big_endian);
  for (const std::uint64_t k : {3, 2, 1, 0}) put(bytes, k, 4, big_endian);
  return bytes;
}

}  // namespace sightline::test
