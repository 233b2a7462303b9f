// What doubles tell of the order of three sightlines.
#pragma once

#include "exact/types.hpp"

#include <glm/vec3.hpp>

namespace sightline {

/// Sign of det(x, y, z) of approximate normals. Components are at most 1, each within u = 2^-53. Data: six terms, each
/// within 3u. Rounding: the minors are within 4u, their products with the third within 6u, and the two sums add 4u and
/// 6u. 18 + 18 + 10 = 46 u; the bound is 64 u. A contracted product only rounds less.
inline Sign filter_order(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
  constexpr double bound = 64 * 0x1p-53;
  const double det = (x.y * y.z - x.z * y.y) * z.x + (x.z * y.x - x.x * y.z) * z.y + (x.x * y.y - x.y * y.x) * z.z;
  return det > bound ? 1 : det < -bound ? -1 : uncertain;
}

}  // namespace sightline
