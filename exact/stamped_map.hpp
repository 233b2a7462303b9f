// A multimap from 64-bit keys to 32-bit values that forgets everything in constant time.
#pragma once

#include <cstdint>
#include <vector>

namespace sightline {

/// Open addressing, linear probing; `clear` only counts a stamp up, so buffers are kept. Values may have equal keys.
class StampedMap {
 public:
  void clear() {
    count_ = 0;
    if (++stamp_ == 0) {  // the stamps have come round: forget by hand
      for (Slot& s : slots_) s.stamp = 0;
      stamp_ = 1;
    }
  }

  /// Calls visit(value) for the values of the key until it returns true; false if it never did.
  template <class Visit>
  bool find(std::uint64_t key, Visit&& visit) const {
    if (slots_.empty()) return false;
    for (std::size_t i = place(key);; i = (i + 1) & (slots_.size() - 1)) {
      const Slot& s = slots_[i];
      if (s.stamp != stamp_) return false;
      if (s.key == key && visit(s.value)) return true;
    }
  }

  /// The value of the key; if it has none, that of make(), which must leave the map alone, and from now on the key has
  /// it.
  template <class Make>
  std::uint32_t get(std::uint64_t key, Make&& make) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    std::size_t i = place(key);
    for (; slots_[i].stamp == stamp_; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].key == key) return slots_[i].value;
    }
    const std::uint32_t value = make();
    slots_[i] = {key, value, stamp_};
    ++count_;
    return value;
  }

  /// Calls visit(value) for the values of the key until it returns true; if it never did, the key has one value more.
  template <class Visit>
  bool find_or_insert(std::uint64_t key, std::uint32_t value, Visit&& visit) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    std::size_t i = place(key);
    for (; slots_[i].stamp == stamp_; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].key == key && visit(slots_[i].value)) return true;
    }
    slots_[i] = {key, value, stamp_};
    ++count_;
    return false;
  }

  void insert(std::uint64_t key, std::uint32_t value) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    put({key, value, stamp_});
    ++count_;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t value = 0;
    std::uint32_t stamp = 0;
  };

  std::size_t place(std::uint64_t key) const {
    const std::uint64_t h = (key ^ (key >> 32)) * 0x9e3779b97f4a7c15u;
    return (h ^ (h >> 32)) & (slots_.size() - 1);
  }
  void put(const Slot& slot) {
    std::size_t i = place(slot.key);
    while (slots_[i].stamp == stamp_) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = slot;
  }
  void grow() {
    std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& s : old)
      if (s.stamp == stamp_) put(s);
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
  std::uint32_t stamp_ = 1;
};

}  // namespace sightline
