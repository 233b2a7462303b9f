#include "visibility_map/stitch_state.hpp"

#include <numeric>

namespace sightline::stitching {

void Sets::reset(std::size_t n) {
  parent.resize(n);
  std::iota(parent.begin(), parent.end(), 0u);
}

std::uint32_t Sets::add() {
  const auto k = static_cast<std::uint32_t>(parent.size());
  parent.push_back(k);
  return k;
}

void Sets::unite(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  if (a < b) {
    parent[b] = a;
  } else {
    parent[a] = b;
  }
}

}  // namespace sightline::stitching
