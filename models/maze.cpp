// A maze of panels without thickness between a floor and a ceiling, after the one by Seth Teller.
#include "models/generators.hpp"
#include "models/mesh.hpp"
#include "models/random_numbers.hpp"
#include "models/walk.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace sightline::models {
namespace {

constexpr int cell = 2 * units_per_metre, height = 3 * units_per_metre;
constexpr std::array<std::array<int, 2>, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Cells of a grid and the walls between them: wall d of cell c stands towards steps[d].
class Maze {
 public:
  Maze(int columns, int rows) : columns_(columns), rows_(rows), open_(static_cast<std::size_t>(columns * rows) * 4) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int cells() const { return columns_ * rows_; }
  bool open(int c, int d) const { return open_[static_cast<std::size_t>(4 * c + d)]; }
  /// The next cell in direction d, -1 beyond the border.
  int next(int c, int d) const {
    const int x = c % columns_ + steps[static_cast<std::size_t>(d)][0];
    const int y = c / columns_ + steps[static_cast<std::size_t>(d)][1];
    return x < 0 || x >= columns_ || y < 0 || y >= rows_ ? -1 : y * columns_ + x;
  }
  void tear_down(int c, int d) {
    open_[static_cast<std::size_t>(4 * c + d)] = true;
    open_[static_cast<std::size_t>(4 * next(c, d) + (d ^ 2))] = true;
  }

  /// Depth-first: afterwards there is exactly one way between any two cells.
  void carve(RandomNumbers& random) {
    std::vector<char> reached(static_cast<std::size_t>(cells()));
    std::vector<int> trail{0};
    reached[0] = 1;
    while (!trail.empty()) {
      const int c = trail.back();
      std::array<int, 4> ways{};
      int count = 0;
      for (int d = 0; d < 4; ++d) {
        const int n = next(c, d);
        if (n >= 0 && !reached[static_cast<std::size_t>(n)]) ways[static_cast<std::size_t>(count++)] = d;
      }
      if (count == 0) {
        trail.pop_back();
        continue;
      }
      const int d = ways[static_cast<std::size_t>(random.below(count))];
      tear_down(c, d);
      trail.push_back(next(c, d));
      reached[static_cast<std::size_t>(trail.back())] = 1;
    }
  }

  /// Tears down `count` more of the walls that are left inside.
  void braid(int count, RandomNumbers& random) {
    while (count > 0) {
      const int c = random.below(cells()), d = random.below(2);
      if (next(c, d) < 0 || open(c, d)) continue;
      tear_down(c, d);
      --count;
    }
  }

  /// A shortest way from `from` to the cell that is farthest away, in reverse.
  std::vector<int> longest_way(int from) const {
    std::vector<int> came(static_cast<std::size_t>(cells()), -1), queue{from};
    came[static_cast<std::size_t>(from)] = from;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      for (int d = 0; d < 4; ++d) {
        if (!open(queue[k], d)) continue;
        const int n = next(queue[k], d);
        if (came[static_cast<std::size_t>(n)] >= 0) continue;
        came[static_cast<std::size_t>(n)] = queue[k];
        queue.push_back(n);
      }
    }
    std::vector<int> way{queue.back()};
    while (way.back() != from) way.push_back(came[static_cast<std::size_t>(way.back())]);
    return way;
  }

 private:
  int columns_, rows_;
  std::vector<char> open_;
};

void panel(Mesh& mesh, const Point& a, const Point& b) {
  const Point up(0, 0, height);
  mesh.polygon({a, b, b + up, a + up});
}

/// The wall of cell c towards steps[d]; seen from the cell it runs counter-clockwise.
void wall(Mesh& mesh, const Maze& maze, int c, int d) {
  const int x = c % maze.columns() * cell, y = c / maze.columns() * cell;
  const std::array<Point, 4> ring{Point(x + cell, y, 0), Point(x + cell, y + cell, 0), Point(x, y + cell, 0),
                                  Point(x, y, 0)};
  panel(mesh, ring[static_cast<std::size_t>(d + 1) % 4], ring[static_cast<std::size_t>(d)]);
}

/// Columns and rows. A perfect maze of c x r cells has (c+1)(r+1) walls, its border's included. Up to twice as many as
/// wanted are built and torn down again, fewer where the border would take more than half of them.
std::array<int, 2> choose_size(int walls) {
  for (int wanted = 2 * walls;; wanted = wanted * 9 / 10) {
    wanted = std::max(wanted, walls + walls / 6);
    int side = 1;
    while (side * side < wanted) ++side;
    const int columns = side - 1, rows = (wanted + side - 1) / side - 1;
    if (4 * (columns + rows) <= walls || wanted == walls + walls / 6) return {columns, rows};
  }
}

}  // namespace

Model make_maze(std::uint32_t polygons, std::uint64_t seed) {
  if (polygons < 24 || polygons > 4'000'000) throw std::invalid_argument("maze: polygons must be 24 to 4000000");
  const int walls = static_cast<int>(polygons) - 2;
  const auto [columns, rows] = choose_size(walls);

  RandomNumbers random(seed);
  Maze maze(columns, rows);
  maze.carve(random);
  maze.braid((columns + 1) * (rows + 1) - walls, random);

  Mesh mesh;
  mesh.object("floor and ceiling");
  mesh.hollow({0, 0, 0}, {columns * cell, rows * cell, height}, top | bottom);
  for (int c = 0; c < maze.cells(); ++c) {
    if (c % columns == 0) mesh.object("walls of row " + std::to_string(c / columns));
    for (int d = 0; d < 4; ++d) {
      if (!maze.open(c, d) && (d < 2 || maze.next(c, d) < 0)) wall(mesh, maze, c, d);
    }
  }

  std::vector<Waypoint> way;
  for (const int c : maze.longest_way(maze.longest_way(0).front())) {
    way.push_back({{2 * (c % columns) + 1, 2 * (c / columns) + 1, 1.625}});
    if (way.size() > 300) break;
  }
  return {mesh.take("maze"),
          walk(way, walk_cameras, {.corner = 0.75, .behind = 0, .ahead = 4, .yaw = 0.15, .yaw_waves = 7})};
}

}  // namespace sightline::models
