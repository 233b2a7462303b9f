// Where to cut a cell.
#pragma once

#include "bsp/pieces.hpp"
#include "bsp/weights.hpp"

namespace sightline {

struct Choice {
  PlaneId plane = none;  // of a piece
  int axis = -1;         // or a cut in free space at this grid coordinate
  Integer value;
};

/// The box of a cell or a little more, unit coordinates, rounded.
struct Bounds {
  glm::dvec3 low, high;
};

/// Naylor's expected-case view: planes of pieces that hide much, cut little, and leave few pieces where many sightlines
/// go (a side is met in proportion to its surface); above a size also cuts in free space. Heuristic throughout:
/// whatever it answers, the complex is right.
class Chooser {
 public:
  Chooser(const Scene& scene, const PlaneTable& planes, const Pieces& pieces, const ChoiceWeights& weights)
      : scene_(scene), planes_(planes), pieces_(pieces), weights_(weights) {}
  /// `pieces` is not empty; `cell` bounds their cell. With `free_space` false only planes of pieces are considered.
  Choice choose(std::span<Piece> pieces, const Bounds& cell, bool free_space);

 private:
  struct Count {
    double behind = 0, front = 0, on = 0;
    double split = 0;    // one a hair beside the plane counts in part
    double within = 0;   // pieces a hair beside
    double covered = 0;  // area of those on the plane
  };
  /// A plane across an axis; none: not one of a piece, but free space.
  struct AxisCut {
    double value;
    PlaneId plane;
    Count count;
  };
  double area(Piece& piece) const;
  void add_hair(Count& n, const Piece& piece, PlaneId plane) const;
  Count count_plane(std::span<Piece> pieces, PlaneId plane) const;
  void count_axes(std::span<Piece> pieces);
  void add_candidates(std::span<Piece> pieces);
  void sort_candidates();
  void add_middles(std::span<Piece> pieces);
  double cost(const Count& count, std::size_t total, const Bounds& cell, const double n[3], double d) const;
  Integer on_grid(double value) const;

  const Scene& scene_;
  const PlaneTable& planes_;
  const Pieces& pieces_;
  ChoiceWeights weights_;
  std::vector<PlaneId> candidates_;                     // planes of pieces; in the end those across no axis
  std::vector<AxisCut> cuts_[3];                        // by axis, ascending by value when they are counted
  std::vector<double> values_[3];                       // of cuts_
  std::vector<std::uint32_t> in_front_[3], behind_[3];  // pieces by the place among cuts_ of what they lie behind of
  std::vector<double> middles_;
};

}  // namespace sightline
