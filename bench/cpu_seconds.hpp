// The clock of the benchmarks.
#pragma once

#include <ctime>

namespace sightline {

/// The thread's own processor time: on a shared machine the wall clock measures the neighbours as well.
inline double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace sightline
