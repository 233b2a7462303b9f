#include "beam/region.hpp"

namespace sightline {

Regions::Region Regions::push(std::span<const SightlineRef> sides) {
  const Region r{mark(), static_cast<std::uint32_t>(sides.size())};
  stack_.insert(stack_.end(), sides.begin(), sides.end());
  return r;
}

Regions::Region Regions::clip(SightlineTable& table, Region region, SightlineRef line) {
  // sign_[k]: on which side of the line the corner of sides k and k + 1 lies.
  sign_.clear();
  bool inside = false, outside = false;
  for (std::uint32_t k = 0; k < region.count; ++k) {
    const SightlineRef here = stack_[region.first + k];
    const SightlineRef next = stack_[region.first + (k + 1 == region.count ? 0 : k + 1)];
    Sign s;
    if (here.id == line.id || next.id == line.id) {
      // The region lies wholly on one side of its own side's line.
      const Sign own = here.id == line.id ? here.sign : next.sign;
      if (own != line.sign) return {region.first, 0};
      return region;
    }
    s = table.order(next, here, line);
    inside |= s > 0;
    outside |= s < 0;
    sign_.push_back(static_cast<std::int8_t>(s));
  }
  if (!inside) return {region.first, 0};
  if (!outside) return region;

  // Keep the sides that have a corner inside; the line itself goes where they leave off.
  Region cut{mark(), 0};
  for (std::uint32_t k = 0; k < region.count; ++k) {
    const Sign before = sign_[k == 0 ? region.count - 1 : k - 1], after = sign_[k];
    if (before <= 0 && after <= 0) continue;
    stack_.push_back(stack_[region.first + k]);
    if (after <= 0) stack_.push_back(line);
  }
  cut.count = mark() - cut.first;
  return cut;
}

}  // namespace sightline
