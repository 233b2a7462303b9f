#include "beam/region.hpp"

#include <glm/geometric.hpp>

#include "exact/tally.hpp"

namespace sightline {
namespace {

glm::dvec3 inward(const SightlineTable& table, SightlineRef line) {
  return table.approx(line.id) * static_cast<double>(line.sign);
}

// filter_order with the cross product of the first two taken beforehand: the same roundings, the same bound.
constexpr double bound = 64 * 0x1p-53;

}  // namespace

Regions::Region Regions::push(const SightlineTable& table, std::span<const SightlineRef> sides) {
  const Region r{mark(), static_cast<std::uint32_t>(sides.size())};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const glm::dvec3 normal = inward(table, sides[k]);
    stack_.push_back({sides[k], normal, glm::cross(inward(table, sides[(k + 1) % sides.size()]), normal)});
  }
  return r;
}

int Regions::classify(SightlineTable& table, Region region, SightlineRef line) {
  sign_.resize(region.count);
  int found = 0;
  const glm::dvec3 n = inward(table, line);
  std::uint64_t filtered = 0;
  const RegionSide* const side = stack_.data() + region.first;
  for (std::uint32_t k = 0; k < region.count; ++k) {
    const RegionSide& here = side[k];
    if (here.line.id == line.id) {
      // The region lies wholly on one side of its own side's line.
      tally().filter += filtered;
      ++tally().identity;
      return here.line.sign == line.sign ? 2 : 1;
    }
    const double det = here.corner.x * n.x + here.corner.y * n.y + here.corner.z * n.z;
    Sign s = det > bound ? 1 : det < -bound ? -1 : uncertain;
    if (s == uncertain) [[unlikely]] {
      const RegionSide& next = side[k + 1 == region.count ? 0 : k + 1];
      s = table.order(next.line, here.line, line);
    } else {
      ++filtered;
    }
    found |= s > 0 ? 2 : s < 0 ? 1 : 0;
    sign_[k] = static_cast<std::int8_t>(s);
  }
  tally().filter += filtered;
  return found;
}

Regions::Region Regions::clip(SightlineTable& table, Region region, SightlineRef line) {
  const int found = classify(table, region, line);
  if (!(found & 2)) return {region.first, 0};
  if (!(found & 1)) return region;
  const glm::dvec3 normal = inward(table, line);
  // Keep the sides that have a corner inside; the line itself goes where they leave off.
  Region cut{mark(), 0};
  std::uint32_t own = 0;  // where the line stands among the sides
  Sign before = sign_[region.count - 1];
  for (std::uint32_t k = 0; k < region.count; ++k) {
    const Sign after = sign_[k];
    if (before > 0 || after > 0) {
      stack_.push_back(stack_[region.first + k]);
      if (after <= 0) {
        own = mark() - cut.first;
        stack_.push_back({line, normal, {}});
      }
    }
    before = after;
  }
  cut.count = mark() - cut.first;
  RegionSide* const made = stack_.data() + cut.first;
  RegionSide& last = made[own - 1];
  last.corner = glm::cross(normal, last.normal);
  made[own].corner = glm::cross(made[own + 1 == cut.count ? 0 : own + 1].normal, normal);
  return cut;
}

}  // namespace sightline
