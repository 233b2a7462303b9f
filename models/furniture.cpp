#include "models/furniture.hpp"

#include <algorithm>
#include <array>

namespace sightline::models {
namespace {

constexpr int m = units_per_metre;

/// By number of polygons. Nothing has an underside that touches the floor, nor a side that touches a wall.
enum Kind : int { nothing = 0, cabinet = 4, chest = 5, chair = 10, desk = 14, table = 22, bookcase = 30, dining = 42 };
constexpr std::array<Kind, 8> kinds{nothing, cabinet, chest, chair, desk, table, bookcase, dining};

/// A piece drawn around the middle of a cell, turned by quarter turns.
struct Place {
  Point middle;  // on the floor
  int turns;

  Point turned(Point p) const {
    for (int k = 0; k < turns; ++k) p = {-p.y, p.x, p.z};
    return middle + p;
  }
  /// Boxes given about the middle; their sides are named before the turn.
  void box(Mesh& mesh, const Point& lo, const Point& hi, unsigned sides) const {
    const auto [a, b] = corners(lo, hi);
    mesh.box(a, b, turned(sides));
  }
  void hollow(Mesh& mesh, const Point& lo, const Point& hi, unsigned sides) const {
    const auto [a, b] = corners(lo, hi);
    mesh.hollow(a, b, turned(sides));
  }

 private:
  unsigned turned(unsigned sides) const {
    static constexpr std::array<unsigned, 4> ring{left, front, right, back};  // a turn takes each to the next
    unsigned after = sides & (bottom | top);
    for (std::size_t k = 0; k < 4; ++k) {
      if (sides & ring[k]) after |= ring[(k + static_cast<std::size_t>(turns)) % 4];
    }
    return after;
  }
  std::array<Point, 2> corners(const Point& lo, const Point& hi) const {
    const Point a = turned(lo), b = turned(hi);
    return {Point(std::min(a.x, b.x), std::min(a.y, b.y), lo.z + middle.z),
            Point(std::max(a.x, b.x), std::max(a.y, b.y), hi.z + middle.z)};
  }
};

void add_chair(Mesh& mesh, const Place& at, const Point& centre, bool towards_front) {
  const int seat = 7, back_y = towards_front ? 2 : -4;
  at.box(mesh, centre + Point(-4, -4, 0), centre + Point(4, 4, seat), standing);
  at.box(mesh, centre + Point(-4, back_y, seat), centre + Point(4, back_y + 2, m), standing);
}

void add_table(Mesh& mesh, const Place& at, int half_x, int half_y) {
  at.box(mesh, {-half_x, -half_y, 11}, {half_x, half_y, 12}, all);
  for (const int x : {-half_x, half_x - 1}) {
    for (const int y : {-half_y, half_y - 1}) at.box(mesh, {x, y, 0}, {x + 1, y + 1, 11}, around);
  }
}

/// Open to the front, its back on the wall: four compartments one on the other.
void add_bookcase(Mesh& mesh, const Place& at, int half, int wall) {
  constexpr int depth = 6, compartments = 4, board = 1, pitch = 9;
  const int y = wall - depth, height = compartments * pitch + board;
  at.box(mesh, {-half, y, 0}, {half, wall, height}, left | right | top);
  at.box(mesh, {-half, y, 0}, {-half + board, y, height}, front);
  at.box(mesh, {half - board, y, 0}, {half, y, height}, front);
  for (int k = 0; k <= compartments; ++k) {
    const int z = k * pitch;
    at.box(mesh, {-half + board, y, z}, {half - board, y, z + board}, front);
    if (k == compartments) break;
    at.hollow(mesh, {-half + board, y, z + board}, {half - board, wall - board, z + pitch}, all & ~unsigned{front});
  }
}

void add_piece(Mesh& mesh, const Place& at, Kind kind, bool window, RandomNumbers& random) {
  const int wall = cell_size / 2 - half_wall;
  switch (kind) {
    case nothing:
      break;
    case cabinet: {  // its back on the wall at the back
      const int half = random.between(8, 16), depth = random.between(6, 10);
      at.box(mesh, {-half, wall - depth, 0}, {half, wall, window ? 12 : random.between(12, 34)},
             standing & ~unsigned{back});
      break;
    }
    case chest: {
      const Point lo{-random.between(5, 12), -random.between(4, 8), 0};
      const Point hi{random.between(5, 12), random.between(4, 8), random.between(8, 20)};
      at.box(mesh, lo, hi, standing);
      break;
    }
    case chair: {
      const Point centre{random.between(-8, 8), random.between(-8, 8), 0};
      add_chair(mesh, at, centre, random.chance(1, 2));
      break;
    }
    case desk:
      at.box(mesh, {-13, -6, 11}, {13, 6, 12}, all);
      for (const int x : {-12, 11}) at.box(mesh, {x, -5, 0}, {x + 1, 5, 11}, around);
      break;
    case table: {
      const int half_x = random.between(8, 14);
      add_table(mesh, at, half_x, random.between(6, 12));
      break;
    }
    case bookcase:
      add_bookcase(mesh, at, random.between(9, 16), wall);
      break;
    case dining:
      add_table(mesh, at, 12, 6);
      add_chair(mesh, at, {0, -11, 0}, false);
      add_chair(mesh, at, {0, 11, 0}, true);
      break;
  }
}

enum class Wall { none, blind, with_window };

/// A kind whose number of polygons is `budget / places` on average. Every other one is drawn from what is large, so
/// that rooms differ.
Kind draw(std::int64_t budget, std::int64_t places, Wall wall, RandomNumbers& random) {
  std::size_t less = 0;
  while (less + 2 < kinds.size() && kinds[less + 1] * places <= budget) ++less;
  std::size_t more = less + 1;
  if (random.chance(1, 2)) {
    less = 0;
    more =
        std::max(more, wall == Wall::blind && random.chance(2, 3) ? 6 : static_cast<std::size_t>(random.between(2, 7)));
  }
  const std::int64_t span = (kinds[more] - kinds[less]) * places, excess = budget - kinds[less] * places;
  const Kind kind = random.below(1 << 20) * span < (excess << 20) ? kinds[more] : kinds[less];
  if (kind > budget) return nothing;
  if (kind == cabinet && wall == Wall::none) return budget < chest ? nothing : chest;
  return kind == bookcase && wall != Wall::blind ? table : kind;
}

/// Where the back is after so many quarter turns.
constexpr std::array<glm::ivec2, 4> backs{glm::ivec2(0, 1), glm::ivec2(-1, 0), glm::ivec2(0, -1), glm::ivec2(1, 0)};

/// How often a cell must be turned for its back to be at a wall; -1 if it is at none.
int turns_to_wall(const Plan& plan, Cell c) {
  for (int k = 0; k < 4; ++k) {
    if (plan.room(c + backs[static_cast<std::size_t>(k)]) != plan.room(c)) return k;
  }
  return -1;
}

}  // namespace

void furnish(Mesh& mesh, const std::vector<Storey>& storeys, const std::vector<Cell>& cells, int budget,
             RandomNumbers& random) {
  std::int64_t places = static_cast<std::int64_t>(storeys.size() * cells.size());
  for (const Storey& storey : storeys) {
    for (const Cell c : cells) {
      const int turns = turns_to_wall(storey.plan, c);
      const Wall wall = turns < 0 ? Wall::none
                        : storey.plan.between(c, c + backs[static_cast<std::size_t>(turns)]) == Opening::none
                            ? Wall::blind
                            : Wall::with_window;
      const Kind kind = draw(budget, places--, wall, random);
      if (kind == nothing) continue;
      mesh.object(storey.name() + " room " + std::to_string(storey.plan.room(c)) + " furniture");
      const Point middle(c.x * cell_size + cell_size / 2, c.y * cell_size + cell_size / 2, storey.floor());
      const std::uint32_t before = mesh.size();
      add_piece(mesh, {middle, turns >= 0 ? turns : random.below(4)}, kind, wall == Wall::with_window, random);
      budget -= static_cast<int>(mesh.size() - before);
    }
  }
}

}  // namespace sightline::models
