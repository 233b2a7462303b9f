// Finding boxes of a long list. Internal to beam/.
#pragma once

#include <vector>

#include "beam/frame.hpp"

namespace sightline {

/// What holds the boxes of a growing list, 16 and 256 at a time. Neighbours of the list should be neighbours in the
/// frame; boxes may shrink unnoticed.
class BoxGroups {
 public:
  void clear() {
    size_ = 0;
    small_.clear();
    large_.clear();
  }
  std::size_t size() const { return size_; }
  void push(const FrameBox& box) {
    add(small_, size_ % 16 == 0, box);
    add(large_, size_ % 256 == 0, box);
    ++size_;
  }
  /// The first box from k up to `end` that may meet `box`; `end` if there is none.
  std::size_t next(std::size_t k, std::size_t end, const FrameBox& box) const {
    while (k < end) {
      if (k % 256 == 0 && !large_[k / 256].meets(box)) {
        k += 256;
      } else if (k % 16 == 0 && !small_[k / 16].meets(box)) {
        k += 16;
      } else {
        return k;
      }
    }
    return end;
  }

 private:
  static void add(std::vector<FrameBox>& groups, bool begins, const FrameBox& box) {
    if (begins) {
      groups.push_back(box);
    } else {
      groups.back() = groups.back().around(box);
    }
  }

  std::vector<FrameBox> small_, large_;
  std::size_t size_ = 0;
};

}  // namespace sightline
