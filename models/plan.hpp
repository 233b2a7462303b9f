// The plan of a storey: square cells, rooms made of them, and openings in the walls between.
#pragma once

#include "models/mesh.hpp"

#include <glm/vec2.hpp>
#include <vector>

namespace sightline::models {

using Cell = glm::ivec2;  // column, row; also a corner of the grid: the least corner of that cell

enum class Opening : std::uint8_t { none, door, window };

inline constexpr int cell_size = 3 * units_per_metre;  // of the grid, to the middle of the walls
inline constexpr int half_wall = 2;

class Plan {
 public:
  static constexpr int outside = -1;

  Plan(int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int room_count() const { return room_count_; }
  bool contains(Cell c) const { return c.x >= 0 && c.x < columns_ && c.y >= 0 && c.y < rows_; }
  int room(Cell c) const { return contains(c) ? rooms_[index(c)] : outside; }
  void set_room(Cell c, int room);

  /// The opening in the wall towards the cell on the left of c (side.x = 1), or below it (side.y = 1). Cells may lie
  /// one beyond the last column or row.
  Opening& opening(Cell c, glm::ivec2 side) { return (side.x ? upright_ : level_)[wall_index(c)]; }
  Opening opening(Cell c, glm::ivec2 side) const { return (side.x ? upright_ : level_)[wall_index(c)]; }
  /// The opening between neighbours.
  Opening between(Cell c, Cell neighbour) const;
  /// True if one can walk from a cell to its neighbour.
  bool connected(Cell c, Cell neighbour) const;
  bool has_door(Cell c) const;

  /// Corners of a room's outline, counter-clockwise; rooms have no holes. `outside`: of all cells together.
  std::vector<Cell> outline(int room) const;
  /// A shortest walk from cell to cell, both included, without entering `shunned` rooms; empty when there is none.
  std::vector<Cell> way(Cell from, Cell to, const std::vector<char>& shunned) const;

 private:
  std::size_t index(Cell c) const { return static_cast<std::size_t>(c.y * columns_ + c.x); }
  std::size_t wall_index(Cell c) const { return static_cast<std::size_t>(c.y * (columns_ + 1) + c.x); }

  int columns_, rows_, room_count_ = 0;
  std::vector<int> rooms_;
  std::vector<Cell> first_cell_;  // per room: lowest, then leftmost
  std::vector<Opening> upright_, level_;
};

/// The left normal of a direction in the plane.
inline glm::ivec2 left_of(glm::ivec2 d) { return {-d.y, d.x}; }

}  // namespace sightline::models
