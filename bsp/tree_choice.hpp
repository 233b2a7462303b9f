// Where to divide a node of a polygon tree.
#pragma once

#include "bsp/tree_parts.hpp"

namespace sightline {

struct TreeCut {
  PlaneId plane = none;  // of a part
  int axis = -1;         // or else this direction of the frame, and how far along it: nothing reaches there
  double d = 0;
};

/// Cuts that divide few pieces, leave both sides alike, and hide much; cuts in free space where there is room. Work is
/// linear in the parts. Heuristic throughout: whatever it answers, the tree is right.
class TreeChoice {
 public:
  TreeChoice(const PlaneTable& planes, const TreeParts& parts) : planes_(planes), parts_(parts) {}
  /// `along` bounds the parts along the frame. Deterministic, by the parts and their order alone.
  TreeCut choose(std::span<const TreePart> here, const RoundedBox& along);

 private:
  static constexpr std::size_t counted = 192;       // parts on which planes are judged
  static constexpr std::size_t sorted_up_to = 256;  // parts among which gaps are found one by one
  struct Count {
    double behind = 0, front = 0, on = 0, split = 0, covered = 0;
  };
  void take_sample(std::span<const TreePart> here);
  void take_corners(std::span<const TreePart> here);
  void choose_candidates();
  Count count(std::span<const TreePart> here, PlaneId plane, const glm::dvec3& normal);
  void count_corners(Count& n, const ApproxPlane& plane) const;
  double cost(const Count& n, const glm::dvec3& normal, double d) const;
  void find_gaps(std::span<const TreePart> here, TreeCut& cut, double& least);
  void find_wide_gaps(std::span<const TreePart> here, std::size_t step, TreeCut& cut, double& least);
  void find_narrow_gaps(std::span<const TreePart> here, TreeCut& cut, double& least);
  bool covered(int axis, std::size_t count) const;
  void judge(int axis, double at, double before, double total, TreeCut& cut, double& least) const;

  const PlaneTable& planes_;
  const TreeParts& parts_;
  RoundedBox box_;  // along the frame, of all parts
  glm::dvec3 extent_{0}, middle_of_all_{0};
  double surface_of_all_ = 0;
  // The sample, in arrays that the compiler can work through four or eight at a time.
  std::size_t size_ = 0, step_ = 1;
  float middle_[3][counted], half_[3][counted], area_[counted];
  PlaneId plane_[counted];
  std::int32_t sides_[counted];  // by the latest plane: bit 0 behind, bit 1 in front, bit 2 in it
  bool cornered_ = false;
  std::vector<double> corner_[3];  // of the sample, in fours
  std::uint32_t first_corner_[counted + 1] = {};
  std::vector<std::pair<float, PlaneId>> candidates_;
  std::int32_t low_[3][sorted_up_to], high_[3][sorted_up_to];  // bounds along an axis, in an order of floats
  std::vector<std::uint64_t> extents_;
  std::vector<std::uint32_t> bins_;
};

}  // namespace sightline
