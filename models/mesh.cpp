#include "models/mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace sightline::models {
namespace {

std::uint64_t pack(const Point& p) {
  constexpr std::int64_t bias = 1 << 20;
  return static_cast<std::uint64_t>(p.x + bias) << 42 | static_cast<std::uint64_t>(p.y + bias) << 21 |
         static_cast<std::uint64_t>(p.z + bias);
}

std::size_t home_slot(std::uint64_t key, std::size_t slot_count) {
  // The upper bits of the product: only they depend on all of the key. The number of slots is a power of two.
  return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> (64 - std::countr_zero(slot_count)));
}

}  // namespace

void Mesh::object(const std::string& name) {
  const auto [entry, fresh] = objects_.try_emplace(name, static_cast<std::uint32_t>(soup_.objects.size()));
  if (fresh) soup_.objects.push_back(name);
  object_ = entry->second;
}

void Mesh::grow() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), none);
  for (std::uint32_t v = 0; v < keys_.size(); ++v) {
    std::size_t slot = home_slot(keys_[v], slots_.size());
    while (slots_[slot] != none) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = v;
  }
}

std::uint32_t Mesh::vertex(const Point& p) {
  if (2 * keys_.size() >= slots_.size()) grow();
  const std::uint64_t key = pack(p);
  std::size_t slot = home_slot(key, slots_.size());
  while (slots_[slot] != none) {
    if (keys_[slots_[slot]] == key) return slots_[slot];
    slot = (slot + 1) & (slots_.size() - 1);
  }
  slots_[slot] = static_cast<std::uint32_t>(keys_.size());
  keys_.push_back(key);
  soup_.vertices.push_back(glm::dvec3(p) / static_cast<double>(units_per_metre));
  return slots_[slot];
}

void Mesh::polygon(std::span<const Point> corners) {
  for (const Point& p : corners) soup_.corners.push_back(vertex(p));
  soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
  soup_.object_of.push_back(object_);
}

void Mesh::box_sides(const Point& lo, const Point& hi, unsigned sides, bool inside) {
  const auto corner = [&](int i) { return Point(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z); };
  // Corner i has bit 0 for hi.x, bit 1 for hi.y, bit 2 for hi.z; counter-clockwise from outside.
  static constexpr std::array<std::array<int, 4>, 6> rings{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (unsigned side = 0; side < 6; ++side) {
    if (!(sides & 1u << side)) continue;
    std::array<Point, 4> ring;
    for (std::size_t k = 0; k < 4; ++k) ring[k] = corner(rings[side][inside ? 3 - k : k]);
    polygon(ring);
  }
}

void Mesh::box(const Point& lo, const Point& hi, unsigned sides) { box_sides(lo, hi, sides, false); }
void Mesh::hollow(const Point& lo, const Point& hi, unsigned sides) { box_sides(lo, hi, sides, true); }

PolygonSoup Mesh::take(const std::string& source) {
  PolygonSoup soup = std::move(soup_);
  soup.source = source;
  *this = Mesh{};
  return soup;
}

}  // namespace sightline::models
