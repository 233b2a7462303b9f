// The eye of a table of sightlines. For this folder's own use.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace sightline {

/// The eye's coordinates, at hand for exact arithmetic.
struct ExactEye {
  std::vector<std::uint64_t> words;  // `stride` a coordinate
  std::uint32_t stride = 1;
  int shift = 0, bits = 0, difference_bits = 0;  // of point - eye, on the eye's grid
  bool is_short = false;                         // coordinates and differences of one word
  glm::dvec3 approx{0};                          // unit coordinates, the nearest doubles
  double reach = 0;                              // the largest of their magnitudes
};

}  // namespace sightline
