#include "verify/edge_tree.hpp"

#include <algorithm>
#include <numeric>

namespace sightline::verify {

EdgeTree::EdgeTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes_.empty()) return;
  nodes_.reserve(boxes_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(order_.size()));
}

void EdgeTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t last) {
  Box box, centres;
  for (std::uint32_t i = first; i < last; ++i) {
    const Box& b = boxes_[order_[i]];
    box.add(b);
    centres.add({b.s0 + b.s1, b.t0 + b.t1, b.s0 + b.s1, b.t0 + b.t1});
  }
  nodes_[node].box = box;
  if (last - first <= 4) {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  const bool wide = centres.s1 - centres.s0 >= centres.t1 - centres.t0;
  const std::uint32_t half = first + (last - first) / 2;  // in halves by number: the depth is below 32
  const auto key = [&](std::uint32_t e) { return wide ? boxes_[e].s0 + boxes_[e].s1 : boxes_[e].t0 + boxes_[e].t1; };
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.emplace_back();
  nodes_[node].first = child;
  build(child, first, half);
  build(child + 1, half, last);
}

void EdgeTree::set_values(const std::vector<double>& of_edge) {
  for (std::size_t k = nodes_.size(); k-- > 0;) {  // children stand after their parents
    Node& node = nodes_[k];
    if (node.count == 0) {
      node.least = std::min(nodes_[node.first].least, nodes_[node.first + 1].least);
    } else {
      node.least = std::numeric_limits<double>::infinity();
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        node.least = std::min(node.least, of_edge[order_[i]]);
      }
    }
  }
}

}  // namespace sightline::verify
