#include "photos/pack.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sightline {

std::vector<PageSize> pack(std::span<PackedRectangle> rectangles, int most) {
  std::vector<std::size_t> order(rectangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (rectangles[a].height != rectangles[b].height) return rectangles[a].height > rectangles[b].height;
    return rectangles[a].width > rectangles[b].width;
  });
  double area = 0;
  int widest = 1;
  for (const PackedRectangle& r : rectangles) {
    area += static_cast<double>(r.width) * r.height;
    widest = std::max(widest, r.width);
  }
  // About square, if one page is enough.
  const int width = std::clamp(static_cast<int>(std::min(std::sqrt(1.1 * area), 32767.0)), widest, std::max(most, 1));

  std::vector<PageSize> pages;
  int x = 0, y = 0, shelf = 0;
  for (const std::size_t k : order) {
    PackedRectangle& r = rectangles[k];
    if (!pages.empty() && x + r.width > width) {
      x = 0;
      y += shelf;
      shelf = 0;
    }
    if (pages.empty() || y + r.height > most) {
      pages.push_back({width, 0});
      x = y = shelf = 0;
    }
    r.page = static_cast<std::uint32_t>(pages.size() - 1);
    r.x = x;
    r.y = y;
    x += r.width;
    shelf = std::max(shelf, r.height);
    pages.back().height = std::max(pages.back().height, y + r.height);
  }
  return pages;
}

}  // namespace sightline
