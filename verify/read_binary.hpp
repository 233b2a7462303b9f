// Numbers out of binary files.
#pragma once

#include "verify/read.hpp"

#include <bit>
#include <cstring>

namespace sightline::verify {

/// Walks over bytes of either order; throws InputError where the file ends too early.
class Bytes {
 public:
  Bytes(const std::string& file, std::string_view bytes, bool big_endian)
      : file_(file), bytes_(bytes), swap_(big_endian == (std::endian::native == std::endian::little)) {}
  template <class T>
  T next() {
    if (bytes_.size() - at_ < sizeof(T)) throw InputError(file_ + ": ends too early");
    char raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) raw[swap_ ? sizeof(T) - 1 - i : i] = bytes_[at_ + i];
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }
  void skip(std::size_t count) {
    if (bytes_.size() - at_ < count) throw InputError(file_ + ": ends too early");
    at_ += count;
  }

 private:
  std::string file_;
  std::string_view bytes_;
  bool swap_;
  std::size_t at_ = 0;
};

}  // namespace sightline::verify
