#include "photos/pixel_owners.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "visibility_map/locate.hpp"

namespace sightline {

namespace {

/// A place is s * width for an s within 2^-54 of the exact one, 1 - t likewise: with at most 2^15 pixels the product is
/// within 2^-37 of the true place, and so is the segment between two such places of the true edge. A crossing with a
/// border of a row is found in four roundings of numbers below 2^15, so to within 2^-35. The margin is far more.
constexpr double margin = 0x1p-20;

class Mask {
 public:
  Mask(int width, int height)
      : width_(width), height_(height), set_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {}

  bool at(int i, int j) const { return set_[index(i, j)] != 0; }
  /// All pixels whose closed square is within the margin of the segment.
  void mark(glm::dvec2 a, glm::dvec2 b) {
    if (a.y > b.y) std::swap(a, b);
    const int last = row(b.y + margin);
    for (int j = row(a.y - margin); j <= last; ++j) {
      const double x0 = crossing(a, b, j - margin), x1 = crossing(a, b, j + 1 + margin);
      const int end = column(std::max(x0, x1) + margin);
      for (int i = column(std::min(x0, x1) - margin); i <= end; ++i) set_[index(i, j)] = 1;
    }
  }
  /// Everything within so many pixels of what is marked, too.
  void grow(int pixels) {
    if (pixels == 0) return;
    grow_along(pixels, width_, height_, 1, width_);
    grow_along(pixels, height_, width_, width_, 1);
  }
  void add(const Mask& other) {
    for (std::size_t k = 0; k < set_.size(); ++k) set_[k] = static_cast<char>(set_[k] | other.set_[k]);
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i);
  }
  int row(double y) const { return static_cast<int>(std::floor(std::clamp(y, 0.0, height_ - 0.5))); }
  int column(double x) const { return static_cast<int>(std::floor(std::clamp(x, 0.0, width_ - 0.5))); }
  /// x where the segment is at y, or at its end nearest to y.
  static double crossing(const glm::dvec2& a, const glm::dvec2& b, double y) {
    if (y <= a.y) return a.x;
    if (y >= b.y) return b.x;
    return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
  }
  void grow_along(int pixels, int length, int lines, int step, int across) {
    std::vector<char> old(static_cast<std::size_t>(length));
    for (int line = 0; line < lines; ++line) {
      char* const first = set_.data() + std::ptrdiff_t{line} * across;
      for (int k = 0; k < length; ++k) old[static_cast<std::size_t>(k)] = first[std::ptrdiff_t{k} * step];
      int until = -1;  // the last to be marked because of what lies before
      for (int k = 0; k < std::min(pixels, length); ++k) {
        if (old[static_cast<std::size_t>(k)]) until = k + pixels;
      }
      for (int k = 0; k < length; ++k) {
        if (k + pixels < length && old[static_cast<std::size_t>(k + pixels)]) until = k + 2 * pixels;
        if (k <= until) first[std::ptrdiff_t{k} * step] = 1;
      }
    }
  }

  int width_, height_;
  std::vector<char> set_;
};

/// Is the pixel's square wholly inside the region? Coordinates are rounded, by less than a photograph is calibrated.
bool inside(const TextureRegion& region, const glm::dvec2& low, const glm::dvec2& high) {
  const std::size_t n = region.points.size();
  glm::dvec2 least(region.points[0]), most(region.points[0]);
  double area = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2 &p = region.points[k], &q = region.points[(k + 1) % n];
    area += p.x * q.y - p.y * q.x;
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
  // Of two convex figures that do not overlap, a side of one separates them.
  bool all_inside = true, apart = least.x >= high.x || most.x <= low.x || least.y >= high.y || most.y <= low.y;
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2 &p = region.points[k], &q = region.points[(k + 1) % n];
    bool on_left = true, on_right = true;  // or on the side itself
    for (const glm::dvec2& c : {low, glm::dvec2(high.x, low.y), high, glm::dvec2(low.x, high.y)}) {
      const double left = (q.x - p.x) * (c.y - p.y) - (q.y - p.y) * (c.x - p.x);
      on_left = on_left && left >= 0;
      on_right = on_right && left <= 0;
    }
    all_inside = all_inside && (area > 0 ? on_left : on_right);
    apart = apart || (area > 0 ? on_right : on_left);
  }
  return region.interior ? all_inside : apart;
}

void restrict_to(std::span<const TextureRegion> regions, PixelOwners& owners) {
  if (regions.empty()) return;
  for (int j = 0; j < owners.height; ++j) {
    for (int i = 0; i < owners.width; ++i) {
      const glm::dvec2 low(static_cast<double>(i) / owners.width, 1 - static_cast<double>(j + 1) / owners.height);
      const glm::dvec2 high(static_cast<double>(i + 1) / owners.width, 1 - static_cast<double>(j) / owners.height);
      const bool used = std::ranges::all_of(regions, [&](const TextureRegion& r) { return inside(r, low, high); });
      if (!used) {
        owners.polygon[static_cast<std::size_t>(j) * static_cast<std::size_t>(owners.width) +
                       static_cast<std::size_t>(i)] = none;
      }
    }
  }
}

}  // namespace

PixelOwners pixel_owners(const VisibilityMap& map, const Scene& scene, int width, int height, int guard,
                         std::span<const TextureRegion> regions) {
  if (width < 1 || height < 1 || width > 32767 || height > 32767 || guard < 0) {
    throw std::invalid_argument("a photograph's sides must be from 1 to 32767 pixels, its guard 0 or more");
  }
  Mask mixed(width, height), silhouettes(width, height);
  const auto place = [&](std::uint32_t vertex) {
    const glm::dvec2& st = map.vertices[vertex].st;
    return glm::dvec2(st.x * width, (1 - st.y) * height);
  };
  for (const MapEdge& edge : map.edges) {
    if (edge.kind == EdgeKind::window) continue;
    Mask& mask = edge.kind == EdgeKind::silhouette ? silhouettes : mixed;
    mask.mark(place(edge.vertex[0]), place(edge.vertex[1]));
  }
  if (guard > 0) silhouettes.grow(guard - 1);
  mixed.add(silhouettes);

  const Locator locator(map, scene);
  const auto seen = [&](int i, int j) {
    const std::uint32_t face = locator.face_at({(i + 0.5) / width, 1 - (j + 0.5) / height});
    return face == none ? none : map.faces[face].polygon;
  };
  PixelOwners owners{width, height, {}};
  owners.polygon.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int j = 0; j < height; ++j) {
    bool in_run = false;  // of pixels that no edge touches: all show the same
    for (int i = 0; i < width; ++i) {
      if (!mixed.at(i, j)) {
        owners.polygon.push_back(in_run ? owners.polygon.back() : seen(i, j));
        in_run = true;
      } else {
        owners.polygon.push_back(guard > 0 ? none : seen(i, j));
        in_run = false;
      }
    }
  }
  restrict_to(regions, owners);
  return owners;
}

}  // namespace sightline
