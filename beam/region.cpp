#include "beam/region.hpp"

#include <glm/geometric.hpp>

#include "exact/tally.hpp"

namespace sightline {
namespace {

glm::dvec3 inward(const SightlineTable& table, SightlineRef line) {
  return table.approx(line.id) * static_cast<double>(line.sign);
}

glm::dvec3 corner(const SightlineTable& table, SightlineRef here, SightlineRef next) {
  return glm::cross(inward(table, next), inward(table, here));
}

// filter_order with the cross product of the first two taken beforehand: the same roundings, the same bound.
constexpr double bound = 64 * 0x1p-53;

}  // namespace

Regions::Region Regions::push(const SightlineTable& table, std::span<const SightlineRef> sides) {
  const Region r{mark(), static_cast<std::uint32_t>(sides.size())};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    stack_.push_back({sides[k], corner(table, sides[k], sides[(k + 1) % sides.size()])});
  }
  return r;
}

Regions::Region Regions::clip(SightlineTable& table, Region region, SightlineRef line) {
  // sign_[k]: on which side of the line the corner of sides k and k + 1 lies.
  sign_.clear();
  bool inside = false, outside = false;
  const glm::dvec3 n = inward(table, line);
  std::uint64_t filtered = 0;
  for (std::uint32_t k = 0; k < region.count; ++k) {
    const RegionSide& here = stack_[region.first + k];
    if (here.line.id == line.id) {
      // The region lies wholly on one side of its own side's line.
      tally().filter += filtered;
      ++tally().identity;
      return here.line.sign == line.sign ? region : Region{region.first, 0};
    }
    const double det = here.corner.x * n.x + here.corner.y * n.y + here.corner.z * n.z;
    Sign s = det > bound ? 1 : det < -bound ? -1 : uncertain;
    if (s == uncertain) {
      const RegionSide& next = stack_[region.first + (k + 1 == region.count ? 0 : k + 1)];
      s = table.order(next.line, here.line, line);
    } else {
      ++filtered;
    }
    inside |= s > 0;
    outside |= s < 0;
    sign_.push_back(static_cast<std::int8_t>(s));
  }
  tally().filter += filtered;
  if (!inside) return {region.first, 0};
  if (!outside) return region;

  // Keep the sides that have a corner inside; the line itself goes where they leave off.
  Region cut{mark(), 0};
  std::uint32_t own = 0;  // where the line stands among the sides
  for (std::uint32_t k = 0; k < region.count; ++k) {
    const Sign before = sign_[k == 0 ? region.count - 1 : k - 1], after = sign_[k];
    if (before <= 0 && after <= 0) continue;
    stack_.push_back(stack_[region.first + k]);
    if (after > 0) continue;
    own = mark() - cut.first;
    stack_.push_back({line, {}});
  }
  cut.count = mark() - cut.first;
  RegionSide* const side = stack_.data() + cut.first;
  RegionSide& last = side[own - 1];
  last.corner = corner(table, last.line, line);
  side[own].corner = corner(table, line, side[own + 1 == cut.count ? 0 : own + 1].line);
  return cut;
}

}  // namespace sightline
