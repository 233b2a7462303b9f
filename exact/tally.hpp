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

/// The calling thread's own counter.
Tally& tally();
/// Sum over all threads, those that have ended included.
Tally tally_total();

}  // namespace sightline
