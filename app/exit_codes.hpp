// How the command ends.
#pragma once

#include <stdexcept>
#include <string>
#include <system_error>

namespace sightline::app {

enum Exit : int { done = 0, internal_error = 1, wrong_usage = 2, bad_input = 3, some_failed = 4, limit_reached = 5 };

/// The command line asks for what cannot be: what() is one line (exit code 2).
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or folder that cannot be written: what() is one line (exit code 3).
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const std::string& what, std::error_code why = {}) : std::runtime_error(what), why_(why) {}
  /// Does a folder stand where the file would? Then others beside it may be written all the same.
  bool of_this_file() const { return why_ == std::errc::is_a_directory; }

 private:
  std::error_code why_;
};

}  // namespace sightline::app
