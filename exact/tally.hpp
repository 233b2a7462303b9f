// Which stage decided: counted, printed in reports, asserted by tests.
#pragma once

#include <array>
#include <cstdint>

namespace sightline {

/// Counts of decisions by the stage that made them.
struct Tally {
  static constexpr std::array<int, 9> widths{64, 128, 192, 256, 384, 512, 768, 1024, 0};  // 0: any length
  std::uint64_t identity = 0;
  std::uint64_t filter = 0;
  std::array<std::uint64_t, widths.size()> exact{};
  Tally& operator+=(const Tally& o);
  Tally operator-(const Tally& o) const;
};

namespace tally_detail {
struct ThreadTally {
  Tally counts;
  bool registered = false;
};
extern constinit thread_local ThreadTally of_this_thread;
void register_thread();
}  // namespace tally_detail

/// The calling thread's own counter.
inline Tally& tally() {
  if (!tally_detail::of_this_thread.registered) [[unlikely]]
    tally_detail::register_thread();
  return tally_detail::of_this_thread.counts;
}
/// Sum over all threads, those that have ended included. Complete when no other thread is deciding at the time.
Tally tally_total();

}  // namespace sightline
