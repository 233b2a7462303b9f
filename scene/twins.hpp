// Vertices that are the same point, polygons that have the same vertices.
#pragma once

#include "exact/point_table.hpp"

#include <span>
#include <vector>

namespace sightline {

/// For each point the lowest index of a point with equal coordinates.
std::vector<PointId> lowest_equal(const PointTable& points);

/// How many polygons have the same set of vertices (places in space, not indices) as one before them. `representative`
/// is the result of lowest_equal; polygon k has the corners first[k]..first[k+1].
std::uint32_t count_duplicates(std::span<const std::uint32_t> first, std::span<const std::uint32_t> corners,
                               std::span<const PointId> representative);

}  // namespace sightline
