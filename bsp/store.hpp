// Objects that never move.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

namespace sightline {

/// Hands out objects, one after the other; they live as long as the store.
template <class T>
class Store {
 public:
  T* take(std::size_t count) {
    if (used_ + count > size_) {
      size_ = std::max(count, std::clamp<std::size_t>(2 * size_, 64, 4096));
      used_ = 0;
      blocks_.push_back(std::make_unique<T[]>(size_));
      bytes_ += size_ * sizeof(T);
    }
    used_ += count;
    return blocks_.back().get() + used_ - count;
  }
  std::size_t bytes() const { return bytes_; }

 private:
  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t used_ = 0, size_ = 0, bytes_ = 0;
};

}  // namespace sightline
