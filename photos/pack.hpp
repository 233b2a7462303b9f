// Rectangles on pages. For this folder's own use.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sightline {

struct PackedRectangle {
  int width = 0, height = 0;  // given
  std::uint32_t page = 0;     // found
  int x = 0, y = 0;
};
struct PageSize {
  int width = 0, height = 0;
};

/// Places rectangles on pages of at most `most` pixels a side, in shelves, the highest first: no two overlap. No
/// rectangle may be larger than a page. The result depends on the sizes and their order alone.
std::vector<PageSize> pack(std::span<PackedRectangle> rectangles, int most);

}  // namespace sightline
