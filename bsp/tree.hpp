// A binary space partition with polygons at its nodes and no cells: all that an order from the eye outwards needs.
#pragma once

#include <atomic>
#include <memory>
#include <span>

#include "scene/scene.hpp"

namespace sightline {

/// A side of a piece: of the scene's edge or diagonal a-b, directed counter-clockwise seen from the front of the
/// piece's plane, or, where a is `none`, of the line in which a cutting plane meets the piece's plane.
struct TreeEdge {
  PointId a, b;
  PlaneId cut;  // of a cut: the cutting plane
  Sign inside;  // of a cut: the side of it on which the piece lies
};

/// A box in unit coordinates that holds what it bounds, rounding included.
struct TreeBox {
  glm::dvec3 middle, half;
};

/// Where a side of a piece begins, within 2^-48 in unit coordinates; the scene's point there, if it is one.
struct TreeCorner {
  glm::dvec3 at;
  PointId point;
};

/// A convex part of a surface: side k runs from corner k to the next.
struct TreePiece {
  SurfaceId surface;
  std::uint32_t count;  // of sides
  const TreeEdge* edge;
  const TreeCorner* corner;
  TreeBox box;
  std::span<const TreeEdge> edges() const { return {edge, count}; }
  std::span<const TreeCorner> corners() const { return {corner, count}; }
};

/// Pieces of a node that share a box, so that they can be passed over together.
inline constexpr std::size_t tree_group = 8;

/// A node parts space by a plane: that of its pieces, or one in free space that meets no piece at all.
struct TreeNode {
  TreeBox box;           // of all pieces in it and below it
  float spread = 0;      // at least the diagonal of the bounding box of every polygon with a piece in it or below it
  PlaneId plane = none;  // none: normal.x = d, in free space, exactly as the doubles say
  glm::dvec3 normal{0};
  double d = 0;
  std::span<const TreePiece> pieces;  // in the plane, ascending by surface
  std::span<const TreeBox> groups;    // of `tree_group` pieces each; none where one would do
  TreeNode* child[2] = {};            // behind the plane and in front; null: nothing there
  std::atomic<bool> ready = false;    // whether it has been divided: what stands above but the box holds from then on
  std::uint32_t waiting = 0;          // until then: the tree's own note of what waits here
};

struct TreeOptions {
  bool lazy = false;     // divide a node when it is first asked for
  unsigned threads = 1;  // that divide a tree which is not lazy; the tree is the same for any number
};

/// Fuchs, Kedem and Naylor's tree. Every piece of the scene's surfaces lies at exactly one node; polygons that cross a
/// node's plane are cut by it, exactly. Any number of threads may read a tree, lazy or not; which nodes have been
/// divided depends on what was asked for, what they hold does not.
class BspTree {
 public:
  /// The scene must outlive the tree.
  explicit BspTree(const Scene& scene, const TreeOptions& options = {});
  ~BspTree();
  BspTree(BspTree&&) noexcept;
  BspTree& operator=(BspTree&&) noexcept;

  const Scene& scene() const;
  /// Null for a scene without polygons. Whoever goes below a node calls `open` first.
  TreeNode* root() const;
  void open(TreeNode& node) const {
    if (!node.ready.load(std::memory_order_acquire)) divide(node);
  }
  /// Nodes divided so far, pieces at them, and bytes held.
  struct Size {
    std::size_t nodes = 0, pieces = 0, bytes = 0;
  };
  Size size() const;

 private:
  void divide(TreeNode& node) const;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sightline
