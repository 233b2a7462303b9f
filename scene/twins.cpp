#include "scene/twins.hpp"

#include <algorithm>
#include <bit>

namespace sightline {
namespace {

/// Spreads every bit of the key over the whole word (the finalizer of splitmix64).
std::uint64_t mixed(std::uint64_t key) {
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
  return key ^ (key >> 31);
}

/// Open addressing over indices 0..count-1 that are added in ascending order: add() returns the index of an equal
/// element added before, or the element's own.
class FirstOfEqual {
 public:
  explicit FirstOfEqual(std::size_t count) : slots_(std::bit_ceil(2 * count + 1), none), hashes_(count) {}

  template <class Equal>
  std::uint32_t add(std::uint32_t index, std::uint64_t hash, const Equal& equal) {
    const std::size_t mask = slots_.size() - 1;
    hashes_[index] = hash;
    for (std::size_t slot = hash & mask;; slot = (slot + 1) & mask) {
      const std::uint32_t other = slots_[slot];
      if (other == none) return slots_[slot] = index;
      if (hashes_[other] == hash && equal(other, index)) return other;
    }
  }

 private:
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint64_t> hashes_;
};

}  // namespace

std::vector<PointId> lowest_equal(const PointTable& points) {
  std::vector<PointId> result(points.size());
  FirstOfEqual seen(points.size());
  for (PointId p = 0; p < points.size(); ++p) {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Limbs c = points.coordinate(p, axis);
      for (std::uint32_t k = 0; k < c.count; ++k) hash = mixed(hash + 0x9e3779b97f4a7c15u + c.words[k]);
    }
    result[p] = seen.add(p, hash, [&](PointId a, PointId b) { return points.equal(a, b); });
  }
  return result;
}

std::uint32_t count_duplicates(std::span<const std::uint32_t> first, std::span<const std::uint32_t> corners,
                               std::span<const PointId> representative) {
  const auto polygons = static_cast<std::uint32_t>(first.size() - 1);
  std::vector<PointId> sets(corners.size());  // each polygon's vertices, ascending, each once, in front of its range
  std::vector<std::uint32_t> sizes(polygons);
  FirstOfEqual seen(polygons);
  std::uint32_t duplicates = 0;
  const auto set = [&](std::uint32_t k) { return std::span<const PointId>(sets).subspan(first[k], sizes[k]); };
  for (std::uint32_t k = 0; k < polygons; ++k) {
    const auto begin = sets.begin() + first[k];
    auto end = begin;
    for (std::uint32_t i = first[k]; i < first[k + 1]; ++i) *end++ = representative[corners[i]];
    std::sort(begin, end);
    sizes[k] = static_cast<std::uint32_t>(std::unique(begin, end) - begin);
    std::uint64_t hash = 0;
    for (PointId p : set(k)) hash = mixed(hash + 0x9e3779b97f4a7c15u + p);
    const auto equal = [&](std::uint32_t a, std::uint32_t b) { return std::ranges::equal(set(a), set(b)); };
    duplicates += seen.add(k, hash, equal) != k;
  }
  return duplicates;
}

}  // namespace sightline
