#include "beam/view.hpp"

namespace sightline {

void View::see(Regions::Region region, std::span<const SurfaceId> on, Sign eye_side) {
  Fragment f{static_cast<std::uint32_t>(fragments.sides.size()), region.count,
             static_cast<std::uint32_t>(fragments.seen.size()), 0};
  for (const RegionSide& side : regions.sides(region)) fragments.sides.push_back(side.line);
  for (const SurfaceId s : on) {
    if (opaque(s, eye_side)) fragments.seen.push_back(s);
  }
  f.seen_count = static_cast<std::uint32_t>(fragments.seen.size()) - f.first_seen;
  fragments.fragments.push_back(f);
}

}  // namespace sightline
