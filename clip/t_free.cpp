#include "clip/t_free.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "clip/point_tree.hpp"
#include "clip/side_planes.hpp"

namespace sightline {
namespace {

struct HashPlace {
  std::size_t operator()(const std::array<double, 3>& at) const {
    std::size_t h = 0;
    for (const double x : at) h = (h ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15u;
    return h;
  }
};

glm::dvec3 vector(const std::array<double, 3>& at) { return {at[0], at[1], at[2]}; }

class Joining {
 public:
  Joining(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options, const ClipResult& result)
      : result_(result), planes_(scene, cameras, options.regions), place_of_(result.corners.size()) {
    for (const ClipPiece& piece : result.pieces) find_places(piece);
  }

  TFreePieces join() {
    std::vector<glm::dvec3> at;
    double most = 0;
    for (const std::uint32_t corner : corner_of_) {
      at.push_back(vector(result_.corners[corner].at));
      most = std::max({most, std::abs(at.back().x), std::abs(at.back().y), std::abs(at.back().z)});
    }
    const PointTree tree(at);
    TFreePieces out;
    std::vector<std::uint32_t> near;
    for (const ClipPiece& piece : result_.pieces) {
      for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
        const std::uint32_t from = place_of_[piece.first_corner + k], to = place_of_[next(piece, k)];
        out.corners.push_back(corner_of_[from]);
        near.clear();
        tree.near(at[from], at[to], 0x1p-48 * most, near);
        keep_inside(piece, k, near);
        for (const std::uint32_t place : near) out.corners.push_back(corner_of_[place]);
      }
      out.first.push_back(static_cast<std::uint32_t>(out.corners.size()));
    }
    return out;
  }

 private:
  static std::uint32_t next(const ClipPiece& piece, std::uint32_t k) {
    return piece.first_corner + (k + 1 == piece.corner_count ? 0 : k + 1);
  }
  const ClipSide& side(const ClipPiece& piece, std::uint32_t k) const {
    return result_.corners[piece.first_corner + k].side;
  }

  void find_places(const ClipPiece& piece) {
    const ExactRow own = planes_.surface(piece.surface);
    ExactRow before = planes_.side(side(piece, piece.corner_count - 1), piece.surface);
    for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
      ExactRow after = planes_.side(side(piece, k), piece.surface);
      enter(piece.first_corner + k, SidePlanes::meet(own, before, after));
      before = std::move(after);
    }
  }

  /// Equal places have equal nearest doubles, so only those with these need be compared.
  void enter(std::uint32_t corner, ExactRow&& place) {
    std::vector<std::uint32_t>& alike = by_doubles_[result_.corners[corner].at];
    for (const std::uint32_t other : alike) {
      bool same = true;
      for (std::size_t k = 0; k < 3; ++k) same = same && SidePlanes::compare(place_[other], place, k) == 0;
      if (!same) continue;
      place_of_[corner] = other;
      return;
    }
    place_of_[corner] = static_cast<std::uint32_t>(place_.size());
    alike.push_back(place_of_[corner]);
    place_.push_back(std::move(place));
    corner_of_.push_back(corner);
  }

  /// Nearest doubles are in the order of what they are nearest to, as far as they differ.
  Sign compare(std::uint32_t a, std::uint32_t b, std::size_t k) const {
    const double x = result_.corners[corner_of_[a]].at[k], y = result_.corners[corner_of_[b]].at[k];
    return x < y ? -1 : x > y ? 1 : SidePlanes::compare(place_[a], place_[b], k);
  }

  /// Of places near side k of a piece those inside it, in their order along it.
  void keep_inside(const ClipPiece& piece, std::uint32_t k, std::vector<std::uint32_t>& near) {
    const std::uint32_t from = place_of_[piece.first_corner + k], to = place_of_[next(piece, k)];
    std::erase_if(near, [&](std::uint32_t place) { return place == from || place == to; });
    if (near.empty()) return;
    std::size_t axis = 0;
    while (compare(from, to, axis) == 0) ++axis;
    const Sign along = compare(from, to, axis);
    const ExactRow own = planes_.surface(piece.surface), wall = planes_.side(side(piece, k), piece.surface);
    std::erase_if(near, [&](std::uint32_t place) {
      return compare(from, place, axis) != along || compare(place, to, axis) != along ||
             !SidePlanes::holds(own, place_[place]) || !SidePlanes::holds(wall, place_[place]);
    });
    std::sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) { return compare(a, b, axis) == along; });
  }

  const ClipResult& result_;
  SidePlanes planes_;
  std::vector<std::uint32_t> place_of_;   // by corner
  std::vector<std::uint32_t> corner_of_;  // by place: the first that is there
  std::vector<ExactRow> place_;
  std::unordered_map<std::array<double, 3>, std::vector<std::uint32_t>, HashPlace> by_doubles_;
};

}  // namespace

TFreePieces t_free(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options,
                   const ClipResult& result) {
  return Joining(scene, cameras, options, result).join();
}

}  // namespace sightline
