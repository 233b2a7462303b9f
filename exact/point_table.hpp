// The scene's vertices on the grid.
#pragma once

#include "exact/grid.hpp"
#include "exact/limbs.hpp"

#include <glm/vec3.hpp>
#include <span>

namespace sightline {

/// Points by index, as exact integers on a Grid, with their unit coordinates in doubles (each within 2^-54).
class PointTable {
 public:
  PointTable() = default;
  /// Throws std::invalid_argument if a point is none of those that the grid was made of or could have been: finer than
  /// the grid, or longer than its bits().
  PointTable(const Grid& grid, std::span<const glm::dvec3> world);

  std::uint32_t size() const { return static_cast<std::uint32_t>(approx_.size()); }
  std::array<Integer, 3> point(PointId p) const;
  bool equal(PointId a, PointId b) const;
  const glm::dvec3& approx(PointId p) const { return approx_[p]; }
  Limbs coordinate(PointId p, int axis) const;  // two's complement words, for the fixed-width stages
  const Grid& grid() const { return grid_; }
  int bits() const { return grid_.bits(); }
  /// Words a coordinate; words(p) are the three coordinates one after the other, two's complement.
  std::uint32_t stride() const { return stride_; }
  const std::uint64_t* words(PointId p) const { return words_.data() + std::size_t{3} * stride_ * p; }

 private:
  Grid grid_;
  std::vector<glm::dvec3> approx_;
  std::vector<std::uint64_t> words_;  // stride_ words a coordinate, as the longest needs
  std::uint32_t stride_ = 1;
};

}  // namespace sightline
