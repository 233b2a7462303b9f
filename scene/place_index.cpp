#include "scene/place_index.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace sightline {
namespace {

/// Cells along each axis: cubes as far as may be, several for each point; buildings are flat, cities empty.
std::array<std::size_t, 3> cells_along(const glm::dvec3& size, std::size_t points) {
  const double wanted = std::min(8.0 * static_cast<double>(points), 0x1p22);
  std::array<std::size_t, 3> cells{1, 1, 1};
  // The edge of the cubes, of those axes alone that are longer than it.
  double edge = 0;
  for (int round = 0; round < 3; ++round) {
    double volume = 1;
    int axes = 0;
    for (int k = 0; k < 3; ++k) {
      if (!(size[k] > edge)) continue;
      volume *= size[k];
      ++axes;
    }
    if (axes == 0) break;
    edge = std::pow(volume / wanted, 1.0 / axes);
  }
  for (int k = 0; k < 3; ++k) {
    if (edge > 0 && size[k] > edge) {
      cells[static_cast<std::size_t>(k)] = static_cast<std::size_t>(std::min(size[k] / edge, 4096.0));
    }
  }
  return cells;
}

}  // namespace

PlaceIndex::PlaceIndex(const PointTable& points, std::span<const PointId> members) {
  if (members.empty()) return;
  glm::dvec3 low = points.approx(members[0]), high = low;
  for (const PointId p : members) {
    low = glm::min(low, points.approx(p));
    high = glm::max(high, points.approx(p));
  }
  low_ = low;
  cells_ = cells_along(high - low, members.size());
  for (int k = 0; k < 3; ++k) {
    const double size = high[k] - low[k];
    std::size_t& cells = cells_[static_cast<std::size_t>(k)];
    const double scale = static_cast<double>(cells) / size;
    if (!std::isfinite(scale)) cells = 1;  // closer together than doubles can divide
    scale_[k] = cells > 1 ? scale : 0;
    last_[k] = static_cast<double>(cells - 1);
  }
  const auto cell_of = [&](PointId p) {
    std::size_t cell = 0;
    for (int k = 0; k < 3; ++k) {
      const std::size_t n = cells_[static_cast<std::size_t>(k)];
      cell = cell * n + std::min(static_cast<std::size_t>((points.approx(p)[k] - low_[k]) * scale_[k]), n - 1);
    }
    return cell;
  };
  first_.assign(cells_[0] * cells_[1] * cells_[2] + 1, 0);
  for (const PointId p : members) ++first_[cell_of(p) + 1];
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  members_.resize(members.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const PointId p : members) members_[next[cell_of(p)]++] = {p, points.approx(p)};
}

}  // namespace sightline
