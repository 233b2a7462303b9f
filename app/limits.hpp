// What the command may take of the machine.
#pragma once

#include <cstdint>

namespace CLI {
class App;
}

namespace sightline::app {

struct LimitOptions {
  std::uint64_t memory = 0;  // bytes of data: heap and the like; 0: no limit
  double seconds = 0;        // of wall time; 0: no limit
};

/// --max-memory and --timeout.
void add_limit_options(CLI::App& command, LimitOptions& options);

/// From now on the process that runs out of memory ends with exit code 5, wherever that happens: in the command, in GMP
/// or in a worker thread.
void watch_memory();

/// Sets the limits; child processes inherit that of memory. `threads`: whose stacks do not count. Throws UsageError.
void apply(const LimitOptions& options, unsigned threads);

}  // namespace sightline::app
