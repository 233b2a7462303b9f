#include "sample/bitfield_connect.hpp"

#include "exact/sightline_table.hpp"

#include <algorithm>
#include <tuple>

namespace sightline {
namespace {

enum Shows : unsigned { nothing = 0, front = 1, back = 2 };

unsigned other_side(unsigned shows) { return (shows & front) << 1 | (shows & back) >> 1; }

/// Which sides of its pieces a polygon shows; front is where its vertices run counter-clockwise.
unsigned shown(const Scene& scene, SightlineTable& eye, PolygonId p) {
  unsigned shows = nothing;
  for (const Surface& s : scene.surfaces(p)) {
    const Sign side = eye.eye_side(s.plane) * (s.flipped ? -1 : 1);
    if (side > 0) shows |= front;
    if (side < 0 && !scene.options().one_sided) shows |= back;
  }
  return shows;
}

}  // namespace

PolygonNeighbours::PolygonNeighbours(const Scene& scene) {
  struct Side {
    std::uint32_t a, b;  // a < b
    PolygonId polygon;
    bool upwards;  // it runs from a to b
  };
  std::vector<Side> sides;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (scene.surfaces(p).empty()) continue;
    const auto corners = scene.corners(p);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const PointId a = scene.lowest_twin(corners[k]), b = scene.lowest_twin(corners[(k + 1) % corners.size()]);
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), p, a < b});
    }
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.a, s.b, s.polygon, s.upwards); });
  struct Pair {
    PolygonId polygon;
    Neighbour neighbour;
  };
  std::vector<Pair> pairs;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].a == sides[begin].a && sides[end].b == sides[begin].b) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = begin; j < end; ++j) {
        if (sides[i].polygon == sides[j].polygon) continue;
        pairs.push_back({sides[i].polygon, {sides[j].polygon, sides[i].upwards != sides[j].upwards}});
      }
    }
  }
  const auto key = [](const Pair& p) { return std::tuple(p.polygon, p.neighbour.polygon, p.neighbour.alike); };
  std::ranges::sort(pairs, {}, key);
  const auto same = [&](const Pair& p, const Pair& q) { return key(p) == key(q); };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
  first_.resize(scene.polygon_count() + std::size_t{1});
  for (const Pair& p : pairs) {
    ++first_[p.polygon + std::size_t{1}];
    neighbours_.push_back(p.neighbour);
  }
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
}

void fill_in(const Scene& scene, const PolygonNeighbours& neighbours, const glm::dvec3& eye, unsigned rounds,
             IdBitfield& field) {
  if (rounds == 0) return;
  SightlineTable table(scene.planes());
  table.reset(scene.planes(), scene.grid().point(eye));
  constexpr unsigned unknown = 4;
  std::vector<unsigned> shows(scene.polygon_count(), unknown);
  const auto sides = [&](PolygonId p) {
    if (shows[p] == unknown) shows[p] = shown(scene, table, p);
    return shows[p];
  };
  std::vector<PolygonId> border = field.list(), next;
  for (; rounds > 0 && !border.empty(); --rounds) {
    next.clear();
    for (const PolygonId p : border) {
      for (const auto& [q, alike] : neighbours.of(p)) {
        if (field.test(q)) continue;
        const unsigned wanted = alike ? sides(p) : other_side(sides(p));
        if ((sides(q) & wanted) != nothing) next.push_back(q);
      }
    }
    // All of a round at once: what it adds does not depend on the order.
    std::ranges::sort(next);
    next.erase(std::unique(next.begin(), next.end()), next.end());
    for (const PolygonId q : next) field.set(q);
    border.swap(next);
  }
}

}  // namespace sightline
