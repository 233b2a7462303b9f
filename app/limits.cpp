#include "app/limits.hpp"

#include "app/exit_codes.hpp"
#include "app/interrupt.hpp"

#include <gmp.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace sightline::app {

namespace {

char memory_line[120] = "sightline: out of memory\n";

[[noreturn]] void out_of_memory() { end_process(limit_reached, memory_line); }

// GMP's own functions abort where there is no memory.
void* allocate(std::size_t bytes) {
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) out_of_memory();
  return memory;
}
void* reallocate(void* old, std::size_t, std::size_t bytes) {
  void* const memory = std::realloc(old, bytes);
  if (memory == nullptr) out_of_memory();
  return memory;
}
void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void add_limit_options(CLI::App& command, LimitOptions& options) {
  command
      .add_option("--max-memory", options.memory, "End with exit code 5 when more memory is needed: 500M, 2G (of 1024)")
      ->transform(CLI::AsSizeValue(false))
      ->check(CLI::PositiveNumber)
      ->type_name("SIZE");
  command.add_option("--timeout", options.seconds, "End with exit code 5 after so many seconds")
      ->check(CLI::Range(0.001, 1e9))
      ->type_name("SECONDS");
}

void watch_memory() {
  // Not std::bad_alloc: that would be one camera's failure, or meet code that cannot let it pass.
  std::set_new_handler(out_of_memory);
  mp_set_memory_functions(allocate, reallocate, release);
}

void apply(const LimitOptions& options, unsigned threads) {
  if (std::isnan(options.seconds)) throw UsageError("--timeout: not a number");
  if (options.memory != 0) {
    std::snprintf(memory_line, sizeof memory_line,
                  "sightline: the limit of %llu bytes of memory is reached (--max-memory)\n",
                  static_cast<unsigned long long>(options.memory));
    // Linux counts private writable memory: the stacks of threads (workers and the one that waits for signals, not the
    // main thread) at their full size, whatever they use of it.
    rlimit stack{};
    getrlimit(RLIMIT_STACK, &stack);
    const rlim_t stacks = std::min<rlim_t>(stack.rlim_cur, rlim_t{64} << 20) * threads;
    rlimit data{};
    getrlimit(RLIMIT_DATA, &data);
    const rlim_t wanted = options.memory > RLIM_INFINITY / 2 ? RLIM_INFINITY : options.memory + stacks;
    data.rlim_cur = std::min(wanted, data.rlim_max);
    setrlimit(RLIMIT_DATA, &data);
  }
  if (options.seconds > 0) limit_time(options.seconds);
}

}  // namespace sightline::app
