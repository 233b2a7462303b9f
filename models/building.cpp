// An office floor, and a building of such floors with stairs, after the models of Soda Hall.
#include "models/floor_plan.hpp"
#include "models/furniture.hpp"
#include "models/generators.hpp"
#include "models/stairs.hpp"
#include "models/walk.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace sightline::models {
namespace {

constexpr double eye_height = 1.625;
constexpr int base = -units_per_metre / 4;  // the ground: a step below the lowest floor

struct Layout {
  FloorLayout floor;
  int levels = 1;
};

/// Walls, floors, ceilings, stairs and what is around them, but for the roof and the furniture.
void add_structure(Mesh& mesh, FloorPlan& floor, int levels, bool ground) {
  const int x = floor.plan.columns() * cell_size + half_wall, y = floor.plan.rows() * cell_size + half_wall;
  const int margin = ground ? 16 * units_per_metre : 0;
  mesh.object(ground ? "ground" : "underside");
  mesh.box({-half_wall - margin, -half_wall - margin, base}, {x + margin, y + margin, base}, ground ? top : bottom);
  const Opening above = floor.plan.opening(floor.entrance, {1, 0});
  for (int level = 0; level < levels; ++level) {
    // Only the lowest storey has the front door.
    floor.plan.opening(floor.entrance, {1, 0}) = ground && level == 0 ? Opening::door : above;
    const Storey storey{floor.plan, floor.shaft, level, levels};
    add_storey(mesh, storey, level == 0 ? base : storey.floor());
    if (level + 1 == levels) continue;
    for (const Cell corner : floor.shafts) add_stairs(mesh, corner, level);
  }
  floor.plan.opening(floor.entrance, {1, 0}) = above;
}

/// `strips` polygons in one plane.
void add_roof(Mesh& mesh, const Plan& plan, int levels, int strips) {
  mesh.object("roof");
  const int x0 = -half_wall, x1 = plan.columns() * cell_size + half_wall;
  const int y0 = -half_wall, y1 = plan.rows() * cell_size + half_wall, z = levels * storey_height;
  const auto cut = [&](int k) { return k == strips ? x1 : x0 + (x1 - x0) / strips * k; };
  for (int k = 0; k < strips; ++k)
    mesh.polygon({{cut(k), y0, z}, {cut(k + 1), y0, z}, {cut(k + 1), y1, z}, {cut(k), y1, z}});
}

Waypoint waypoint(Cell c, int level) {
  const glm::dvec3 at(c.x * cell_size + cell_size / 2, c.y * cell_size + cell_size / 2, level * storey_height);
  return {at / static_cast<double>(units_per_metre) + glm::dvec3(0, 0, eye_height)};
}

/// The way through the rooms on the lowest storey and, with stairs, half of it again on the one above. The cells it
/// needs are marked in `used`.
std::vector<Waypoint> route(const FloorPlan& floor, int levels, std::vector<char>& used) {
  std::vector<Waypoint> way;
  const auto go = [&](Cell from, Cell to, int level, const std::vector<char>& shunned) {
    for (const Cell c : floor.plan.way(from, to, shunned)) {
      used[static_cast<std::size_t>(c.y * floor.plan.columns() + c.x)] = 1;
      if (way.empty() || way.back().at != waypoint(c, level).at) way.push_back(waypoint(c, level));
    }
  };
  Cell at = floor.entrance;
  for (const Cell c : floor.visits) {
    go(at, c, 0, floor.shaft);
    at = c;
  }
  if (levels == 1 || floor.shafts.empty()) return way;
  const Cell corner = floor.shafts.front(), corridor = corner + Cell(1, 2);  // before the door to the stairs
  go(at, corridor, 0, floor.shaft);
  const std::vector<Waypoint> up = way_upstairs(corner, 0, eye_height);
  way.insert(way.end(), up.begin(), up.end());
  at = corridor;
  way.push_back(waypoint(at, 1));
  for (std::size_t k = 0; k < std::min<std::size_t>(3, floor.visits.size()); ++k) {
    go(at, floor.visits[k], 1, floor.shaft);
    at = floor.visits[k];
  }
  return way;
}

/// The cells that may be furnished: in rooms, not before a door, not on the way.
std::vector<Cell> furnishable(const FloorPlan& floor, const std::vector<char>& used) {
  std::vector<Cell> cells;
  for (int y = 0; y < floor.plan.rows(); ++y) {
    for (int x = 0; x < floor.plan.columns(); ++x) {
      const auto room = static_cast<std::size_t>(floor.plan.room({x, y}));
      if (floor.corridor[room] || floor.shaft[room] || floor.plan.has_door({x, y})) continue;
      if (!used[static_cast<std::size_t>(y * floor.plan.columns() + x)]) cells.emplace_back(x, y);
    }
  }
  return cells;
}

/// Builds the layout with exactly `polygons` polygons, or nothing when its structure alone has more.
std::optional<Model> build(const std::string& name, const Layout& layout, int polygons, std::uint64_t seed,
                           bool ground) {
  Mesh mesh;
  FloorPlan floor = make_floor_plan(layout.floor, layout.levels > 1);
  add_structure(mesh, floor, layout.levels, ground);
  const int structure = static_cast<int>(mesh.size()) + 1;
  if (structure > polygons) return std::nullopt;

  std::vector<char> used(static_cast<std::size_t>(floor.plan.columns() * floor.plan.rows()));
  const std::vector<Waypoint> way = route(floor, layout.levels, used);
  std::vector<Storey> storeys;
  for (int level = 0; level < layout.levels; ++level)
    storeys.push_back({floor.plan, floor.shaft, level, layout.levels});
  RandomNumbers random(seed);
  furnish(mesh, storeys, furnishable(floor, used), polygons - structure, random);
  add_roof(mesh, floor.plan, layout.levels, polygons - static_cast<int>(mesh.size()));
  return Model{mesh.take(name),
               walk(way, walk_cameras, {.corner = 1.25, .behind = 0.5, .ahead = 3.5, .yaw = 0.2, .yaw_waves = 7})};
}

/// About how many polygons the structure has: measured, to a few in a hundred.
double estimated_structure(const Layout& layout) {
  const double modules = layout.floor.modules_x * layout.floor.modules_y;
  const double cells_of_outer_wall = 2.0 * (8 * layout.floor.modules_x + 7 * layout.floor.modules_y);
  const double windows = layout.floor.window_spacing == 0 ? 0 : cells_of_outer_wall / layout.floor.window_spacing;
  return layout.levels * (183 * modules + 10 * windows);
}

/// The layout whose structure is about a third of the polygons and whose proportions are good: about five levels
/// on a floor of two modules, and so on in proportion. `levels`: as many, 0 for any number.
Layout choose_layout(int polygons, int levels) {
  if (polygons < 260) return {{1, 1, 0, (polygons - 9) / 10}, 1};
  Layout best;
  double best_cost = 1e9;
  for (int x = 1; x <= 256; ++x) {
    for (int y = std::max(1, x - 1); y <= x; ++y) {
      for (int level = std::max(1, levels); level <= (levels ? levels : 128); ++level) {
        for (int spacing = 0; spacing <= 3; ++spacing) {
          const Layout layout{{x, y, spacing, 0}, level};
          const double part = estimated_structure(layout) / polygons;
          if (part > 0.9) continue;
          const double tall = levels ? 0 : std::abs(level - 2.5 * x) / level;
          const double cost = std::abs(part - 0.36) + 0.1 * tall + (spacing == 2 ? 0 : 0.2);
          if (cost < best_cost) {
            best_cost = cost;
            best = layout;
          }
        }
      }
    }
  }
  return best;
}

Model make_storeys(const std::string& name, std::uint32_t polygons, int levels, std::uint64_t seed) {
  if (polygons < 24 || polygons > 4'000'000) throw std::invalid_argument(name + ": polygons must be 24 to 4000000");
  const int count = static_cast<int>(polygons);
  std::optional<Model> model = build(name, choose_layout(count, levels), count, seed, levels == 0);
  if (!model) throw std::logic_error(name + ": no layout for " + std::to_string(polygons) + " polygons");
  return std::move(*model);
}

}  // namespace

Model make_floor(std::uint32_t polygons, std::uint64_t seed) { return make_storeys("floor", polygons, 1, seed); }
Model make_building(std::uint32_t polygons, std::uint64_t seed) { return make_storeys("building", polygons, 0, seed); }

}  // namespace sightline::models
