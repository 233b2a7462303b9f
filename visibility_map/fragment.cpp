#include "visibility_map/fragment.hpp"

namespace sightline {

void Fragments::clear() {
  fragments.clear();
  sides.clear();
  corners.clear();
  same.clear();
  seen.clear();
  origins.clear();
  by_lines_.clear();
}

/// The same for the same pair of lines.
std::uint32_t Fragments::corner(SightlineRef a, SightlineRef b) {
  const FragmentCorner wanted = FragmentCorner::of(a, b);
  const std::uint64_t key =
      std::uint64_t{wanted.low} << 33 | std::uint64_t{wanted.high} << 1 | (wanted.sign > 0 ? 1u : 0u);
  std::uint32_t found = none;
  const auto take = [&](std::uint32_t value) {
    found = value;
    return true;
  };
  if (!by_lines_.find(key, take)) {
    found = static_cast<std::uint32_t>(corners.size());
    corners.push_back(wanted);
    by_lines_.insert(key, found);
  }
  return found;
}

void Fragments::add_convex(std::span<const SightlineRef> lines, std::span<const SurfaceId> on) {
  fragments.push_back({static_cast<std::uint32_t>(sides.size()), static_cast<std::uint32_t>(lines.size()),
                       static_cast<std::uint32_t>(seen.size()), static_cast<std::uint32_t>(on.size())});
  seen.insert(seen.end(), on.begin(), on.end());
  const std::uint32_t first = corner(lines.back(), lines.front());
  std::uint32_t from = first;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::uint32_t to = k + 1 == lines.size() ? first : corner(lines[k], lines[k + 1]);
    sides.push_back({lines[k], from, to});
    from = to;
  }
}

}  // namespace sightline
