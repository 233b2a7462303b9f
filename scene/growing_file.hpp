// A file that gets its name when it is complete.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace sightline {

/// Grows under a temporary name beside its own and is renamed by finish(); without that it is gone. A terminal, a pipe
/// or another device cannot be replaced by renaming: it is written to. All throws std::system_error.
class GrowingFile {
 public:
  explicit GrowingFile(const std::filesystem::path& file);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void append(std::string_view content);
  /// Nothing can be appended any more.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sightline
