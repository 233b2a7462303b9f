// What makes a good cut.
#pragma once

namespace sightline {

/// Weights of the choice; the defaults were measured (docs/bsp.md).
struct ChoiceWeights {
  double split = 6.0;        // per piece cut, as part of all
  double imbalance = 1.0;    // difference of the halves, as part of all
  double cover = 1.5;        // opaque part of the cut, 0 to 1
  double axis = 0.25;        // in favour of planes along the axes
};

}  // namespace sightline
