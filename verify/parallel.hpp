// Loops over several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sightline::verify {

/// Calls body(worker, i) for i from 0 to count - 1, worker from 0 to threads - 1; rethrows the first exception.
template <class Body>
void parallel_for(unsigned threads, std::size_t count, Body&& body) {
  constexpr std::size_t chunk = 64;
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex lock;
  const auto work = [&](unsigned worker) {
    try {
      for (std::size_t first = next.fetch_add(chunk); first < count; first = next.fetch_add(chunk)) {
        for (std::size_t i = first; i < std::min(first + chunk, count); ++i) body(worker, i);
      }
    } catch (...) {
      const std::scoped_lock hold(lock);
      failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others;
  for (unsigned worker = 1; worker < threads; ++worker) others.emplace_back(work, worker);
  work(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sightline::verify
