// A tree of boxes around the surfaces of a scene: which of them reach into a convex volume. For this folder's own use.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace sightline {

/// n.x > d inside, in unit coordinates; rounded, and off by less than `slack` over the unit box.
struct RoughPlane {
  glm::dvec3 n;
  double d, slack;
};

class BoxTree {
 public:
  explicit BoxTree(const Scene& scene);
  /// Planes beyond the first 32 are not looked at. Appends, ascending, every surface that has a point inside of all
  /// planes, and others near them.
  void find(std::span<const RoughPlane> volume, std::vector<SurfaceId>& found) const;
  std::size_t bytes() const {
    return boxes_.size() * sizeof(boxes_[0]) + order_.size() * sizeof(order_[0]) + nodes_.size() * sizeof(nodes_[0]);
  }

 private:
  struct Box {
    glm::dvec3 middle{0}, half{0};
  };
  struct Node {
    Box box;
    std::uint32_t first, count;  // of surfaces, in order_; 0: children at first and first + 1
  };
  void divide(std::size_t node, std::size_t begin, std::size_t end);

  std::vector<Box> boxes_;  // by surface
  std::vector<SurfaceId> order_;
  std::vector<Node> nodes_;
};

}  // namespace sightline
