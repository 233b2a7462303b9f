#include "clip/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace sightline {
namespace {

constexpr std::uint32_t leaf = 8;

}  // namespace

PointTree::PointTree(std::span<const glm::dvec3> points) : points_(points), order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!points.empty()) divide(0, 0, static_cast<std::uint32_t>(points.size()));
}

void PointTree::divide(std::size_t node, std::uint32_t first, std::uint32_t count) {
  if (nodes_.size() <= node) nodes_.resize(node + 1);
  glm::dvec3 low = points_[order_[first]], high = low;
  for (std::uint32_t k = first; k < first + count; ++k) {
    low = glm::min(low, points_[order_[k]]);
    high = glm::max(high, points_[order_[k]]);
  }
  // Halves first: a sum of two large numbers may be too large.
  nodes_[node] = {low * 0.5 + high * 0.5, high * 0.5 - low * 0.5, first, count};
  if (count <= leaf) return;
  const glm::dvec3 extent = nodes_[node].half;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
  std::nth_element(begin, begin + count / 2, begin + count,
                   [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
  divide(2 * node + 1, first, count / 2);
  divide(2 * node + 2, first + count / 2, count - count / 2);
}

/// A box and a segment are apart where they are along an axis, or across the segment and an axis. Numbers that are too
/// large for that keep nothing apart. With u = 2^-53 and M the largest coordinate, `doubt` is 16 uM at least: places,
/// and the middles and halves made of them, are off by less than 4 uM each, differences by less than 8 uM. So where
/// d = half (true numbers) the product below is off by less than 8 uM size + 4 uM |d| with three roundings of products
/// of numbers up to 2M, 6 uM size: with |d| below the first test's bound, all of that is below doubt (size + reach).
void PointTree::near(const glm::dvec3& from, const glm::dvec3& to, double doubt,
                     std::vector<std::uint32_t>& found) const {
  const glm::dvec3 middle = from * 0.5 + to * 0.5, half = to * 0.5 - from * 0.5, size = glm::abs(half) + doubt;
  const auto away = [&](const glm::dvec3& at, const glm::dvec3& box) {
    const glm::dvec3 d = at - middle, reach = box + 4 * doubt;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      if (std::abs(d[k]) > reach[k] + size[k]) return true;
      if (std::abs(d[i] * half[j] - d[j] * half[i]) > size[j] * reach[i] + size[i] * reach[j]) return true;
    }
    return false;
  };
  std::vector<std::size_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    const Node& node = nodes_[at];
    if (away(node.middle, node.half)) continue;
    if (node.count > leaf) {
      open.push_back(2 * at + 1);
      open.push_back(2 * at + 2);
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      if (!away(points_[order_[k]], glm::dvec3{0})) found.push_back(order_[k]);
    }
  }
}

}  // namespace sightline
