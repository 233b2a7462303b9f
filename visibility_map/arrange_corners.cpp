// Corners: interned by the pair of lines that meet in them.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The exact cross product of two canonical normals, scaled so that its largest component lies in [1/2, 1); each
/// component within 2^-52 (mpz_get_d_2exp truncates).
glm::dvec3 exact_cross(const SightlineTable& table, SightlineId low, SightlineId high) {
  const std::array<Integer, 3> a = table.normal(low), b = table.normal(high);
  double part[3];
  long exponent[3], top = std::numeric_limits<long>::min();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Integer c = a[i] * b[j] - a[j] * b[i];
    part[k] = mpz_get_d_2exp(&exponent[k], c.get_mpz_t());
    if (part[k] != 0) top = std::max(top, exponent[k]);
  }
  glm::dvec3 r;
  for (int k = 0; k < 3; ++k) {
    r[k] = part[k] == 0 ? 0 : std::ldexp(part[k], static_cast<int>(std::max(exponent[k] - top, -2000l)));
  }
  return r;
}

/// Components of normals are at most 1 and within u = 2^-53, so a component of the product is within 4u (inputs) + 2u
/// (rounded products) + 2u (rounded difference) + O(u^2) < 9u. Where the product is short, that says little about the
/// ray's direction, and it is computed exactly instead.
glm::dvec3 approximate(const SightlineTable& table, SightlineId low, SightlineId high) {
  const glm::dvec3 r = glm::cross(table.approx(low), table.approx(high));
  return largest(r) >= 0x1p-10 ? r : exact_cross(table, low, high);
}

CornerId create(State& s, SightlineId low, SightlineId high, Sign sign) {
  const auto id = static_cast<CornerId>(s.corners.size());
  s.corners.push_back({low, high, sign, approximate(*s.table, low, high) * static_cast<double>(sign)});
  return id;
}

}  // namespace

CornerId add_corner(State& s, SightlineId line, SightlineRef u) {
  s.rays.add();
  s.degree.push_back(2);
  return line < u.id ? create(s, line, u.id, u.sign) : create(s, u.id, line, -u.sign);
}

/// The corner between side a and the next side b of a fragment: the ray n_b x n_a.
static CornerId intern(State& s, SightlineRef a, SightlineRef b) {
  const bool swap = b.id > a.id;
  const SightlineId low = swap ? a.id : b.id, high = swap ? b.id : a.id;
  const Sign sign = swap ? -a.sign * b.sign : a.sign * b.sign;
  const std::uint64_t key = std::uint64_t{low} << 33 | std::uint64_t{high} << 1 | (sign > 0 ? 1u : 0u);
  const std::size_t mask = s.hash_key.size() - 1;
  std::size_t slot = (key * 0x9e3779b97f4a7c15u) >> 20 & mask;
  while (s.hash_key[slot] != key) {
    if (s.hash_key[slot] == ~std::uint64_t{0}) {
      s.hash_key[slot] = key;
      return s.hash_corner[slot] = create(s, low, high, sign);
    }
    slot = (slot + 1) & mask;
  }
  return s.hash_corner[slot];
}

void intern_corners(State& s) {
  const Fragments& f = *s.fragments;
  std::size_t size = 16;
  while (size < 2 * f.sides.size()) size *= 2;
  s.hash_key.assign(size, ~std::uint64_t{0});
  s.hash_corner.resize(size);
  s.corners.clear();
  s.fragment_corners.resize(f.sides.size());
  for (const Fragment& fragment : f.fragments) {
    if (fragment.side_count < 3) throw std::logic_error("stitch: a fragment with fewer than 3 sides");
    const SightlineRef* side = f.sides.data() + fragment.first_side;
    CornerId* corner = s.fragment_corners.data() + fragment.first_side;
    for (std::uint32_t k = 0; k + 1 < fragment.side_count; ++k) corner[k] = intern(s, side[k], side[k + 1]);
    corner[fragment.side_count - 1] = intern(s, side[fragment.side_count - 1], side[0]);
  }
  s.rays.reset(s.corners.size());
}

}  // namespace sightline::stitching
