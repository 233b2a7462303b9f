// Points near a line segment. For this folder's own use.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include <cstdint>

namespace sightline {

/// A tree of boxes around points.
class PointTree {
 public:
  explicit PointTree(std::span<const glm::dvec3> points);
  /// Appends, in any order, all points that are within `doubt` of the segment by coordinate, and others near it.
  void near(const glm::dvec3& from, const glm::dvec3& to, double doubt, std::vector<std::uint32_t>& found) const;

 private:
  struct Node {
    glm::dvec3 middle{0}, half{0};
    std::uint32_t first, count;  // in order_; children, if it has any, are 2k + 1 and 2k + 2
  };
  void divide(std::size_t node, std::uint32_t first, std::uint32_t count);

  std::span<const glm::dvec3> points_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace sightline
