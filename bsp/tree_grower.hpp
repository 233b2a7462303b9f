// Divides nodes of a polygon tree.
#pragma once

#include "bsp/store.hpp"
#include "bsp/tree.hpp"
#include "bsp/tree_choice.hpp"

namespace sightline {

/// Whoever divides nodes has one; what it has made lives as long as it does. What comes of a node depends on its load
/// alone, not on who divides it, or when.
class TreeGrower {
 public:
  explicit TreeGrower(const TreeSurfaces& wholes)
      : scene_(wholes.scene()), parts_(wholes), choice_(wholes.scene().planes(), parts_) {}

  /// All surfaces of the scene, at the root; null for none.
  TreeNode* plant(TreeLoad& load);
  /// Divides the node; what waits at its children comes back. The caller says that the node is ready.
  void divide(TreeNode& node, TreeLoad& load, TreeLoad below[2]);
  /// Divides the node and all below it.
  void grow(TreeNode& node, TreeLoad& load);
  /// Of what it has made.
  BspTree::Size size() const {
    return {nodes_divided_, pieces_kept_,
            nodes_.bytes() + kept_.bytes() + edges_.bytes() + corners_.bytes() + boxes_.bytes()};
  }

 private:
  std::size_t part(TreeNode& node, std::span<TreePart> here, const RoundedBox& along);
  std::size_t part_by_plane(std::span<TreePart> here, PlaneId plane);
  std::size_t part_in_gap(std::span<TreePart> here, int axis, double d);
  template <class Side, class Place>
  void part_blocks(std::span<TreePart> here, std::size_t& behind, Side&& side, Place&& place);
  TreeNode* node_of(std::size_t count, TreeExtent& extent);
  void order(std::span<TreePart> parts);
  void keep(TreeNode& node);
  void keep_edges(TreePart part, TreePiece& out);

  const Scene& scene_;
  TreeParts parts_;
  TreeChoice choice_;
  std::vector<TreePart> on_, front_, waiting_;
  TreeExtent extent_[2];  // of the children of the latest node
  Store<TreeNode> nodes_;
  Store<TreePiece> kept_;
  Store<TreeEdge> edges_;
  Store<TreeCorner> corners_;
  Store<TreeBox> boxes_;
  std::size_t nodes_divided_ = 0, pieces_kept_ = 0;
};

}  // namespace sightline
