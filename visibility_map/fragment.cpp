#include "visibility_map/fragment.hpp"

namespace sightline {

void Fragments::clear() {
  fragments.clear();
  sides.clear();
  corners.clear();
  rays.clear();
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

void Fragments::append(const Fragments& part, const SightlineTable& from, SightlineTable& to) {
  line_of_.assign(from.size(), {none, 1});
  const auto line = [&](SightlineId id) {
    if (line_of_[id].id != none) return line_of_[id];
    if (const auto [a, b] = from.points(id); a != none) {
      line_of_[id] = to.of_points(a, b);
    } else {
      const std::uint32_t stride = words_for(from.bits(id));
      words_.assign(from.words(id), from.words(id) + std::size_t{3} * stride);
      line_of_[id] = to.of_normal(words_.data(), stride);
    }
    return line_of_[id];
  };
  const auto moved = [](std::uint32_t index, std::size_t by) { return static_cast<std::uint32_t>(index + by); };
  const std::size_t first_side = sides.size(), first_corner = corners.size(), first_seen = seen.size();
  for (const Fragment& f : part.fragments) {
    fragments.push_back({moved(f.first_side, first_side), f.side_count, moved(f.first_seen, first_seen), f.seen_count});
  }
  for (const FragmentSide& side : part.sides) {
    SightlineRef own = line(side.line.id);
    own.sign *= side.line.sign;
    sides.push_back({own, moved(side.from, first_corner), moved(side.to, first_corner)});
  }
  for (const FragmentCorner& c : part.corners) {  // N_low x N_high is the ray of (high, low)
    SightlineRef high = line(c.high);
    high.sign *= c.sign;
    corners.push_back(FragmentCorner::of(high, line(c.low)));
  }
  rays.insert(rays.end(), part.rays.begin(), part.rays.end());
  for (const auto& [a, b] : part.same) same.emplace_back(moved(a, first_corner), moved(b, first_corner));
  seen.insert(seen.end(), part.seen.begin(), part.seen.end());
  for (Origin origin : part.origins) {
    origin.line = line(origin.line).id;
    origins.push_back(origin);
  }
}

}  // namespace sightline
