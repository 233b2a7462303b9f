#include "models/plan.hpp"

#include <algorithm>
#include <array>

namespace sightline::models {
namespace {

constexpr std::array<glm::ivec2, 4> directions{glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(-1, 0),
                                               glm::ivec2(0, -1)};

/// Whether a cell is the room, or any room when `outside` is asked for.
bool member(const Plan& plan, Cell c, int room) {
  return room == Plan::outside ? plan.room(c) != Plan::outside : plan.room(c) == room;
}

}  // namespace

Plan::Plan(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      rooms_(static_cast<std::size_t>(columns * rows), outside),
      upright_(static_cast<std::size_t>((columns + 1) * (rows + 1)), Opening::none),
      level_(upright_) {}

void Plan::set_room(Cell c, int room) {
  rooms_[index(c)] = room;
  if (room >= room_count_) {
    room_count_ = room + 1;
    first_cell_.resize(static_cast<std::size_t>(room_count_), Cell(columns_, rows_));
  }
  Cell& first = first_cell_[static_cast<std::size_t>(room)];
  if (c.y < first.y || (c.y == first.y && c.x < first.x)) first = c;
}

Opening Plan::between(Cell c, Cell neighbour) const {
  return opening({std::max(c.x, neighbour.x), std::max(c.y, neighbour.y)},
                 {c.x != neighbour.x ? 1 : 0, c.y != neighbour.y ? 1 : 0});
}

bool Plan::connected(Cell c, Cell neighbour) const {
  return room(c) == room(neighbour) || between(c, neighbour) == Opening::door;
}

bool Plan::has_door(Cell c) const {
  return std::any_of(directions.begin(), directions.end(),
                     [&](glm::ivec2 d) { return between(c, c + d) == Opening::door; });
}

std::vector<Cell> Plan::outline(int room) const {
  const Cell start = room == outside ? Cell(0) : first_cell_[static_cast<std::size_t>(room)];
  std::vector<Cell> corners{start};
  Cell at = start;
  glm::ivec2 d(1, 0);
  while (true) {
    at += d;
    if (at == start) return corners;
    const glm::ivec2 n = left_of(d);
    if (member(*this, at + (d - n - 1) / 2, room)) {
      corners.push_back(at);
      d = -n;
    } else if (!member(*this, at + (d + n - 1) / 2, room)) {
      corners.push_back(at);
      d = n;
    }
  }
}

std::vector<Cell> Plan::way(Cell from, Cell to, const std::vector<char>& shunned) const {
  std::vector<Cell> came(rooms_.size(), Cell(-1)), queue{to};
  came[index(to)] = to;
  for (std::size_t k = 0; k < queue.size() && came[index(from)].x < 0; ++k) {
    for (const glm::ivec2 d : directions) {
      const Cell n = queue[k] + d;
      if (room(n) == outside || !connected(queue[k], n) || came[index(n)].x >= 0) continue;
      if (shunned[static_cast<std::size_t>(room(n))]) continue;
      came[index(n)] = queue[k];
      queue.push_back(n);
    }
  }
  std::vector<Cell> cells;
  if (came[index(from)].x < 0) return cells;
  cells.push_back(from);
  while (cells.back() != to) cells.push_back(came[index(cells.back())]);
  return cells;
}

}  // namespace sightline::models
