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

/// Naylor's expected-case view in small: planes of pieces that hide much, cut little and balance; above a size also
/// cuts in free space. Heuristic throughout: whatever it answers, the complex is right.
class Chooser {
 public:
  Chooser(const Scene& scene, const PlaneTable& planes, const Pieces& pieces, const ChoiceWeights& weights)
      : scene_(scene), planes_(planes), pieces_(pieces), weights_(weights) {}
  /// `pieces` is not empty. With `free_space` false only planes of pieces are considered.
  Choice choose(std::span<const Piece> pieces, bool free_space);

 private:
  struct Candidate {
    PlaneId plane;
    double area;
  };
  struct Count {
    double behind = 0, front = 0, split = 0, covered = 0;
  };
  Count count_plane(std::span<const Piece> pieces, PlaneId plane) const;
  Count count_axis(std::span<const Piece> pieces, int axis, double value) const;
  double cost(const Count& count, double total, double section, bool along_axis) const;
  double area(const Piece& piece) const;

  const Scene& scene_;
  const PlaneTable& planes_;
  const Pieces& pieces_;
  ChoiceWeights weights_;
  std::vector<Candidate> candidates_;
  std::vector<double> middles_;
};

}  // namespace sightline
