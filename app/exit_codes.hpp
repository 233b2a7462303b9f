// How the command ends.
#pragma once

#include <stdexcept>

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
  using std::runtime_error::runtime_error;
};

}  // namespace sightline::app
