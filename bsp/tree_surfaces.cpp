#include "bsp/tree_surfaces.hpp"

#include <cmath>

namespace sightline {
namespace {

struct Bounds {
  glm::dvec3 low{INFINITY}, high{-INFINITY};
  void add(const glm::dvec3& p) {
    for (int k = 0; k < 3; ++k) {
      low[k] = p[k] < low[k] ? p[k] : low[k];
      high[k] = p[k] > high[k] ? p[k] : high[k];
    }
  }
};

}  // namespace

TreeSurfaces::TreeSurfaces(const Scene& scene)
    : scene_(scene),
      frame_(scene),
      box_(scene.surfaces().size()),
      turned_(frame_.turned() ? box_.size() : 0),
      spread_(box_.size()),
      block_((box_.size() + surface_block - 1) / surface_block),
      area_(std::make_unique<std::atomic<float>[]>(box_.size())) {
  find_bounds();
}

/// A polygon's corners bound its only surface, so that one look at them is enough; several surfaces lie within the
/// polygon each, and are bounded by their own.
void TreeSurfaces::find_bounds() {
  const auto surfaces = scene_.surfaces();
  const PointTable& points = scene_.points();
  for (SurfaceId s = 0, end; s < surfaces.size(); s = end) {
    const PolygonId polygon = surfaces[s].polygon;
    for (end = s + 1; end < surfaces.size() && surfaces[end].polygon == polygon;) ++end;
    Bounds whole;
    for (const PointId corner : scene_.corners(polygon)) whole.add(points.approx(corner));
    const auto spread = static_cast<float>(glm::length(whole.high - whole.low) * (1 + 0x1p-20) + 0x1p-40);
    std::fill(spread_.begin() + s, spread_.begin() + end, spread);
    TreeExtent& block = block_[s / surface_block];
    block.spread = std::max(block.spread, spread);
    if (end == s + 1) {
      box_[s].add(whole.low, whole.high);
      block.box.add(box_[s]);
    } else {
      find_bounds_of_parts(s, end);
    }
  }
  for (SurfaceId s = 0; s < turned_.size(); ++s) {
    Bounds turned;
    for_corners(s, [&](const glm::dvec3& p) { turned.add(frame_.of(p)); });
    turned_[s].add(turned.low, turned.high);
    block_[s / surface_block].along.add(turned_[s]);
  }
}

/// Of several surfaces of one polygon.
void TreeSurfaces::find_bounds_of_parts(SurfaceId first, SurfaceId end) {
  for (SurfaceId s = first; s < end; ++s) {
    Bounds own;
    for_corners(s, [&own](const glm::dvec3& p) { own.add(p); });
    box_[s].add(own.low, own.high);
    TreeExtent& block = block_[s / surface_block];
    block.box.add(box_[s]);
    block.spread = std::max(block.spread, spread_[s]);
  }
}

/// The corner that follows side k, where that is no point of the scene.
glm::dvec3 TreeSurfaces::meet(const Surface& surface, std::span<const SurfaceEdge> edges, std::size_t k) const {
  const SurfaceEdge& next = edges[k + 1 == edges.size() ? 0 : k + 1];
  return make_vertex(scene_.planes(), surface.plane, edges[k].wall, next.wall).approx;
}

bool TreeSurfaces::has_points(SurfaceId s) const {
  const auto edges = scene_.edges(scene_.surfaces()[s]);
  return std::none_of(edges.begin(), edges.end(), [](const SurfaceEdge& e) { return e.corner == none; });
}

float TreeSurfaces::area(SurfaceId s) const {
  float area = area_[s].load(std::memory_order_relaxed);
  if (area != 0) return area;
  glm::dvec3 from{0}, last{0}, sum{0};
  int seen = 0;
  for_corners(s, [&](const glm::dvec3& p) {
    if (seen == 0) from = p;
    if (seen > 1) sum += glm::cross(last - from, p - from);
    last = p;
    ++seen;
  });
  area = static_cast<float>(glm::length(sum) / 2);
  area_[s].store(area, std::memory_order_relaxed);
  return area;
}

}  // namespace sightline
