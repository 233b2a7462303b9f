#include <algorithm>
#include <bit>
#include <unordered_map>

#include "clip/surface_clipper.hpp"

namespace sightline {
namespace {

/// A side by its two ends.
struct Ends {
  glm::dvec3 from, to;
  bool operator==(const Ends&) const = default;
};
struct HashEnds {
  std::size_t operator()(const Ends& e) const {
    std::uint64_t h = 0;
    for (const glm::dvec3& p : {e.from, e.to})
      for (int k = 0; k < 3; ++k) {
        h = (h ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15u;  // + 0.0: one zero
        h ^= h >> 29;
      }
    return h;
  }
};

class Union {
 public:
  Union(std::vector<SurfacePiece>& pieces, Outlines& outlines)
      : pieces_(pieces), outlines_(outlines), gone_(pieces.size(), 0) {
    for (std::uint32_t k = 0; k < pieces.size(); ++k) enter(k);
  }

  /// From the first piece on, each fresh one takes what it can, for as long as it can.
  void run() {
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      // What is below the threshold stays so.
      if (!pieces_[k].fresh || pieces_[k].partly.any()) continue;
      while (!gone_[k] && take_one(k)) enter(k);
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (gone_[k]) continue;
      if (kept != k) pieces_[kept] = std::move(pieces_[k]);
      ++kept;
    }
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(kept), pieces_.end());
  }

 private:
  static Ends ends(const Outline& o, std::size_t side) {
    return {o.corner[side == 0 ? o.size() - 1 : side - 1], o.corner[side]};
  }
  void enter(std::uint32_t k) {
    const Outline& o = pieces_[k].outline;
    for (std::size_t i = 0; i < o.size(); ++i) by_ends_[ends(o, i)] = k;
  }
  bool take_one(std::uint32_t k) {
    SurfacePiece& piece = pieces_[k];
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      const Ends e = ends(piece.outline, i), reversed{e.to, e.from};
      const auto found = by_ends_.find(reversed);
      if (found == by_ends_.end() || gone_[found->second] || found->second == k) continue;
      const SurfacePiece& other = pieces_[found->second];
      if (other.wholly != piece.wholly || other.partly != piece.partly) continue;
      for (std::size_t j = 0; j < other.outline.size(); ++j) {
        if (ends(other.outline, j) != reversed) continue;  // also where it has grown since
        if (!outlines_.unite(piece.outline, i, other.outline, j)) break;
        gone_[found->second] = 1;
        return true;
      }
    }
    return false;
  }

  std::vector<SurfacePiece>& pieces_;
  Outlines& outlines_;
  std::vector<char> gone_;
  std::unordered_map<Ends, std::uint32_t, HashEnds> by_ends_;
};

}  // namespace

void unite(std::vector<SurfacePiece>& pieces, Outlines& outlines) {
  const auto fresh = [](const SurfacePiece& p) { return p.fresh; };
  if (pieces.size() > 1 && std::any_of(pieces.begin(), pieces.end(), fresh)) Union(pieces, outlines).run();
}

}  // namespace sightline
