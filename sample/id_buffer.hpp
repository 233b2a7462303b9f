// An ID buffer as graphics hardware makes it: polygons rasterised one after the other, the nearest kept at the middle
// of each pixel, depths in floats. (Meruvia and Strothotte, ID-bitfields, section 1.)
#pragma once

#include "sample/places.hpp"
#include "scene/camera.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sightline {

/// Made for one scene, which must outlive it; drawn view after view, on one thread.
class IdBuffer {
 public:
  IdBuffer(const Scene& scene, std::uint32_t size);

  /// Which polygon each of size * size pixels shows, or `none`. Pixel (x, y), at y * size + x, is the square of side
  /// 1 / size from (x, y) / size in the window; rows go upwards. Valid until the next call. `wanted` has an entry a
  /// polygon: where it is 0 the polygon is left out; empty, all are drawn.
  std::span<const PolygonId> draw(const Camera& camera, std::span<const char> wanted = {});
  std::uint32_t size() const { return size_; }
  /// Memory: of the pixels and of the polygons as they are drawn.
  std::size_t bytes() const;

 private:
  void clip(int side);
  void fill(PolygonId polygon);

  const Scene& scene_;
  Places places_;
  std::uint32_t size_;
  std::vector<PolygonId> items_;
  std::vector<float> nearest_;  // inverse depths; 0: nothing yet
  std::vector<glm::dvec3> loop_, spare_;
};

}  // namespace sightline
