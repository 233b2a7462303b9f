#include "bsp/tree_choice.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

constexpr std::size_t looked_at = 64;      // pieces among which candidates are chosen by area
constexpr std::size_t candidates = 12;     // planes judged
constexpr std::size_t counted = 192;       // pieces on which each is judged
constexpr double flat = 0x1p-40;           // unit length below which a piece counts as lying in a plane
constexpr std::size_t bins = 256;          // for gaps
constexpr std::size_t sorted_up_to = 256;  // pieces among which gaps are found one by one
constexpr double clear = 0x1p-42;          // unit length by which at least pieces keep clear of a plane in a gap
constexpr std::size_t gaps_from = 8;       // pieces from which gaps are looked for

constexpr double weight_split = 8.0;  // per piece cut, as part of all
constexpr double weight_hair = 0.3;   // as part of that: one within rounding of the cut, mostly on one side
constexpr double weight_area = 1.0;   // pieces on each side, weighted by the surface of that side
constexpr double weight_cover = 1.0;  // opaque part of the cut

}  // namespace

TreeChoice::Count TreeChoice::count(std::span<const Piece> here, std::size_t stride, PlaneId plane) const {
  Count n;
  const ApproxPlane& p = planes_.approx(plane);
  for (std::size_t k = 0; k < here.size(); k += stride) {
    const Piece& piece = here[k];
    if (piece.plane == plane) {
      n.on += 1;
      n.covered += pieces_.area(piece);
      continue;
    }
    double middle = -p.d, reach = 0;
    for (int i = 0; i < 3; ++i) {
      middle += p.n[i] * (piece.low[i] + piece.high[i]) * 0.5;
      reach += std::abs(p.n[i]) * (piece.high[i] - piece.low[i]) * 0.5;
    }
    bool behind = middle - reach < -flat;
    bool front = middle + reach > flat;
    if (behind && front && planes_.axis(plane) < 0) {
      behind = front = false;
      for (const PieceCorner& c : pieces_.corners(piece)) {
        const double s = p.n[0] * c.place.approx.x + p.n[1] * c.place.approx.y + p.n[2] * c.place.approx.z - p.d;
        behind |= s < -flat;
        front |= s > flat;
      }
    }
    if (behind == front) {
      const double cut = behind ? 1 : weight_hair;
      n.split += cut;
      n.behind += (1 - cut) / 2;
      n.front += (1 - cut) / 2;
    } else {
      (behind ? n.behind : n.front) += 1;
    }
  }
  return n;
}

double TreeChoice::cost(const Count& n, const TreeBox& box, PlaneId plane) const {
  const ApproxPlane& p = planes_.approx(plane);
  const glm::dvec3 size = box.half * 2.0;
  const int k = main_axis(p.n);
  const double at =
      (p.d - p.n[(k + 1) % 3] * box.middle[(k + 1) % 3] - p.n[(k + 2) % 3] * box.middle[(k + 2) % 3]) / p.n[k];
  glm::dvec3 below = size, above = size;
  below[k] = std::clamp(at - box.middle[k] + box.half[k], 0.0, size[k]);
  above[k] = size[k] - below[k];
  const double all = surface(size);
  double behind = all > 0 ? surface(below) / all : 0.5, front = all > 0 ? surface(above) / all : 0.5;
  if (p.n[k] < 0) std::swap(behind, front);
  const double total = n.behind + n.front + n.split + n.on;
  const double section = size[(k + 1) % 3] * size[(k + 2) % 3] / std::abs(p.n[k]);
  const double cover = section > 0 ? std::min(1.0, n.covered / section) : 1.0;
  return weight_split * n.split / total +
         weight_area * (behind * (n.behind + n.split) + front * (n.front + n.split)) / total - weight_cover * cover;
}

void TreeChoice::measure(std::span<const Piece> here, const glm::dvec3& normal) {
  extents_.clear();
  for (int k = 0; k < 3; ++k) {
    if (normal[k] != 1) continue;
    for (const Piece& p : here) extents_.push_back({p.low[k], p.high[k]});
    return;
  }
  for (const Piece& p : here) {
    Extent e{INFINITY, -INFINITY};
    for (const PieceCorner& c : pieces_.corners(p)) {
      const double value = glm::dot(normal, c.place.approx);
      e.low = std::min(e.low, value);
      e.high = std::max(e.high, value);
    }
    extents_.push_back(e);
  }
}

/// Judges the gaps between the pieces along a normal: few pieces by their order, many by bins, of which an empty one
/// between two that are covered is a gap.
void TreeChoice::find_gap(std::span<const Piece> here, const glm::dvec3& normal, TreeCut& cut, double& least) {
  measure(here, normal);
  double low = INFINITY, high = -INFINITY;
  for (const Extent& e : extents_) {
    low = std::min(low, e.low);
    high = std::max(high, e.high);
  }
  const double size = high - low, total = static_cast<double>(here.size());
  if (!(size > 8 * clear)) return;
  const auto judge = [&](double at, double before) {
    const double behind = (at - low) / size;
    const double now = weight_area * (0.2 + 0.8 * (behind * before + (1 - behind) * (total - before)) / total);
    if (now >= least) return;
    least = now;
    cut = {none, normal, at};
  };
  if (here.size() <= sorted_up_to) {
    std::sort(extents_.begin(), extents_.end(), [](const Extent& a, const Extent& b) { return a.low < b.low; });
    double reached = extents_[0].high;
    for (std::size_t k = 1; k < extents_.size(); ++k) {
      if (extents_[k].low - reached > 4 * clear) judge((extents_[k].low + reached) * 0.5, static_cast<double>(k));
      reached = std::max(reached, extents_[k].high);
    }
    return;
  }
  enter_.assign(bins + 1, 0);
  leave_.assign(bins + 1, 0);
  const double scale = static_cast<double>(bins) / size;
  const auto bin = [&](double x) {
    return static_cast<std::size_t>(std::clamp((x - low) * scale, 0.0, static_cast<double>(bins - 1)));
  };
  for (const Extent& e : extents_) {
    ++enter_[bin(e.low)];
    ++leave_[bin(e.high) + 1];
  }
  std::size_t begun = 0, ended = 0;
  for (std::size_t k = 0; k < bins && size > static_cast<double>(bins) * 8 * clear; ++k) {
    begun += enter_[k];
    ended += leave_[k];
    // Whoever stands in the bin has begun and not ended.
    if (begun != ended || begun == 0 || begun == here.size()) continue;
    judge(low + (static_cast<double>(k) + 0.5) / scale, static_cast<double>(begun));
  }
}

TreeCut TreeChoice::choose(std::span<const Piece> here, const TreeBox& box) {
  TreeCut best{here[0].plane, {}, 0};
  if (here.size() == 1) return best;
  candidates_.clear();
  const std::size_t step = here.size() / looked_at + 1;
  for (std::size_t k = 0; k < here.size(); k += step) candidates_.push_back({-pieces_.area(here[k]), here[k].plane});
  if (candidates_.size() > candidates) {
    std::nth_element(candidates_.begin(), candidates_.begin() + candidates, candidates_.end());
    candidates_.resize(candidates);
  }
  std::sort(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) { return a.second < b.second; });
  const auto last =
      std::unique(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) { return a.second == b.second; });
  candidates_.erase(last, candidates_.end());
  const std::size_t stride = here.size() / counted + 1;
  double least = INFINITY;
  for (const auto& [negative, plane] : candidates_) {
    const double now = cost(count(here, stride, plane), box, plane);
    if (now >= least) continue;
    least = now;
    best = {plane, {}, 0};
  }
  if (here.size() < gaps_from) return best;
  // Along the axes, and along the planes of large pieces that are turned against them.
  normals_.assign({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (const auto& [negative, plane] : candidates_) {
    if (planes_.axis(plane) >= 0 || normals_.size() == 6) continue;
    const ApproxPlane& p = planes_.approx(plane);
    const glm::dvec3 normal{p.n[0], p.n[1], p.n[2]};
    const auto alike = [&](const glm::dvec3& other) {
      return glm::length(glm::cross(normal, other)) < 0x1p-20 * glm::length(normal) * glm::length(other);
    };
    if (std::none_of(normals_.begin(), normals_.end(), alike)) normals_.push_back(normal);
  }
  for (const glm::dvec3& normal : normals_) find_gap(here, normal, best, least);
  return best;
}

}  // namespace sightline
