// Interruption without half files.
#pragma once

#include <sys/types.h>

namespace sightline::app {

/// From now on SIGINT and SIGTERM end the process with exit code 128 + signal (130 for Ctrl-C), but only when no file
/// is being written. Call before any other thread starts. A second signal ends it at once.
void watch_interrupts();

/// A child process to which the signal is passed on; 0: none.
void set_interrupted_child(pid_t child);

/// While one exists, an interruption waits. Once interrupted, making another one blocks until the process ends.
class Writing {
 public:
  Writing();
  ~Writing();
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;
};

}  // namespace sightline::app
