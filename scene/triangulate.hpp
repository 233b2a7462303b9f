// Polygons whose vertices do not lie in one plane, as triangles of their own vertices.
#pragma once

#include "exact/point_table.hpp"

#include <array>
#include <span>
#include <vector>

namespace sightline {

using Triangle = std::array<PointId, 3>;

/// The fan from the loop's first vertex where it does not fold over itself, seen along the axis of the largest
/// component of the loop's Newell normal; else ears, cut in that view; else, where no ears are found (the loop crosses
/// itself), the fan all the same. Triangles keep the loop's direction. There are loop.size() - 2 of them; some may have
/// no area.
std::vector<Triangle> triangulate(const PointTable& points, std::span<const PointId> loop);

}  // namespace sightline
