// Files of tests.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace sightline::testing {

/// A file name of this process's own, removed at the end.
class TemporaryFile {
 public:
  TemporaryFile() {
    static int counter = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("sightline-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".wp");
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace sightline::testing
