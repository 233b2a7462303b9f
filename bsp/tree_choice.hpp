// Where to divide a node of a polygon tree.
#pragma once

#include "bsp/pieces.hpp"
#include "bsp/tree.hpp"

namespace sightline {

struct TreeCut {
  PlaneId plane = none;  // of a piece
  glm::dvec3 normal{0};  // or else normal.x = d, which no piece meets
  double d = 0;
};

/// Cuts that divide few pieces, leave both sides alike, and hide much; cuts in free space where there is room. Work is
/// linear in the pieces. Heuristic throughout: whatever it answers, the tree is right.
class TreeChoice {
 public:
  TreeChoice(const PlaneTable& planes, const Pieces& pieces) : planes_(planes), pieces_(pieces) {}
  TreeCut choose(std::span<const Piece> here, const TreeBox& box);

 private:
  struct Count {
    double behind = 0, front = 0, on = 0, split = 0, covered = 0;
  };
  Count count(std::span<const Piece> here, std::size_t stride, PlaneId plane) const;
  double cost(const Count& n, const TreeBox& box, PlaneId plane) const;
  void find_gap(std::span<const Piece> here, const glm::dvec3& normal, TreeCut& cut, double& least);
  void measure(std::span<const Piece> here, const glm::dvec3& normal);

  const PlaneTable& planes_;
  const Pieces& pieces_;
  std::vector<std::pair<double, PlaneId>> candidates_;
  struct Extent {
    double low, high;
  };
  std::vector<Extent> extents_;  // of the pieces, along a normal
  std::vector<std::uint32_t> enter_, leave_;
  std::vector<glm::dvec3> normals_;
};

}  // namespace sightline
