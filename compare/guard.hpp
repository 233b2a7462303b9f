// Work that may loop for ever or crash, done in a process of its own. For this folder's own use.
#pragma once

#include <functional>
#include <string>

namespace sightline::comparison {

struct Limits {
  double seconds = 60;    // of processor time
  double gigabytes = 12;  // of address space beyond this process's
};

/// How it ended: `why` is empty where it did as it should, and `bytes` is what it returned.
struct Guarded {
  std::string bytes, why;
};

/// Calls `work` in a child process that ends at the limits, and hands back what it returns. Whatever it does to memory
/// stays there.
Guarded run_guarded(const std::function<std::string()>& work, const Limits& limits);

}  // namespace sightline::comparison
