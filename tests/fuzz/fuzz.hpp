// What the harnesses share. A harness is one file with LLVMFuzzerTestOneInput: a fuzzer calls it, and so does
// replay.cpp with the inputs kept in tests/corpus/fuzz.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace sightline::fuzz {

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process, naming what is not so: the input is a finding.
[[noreturn]] void fault(const std::string& what);
inline void expect(bool so, const char* what) {
  if (!so) fault(what);
}

/// A message for the user is one line of printable characters.
void expect_one_line(const std::string& message);

/// Where a reader wants a file: this process's own, written anew for each input and gone with the process.
std::filesystem::path as_file(std::string_view content, const char* ending);

}  // namespace sightline::fuzz
