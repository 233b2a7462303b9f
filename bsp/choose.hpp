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
  Choice choose(std::span<const Piece> pieces, const Bounds& cell, bool free_space);

 private:
  struct Candidate {
    PlaneId plane;
    double area;
  };
  struct Count {
    double behind = 0, front = 0, on = 0;
    double split = 0;    // one a hair beside the plane counts in part
    double covered = 0;  // area of those on the plane
  };
  void add_hair(Count& n, const Piece& piece, PlaneId plane) const;
  Count count_plane(std::span<const Piece> pieces, PlaneId plane) const;
  Count count_axis(std::span<const Piece> pieces, PlaneId plane, int axis, double value) const;
  double cost(const Count& count, std::size_t total, const Bounds& cell, const double n[3], double d) const;

  const Scene& scene_;
  const PlaneTable& planes_;
  const Pieces& pieces_;
  ChoiceWeights weights_;
  std::vector<Candidate> candidates_;
  std::vector<double> middles_;
};

}  // namespace sightline
