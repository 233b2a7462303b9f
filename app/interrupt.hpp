// The process ends before its work is done, and leaves no half file.
#pragma once

#include <sys/types.h>

namespace sightline::app {

/// From now on SIGINT and SIGTERM end the process with exit code 128 + signal (130 for Ctrl-C), as end_process does; a
/// second signal ends it at once. Call before any other thread starts.
void watch_interrupts();

/// Ends it so many seconds from now with exit code 5. After watch_interrupts; more than 0, at most 1e9.
void limit_time(double seconds);

/// Ends the process from any thread, with this line on standard error: once no other thread is writing a file, or after
/// two seconds, and then the temporary files go. The first to call it wins. Allocates nothing.
[[noreturn]] void end_process(int exit_code, const char* line) noexcept;

/// A child process that is ended with this one; 0: none.
void set_interrupted_child(pid_t child);

/// While one exists, an end that comes early waits. Once it has come, making another one blocks until it is over.
class Writing {
 public:
  Writing();
  ~Writing();
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;
};

}  // namespace sightline::app
