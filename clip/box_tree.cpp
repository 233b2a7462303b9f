#include "clip/box_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

#include "exact/predicates.hpp"

namespace sightline {
namespace {

constexpr std::uint32_t leaf = 4;

}  // namespace

BoxTree::BoxTree(const Scene& scene) : boxes_(scene.surfaces().size()), order_(scene.surfaces().size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  for (SurfaceId s = 0; s < boxes_.size(); ++s) {
    const Surface& surface = scene.surfaces()[s];
    const auto edges = scene.edges(surface);
    glm::dvec3 low{1}, high{-1};
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const glm::dvec3 at = edges[k].corner != none ? scene.points().approx(edges[k].corner)
                                                    : make_vertex(scene.planes(), surface.plane, edges[k].wall,
                                                                  edges[k + 1 == edges.size() ? 0 : k + 1].wall)
                                                          .approx;
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
    // Corners are within 2^-48 of their doubles.
    boxes_[s] = {(low + high) * 0.5, (high - low) * 0.5 + 0x1p-47};
  }
  if (boxes_.empty()) return;
  nodes_.push_back({});
  divide(0, 0, order_.size());
}

void BoxTree::divide(std::size_t node, std::size_t begin, std::size_t end) {
  glm::dvec3 low{1}, high{-1}, low_middle{1}, high_middle{-1};
  for (std::size_t k = begin; k < end; ++k) {
    const Box& b = boxes_[order_[k]];
    low = glm::min(low, b.middle - b.half);
    high = glm::max(high, b.middle + b.half);
    low_middle = glm::min(low_middle, b.middle);
    high_middle = glm::max(high_middle, b.middle);
  }
  nodes_[node].box = {(low + high) * 0.5, (high - low) * 0.5 + 0x1p-50};
  if (end - begin <= leaf) {
    nodes_[node].first = static_cast<std::uint32_t>(begin);
    nodes_[node].count = static_cast<std::uint32_t>(end - begin);
    return;
  }
  const glm::dvec3 extent = high_middle - low_middle;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::size_t middle = (begin + end) / 2;
  std::nth_element(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                   order_.begin() + static_cast<std::ptrdiff_t>(middle),
                   order_.begin() + static_cast<std::ptrdiff_t>(end), [&](SurfaceId a, SurfaceId b) {
                     const double x = boxes_[a].middle[axis], y = boxes_[b].middle[axis];
                     return x < y || (x == y && a < b);
                   });
  const std::size_t child = nodes_.size();
  nodes_[node].first = static_cast<std::uint32_t>(child);
  nodes_[node].count = 0;
  nodes_.push_back({});
  nodes_.push_back({});
  divide(child, begin, middle);
  divide(child + 1, middle, end);
}

void BoxTree::find(std::span<const RoughPlane> volume, std::vector<SurfaceId>& found) const {
  if (nodes_.empty()) return;
  const std::size_t before = found.size();
  // Planes that a box is inside of need not be looked at again below it: a bit each.
  struct Open {
    std::uint32_t node, planes;
  };
  const std::uint32_t every = volume.size() >= 32 ? ~0u : (1u << volume.size()) - 1;
  std::vector<Open> open{{0, every}};
  const auto away = [&](const Box& box, std::uint32_t& planes) {
    for (std::uint32_t left = planes; left != 0; left &= left - 1) {
      const RoughPlane& p = volume[static_cast<std::size_t>(std::countr_zero(left))];
      const double reach =
          std::abs(p.n.x) * box.half.x + std::abs(p.n.y) * box.half.y + std::abs(p.n.z) * box.half.z;
      const double value = p.n.x * box.middle.x + p.n.y * box.middle.y + p.n.z * box.middle.z - p.d;
      if (value + reach < -p.slack) return true;
      if (value - reach > p.slack) planes &= ~(left & (0u - left));
    }
    return false;
  };
  while (!open.empty()) {
    auto [at, planes] = open.back();
    open.pop_back();
    const Node& node = nodes_[at];
    if (away(node.box, planes)) continue;
    if (node.count == 0) {
      open.push_back({node.first, planes});
      open.push_back({node.first + 1, planes});
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      std::uint32_t own = planes;
      if (!away(boxes_[order_[k]], own)) found.push_back(order_[k]);
    }
  }
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
}

}  // namespace sightline
