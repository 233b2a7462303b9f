// What makes a good cut.
#pragma once

namespace sightline {

/// Weights of the choice; the defaults were measured (docs/bsp.md).
struct ChoiceWeights {
  double split = 40.0;  // per piece cut, as part of all
  double area = 1.0;    // pieces on each side, weighted by the surface of that side: cuts off empty space
  double cover = 0.8;   // opaque part of the cut, 0 to 1
  double axis = 0.1;    // in favour of planes along the axes
  double hair = 0.2;    // as part of a piece cut: one that lies within rounding of the cut, but on one side
};

}  // namespace sightline
