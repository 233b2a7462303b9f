#include "beam/view.hpp"

namespace sightline {

void View::see(Regions::Region region, std::span<const SurfaceId> on, Sign eye_side) {
  lines_.clear();
  for (const RegionSide& side : regions.sides(region)) lines_.push_back(side.line);
  on_.clear();
  for (const SurfaceId s : on) {
    if (opaque(s, eye_side) && in_reach(s)) on_.push_back(s);
  }
  fragments.add_convex(lines_, on_);
}

}  // namespace sightline
