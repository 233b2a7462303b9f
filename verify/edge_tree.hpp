// Boxes around the edges of a map, in a binary tree.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace sightline::verify {

/// A rectangle of the window that certainly holds what it is said to hold.
struct Box {
  double s0 = std::numeric_limits<double>::infinity(), t0 = s0, s1 = -s0, t1 = -s0;
  void add(const Box& b) {
    s0 = b.s0 < s0 ? b.s0 : s0;
    t0 = b.t0 < t0 ? b.t0 : t0;
    s1 = b.s1 > s1 ? b.s1 : s1;
    t1 = b.t1 > t1 ? b.t1 : t1;
  }
  bool meets(const Box& b) const { return s0 <= b.s1 && b.s0 <= s1 && t0 <= b.t1 && b.t0 <= t1; }
};

class EdgeTree {
 public:
  EdgeTree() = default;
  explicit EdgeTree(std::vector<Box> boxes);

  const Box& box(std::uint32_t edge) const { return boxes_[edge]; }
  /// Gives each edge a value, each node the least of its edges.
  void set_values(const std::vector<double>& of_edge);

  /// Calls leaf(edge) for every edge below nodes for which enter(box, least value) holds; the edge's own box is not
  /// looked at. Stops and returns false as soon as leaf does.
  template <class Enter, class Leaf>
  bool visit(Enter&& enter, Leaf&& leaf) const {
    std::uint32_t stack[64];
    int depth = 0;
    if (!nodes_.empty()) stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!enter(node.box, node.least)) continue;
      if (node.count == 0) {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
      } else {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
          if (!leaf(order_[i])) return false;
        }
      }
    }
    return true;
  }

 private:
  struct Node {
    Box box;
    double least = -std::numeric_limits<double>::infinity();
    std::uint32_t first = 0, count = 0;  // edges of a leaf in order_; else the first of two children
  };
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last);

  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace sightline::verify
