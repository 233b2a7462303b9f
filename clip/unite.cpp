#include <algorithm>
#include <unordered_map>

#include "clip/surface_clipper.hpp"

namespace sightline {

/// From the first piece on, each takes what it can from those after it, for as long as anything changes.
void unite(std::vector<SurfacePiece>& pieces, Outlines& outlines) {
  if (pieces.size() < 2) return;
  std::vector<char> gone(pieces.size(), 0);
  // Pieces by the lines of their sides: only those with a line in common can touch along it.
  std::unordered_multimap<SightlineId, std::uint32_t> by_line;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    for (const OutlineSide& side : pieces[k].outline.sides) by_line.emplace(side.line.id, k);
  }
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    if (gone[k]) continue;
    SurfacePiece& piece = pieces[k];
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<std::uint32_t> others;
      for (const OutlineSide& side : piece.outline.sides) {
        const auto [first, last] = by_line.equal_range(side.line.id);
        for (auto it = first; it != last; ++it) others.push_back(it->second);
      }
      std::sort(others.begin(), others.end());
      others.erase(std::unique(others.begin(), others.end()), others.end());
      for (const std::uint32_t other : others) {
        if (other == k || gone[other] || !(pieces[other].wholly == piece.wholly) ||
            !(pieces[other].partly == piece.partly) || !outlines.unite(piece.outline, pieces[other].outline))
          continue;
        gone[other] = 1;
        for (const OutlineSide& side : pieces[other].outline.sides) by_line.emplace(side.line.id, k);
        changed = true;
        break;
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (gone[k]) continue;
    if (kept != k) pieces[kept] = std::move(pieces[k]);
    ++kept;
  }
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(kept), pieces.end());
}

}  // namespace sightline
