// Random numbers that are the same on every platform.
#pragma once

#include <cstdint>

namespace sightline::models {

/// SplitMix64 (Steele, Lea, Flood 2014): small, and any seed will do.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// From 0 to bound - 1; bound > 0.
  int below(int bound) { return static_cast<int>((next() >> 32) * static_cast<std::uint64_t>(bound) >> 32); }
  /// From lowest to highest, both included.
  int between(int lowest, int highest) { return lowest + below(highest - lowest + 1); }
  /// True in `part` of `whole` cases.
  bool chance(int part, int whole) { return below(whole) < part; }

 private:
  std::uint64_t state_;
};

}  // namespace sightline::models
