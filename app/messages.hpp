// Standard error: messages, and a bar where a terminal watches.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace sightline::app {

/// One line on standard error, "sightline: TEXT"; control characters become spaces.
void complain(const std::string& text);
/// The same without the name, left out when quiet.
void tell(const std::string& text, bool quiet);

/// A bar on standard error, or a number where there is no total (0), drawn only on a terminal, at most ten times a
/// second.
class Progress {
 public:
  Progress(std::string what, std::size_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// One more is done; from any thread.
  void step();

 private:
  void draw(std::size_t done);

  std::string what_;
  std::size_t total_;
  bool shown_;
  std::atomic<std::size_t> done_ = 0;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace sightline::app
