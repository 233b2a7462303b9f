// A vector that needs no memory of its own while it is short. For this folder's own use.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace sightline {

template <class T, std::size_t N>
class ShortList {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  ShortList() = default;
  ShortList(const ShortList& other) { assign(other); }
  ShortList(ShortList&& other) noexcept { take(other); }
  ShortList& operator=(const ShortList& other) {
    if (this != &other) assign(other);
    return *this;
  }
  ShortList& operator=(ShortList&& other) noexcept {
    if (this != &other) take(other);
    return *this;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return more_ ? more_.get() : few_; }
  const T* data() const { return more_ ? more_.get() : few_; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t k) { return data()[k]; }
  const T& operator[](std::size_t k) const { return data()[k]; }
  T& back() { return data()[size_ - 1]; }

  void clear() { size_ = 0; }
  void push_back(const T& value) {
    if (size_ == room_) {
      const T kept = value;  // it may be one of ours
      grow(2 * room_);
      data()[size_++] = kept;
      return;
    }
    data()[size_++] = value;
  }
  void pop_back() { --size_; }

 private:
  void grow(std::size_t room) {
    auto more = std::make_unique<T[]>(room);
    std::copy(begin(), end(), more.get());
    more_ = std::move(more);
    room_ = room;
  }
  void assign(const ShortList& other) {
    size_ = 0;
    if (other.size_ > room_) grow(other.size_);
    std::copy(other.begin(), other.end(), data());
    size_ = other.size_;
  }
  void take(ShortList& other) {
    if (other.more_) {
      more_ = std::move(other.more_);
      room_ = other.room_;
      size_ = other.size_;
      other.room_ = N;
    } else {
      assign(other);
    }
    other.size_ = 0;
  }

  std::size_t size_ = 0, room_ = N;
  std::unique_ptr<T[]> more_;
  T few_[N];
};

}  // namespace sightline
