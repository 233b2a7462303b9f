// Work in several threads at once. For this folder's own use.
#pragma once

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sightline {

/// Runs the worker in that many threads at once; rethrows what the first to fail has thrown.
template <class Worker>
void in_threads(unsigned threads, const Worker& worker) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      worker();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned t = 1; t < threads; ++t) others.emplace_back(guarded);
    guarded();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sightline
