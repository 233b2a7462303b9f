// What an eye sees of a piece, in doubles: for what is told without exact numbers. Internal to beam/.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "beam/vector_fours.hpp"
#include "bsp/tree.hpp"

namespace sightline {

/// The eye in unit coordinates, and how far products with what is seen from it may be off. Let S be the larger of 1
/// and the eye's reach. Points of the scene are below 1, corners of pieces within 2^-48, the eye within 2^-53 S: the
/// difference of the two is below 2 S and within 2^-47 S by component.
struct ViewScale {
  glm::dvec3 eye{0};
  double point = 0;  // of a line's normal (at most 1) with a difference: 3 (2^-47 + 2^-51) S, and less to round
  double side = 0;   // of a corner of patches (at most 2, within 2^-49) with a product of two differences, which is
                     // below 8 S^2 and within 2^-43 S^2: 3 (2 * 2^-43 + 8 * 2^-49) S^2, and less to round

  void set(const glm::dvec3& e) {
    eye = e;
    const double s = std::max({1.0, std::abs(e.x), std::abs(e.y), std::abs(e.z)});
    point = 0x1p-44 * s;
    side = 0x1p-39 * s * s;
  }
};

/// The cone of a piece, counter-clockwise seen from the front of its plane: ray k to the corner in which side k begins,
/// and the normals of the sides, pointing outwards.
struct Cone {
  const TreePiece* piece = nullptr;
  Sign eye_side = 0;  // of the piece's plane
  std::vector<glm::dvec3> ray, out;
  VectorFours quick_ray, quick_out;  // the same for factors of at most 1 (lines) and 2 (corners)
  std::vector<SightlineRef> outer;   // the sides' lines, pointing outwards, as far as they have been asked for
  glm::dvec3 middle{0};

  void set(const ViewScale& scale, const TreePiece& p, Sign eye) {
    piece = &p;
    eye_side = eye;
    out.clear();
    outer.clear();
    ray.resize(p.count);
    quick_ray.resize(p.count);
    middle = {0, 0, 0};
    for (std::uint32_t k = 0; k < p.count; ++k) {
      const glm::dvec3 at = p.corner[k].at - scale.eye;
      ray[k] = at;
      quick_ray.set(k, at, scale.point);
      middle += at;
    }
    quick_ray.close(p.count - 1);
  }
  void need_sides(const ViewScale& scale) {
    if (!out.empty()) return;
    const std::size_t n = ray.size();
    outer.resize(n);
    out.resize(n);
    quick_out.resize(n);
    // (a - eye) x (b - eye) points outwards where a, b run counter-clockwise as the eye sees them.
    for (std::size_t k = 0; k < n; ++k) {
      const glm::dvec3 &a = ray[k], &b = ray[k + 1 == n ? 0 : k + 1];
      out[k] = eye_side > 0 ? glm::cross(a, b) : glm::cross(b, a);
      quick_out.set(k, out[k], scale.side);
    }
    quick_out.close(n - 1);
  }
  /// A ray inside, ahead of the eye if there is one.
  glm::dvec3 inner(const glm::dvec3& ahead) const {
    const double z = glm::dot(ahead, middle);
    if (z > 0) return middle;
    glm::dvec3 front{0, 0, 0};
    for (std::size_t k = 0; k < ray.size(); ++k) {
      if (glm::dot(ahead, ray[k]) > 0) front += ray[k];
    }
    return z < 0 ? front - middle * (glm::dot(ahead, front) / (2 * z)) : front + middle;
  }
};

}  // namespace sightline
