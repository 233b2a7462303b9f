#include "models/floor_plan.hpp"

#include <array>
#include <string_view>

namespace sightline::models {
namespace {

constexpr int module_x = 8, module_y = 7;

/// One module, upper row first. The corridor C comes in on the left, bends twice, and leaves on the right; every other
/// module is mirrored, so it goes on from module to module, and no straight part of it is longer than one module.
constexpr std::array<std::string_view, module_y> drawing{"aaabbccc",  //
                                                         "aaabbccc",  //
                                                         "CCCCCeee",  //
                                                         "ddddCeee",  //
                                                         "ddddCCCC",  //
                                                         "fffgghhh",  //
                                                         "fffgghhh"};
constexpr std::string_view letters = "Cabcdefgh";
constexpr int rooms_per_module = static_cast<int>(letters.size());
constexpr int stair_room = static_cast<int>(letters.find('g'));
constexpr int corridor_in = 4, corridor_out = 2;  // rows

/// Doors below these cells; doors in a line with each other are avoided.
constexpr std::array<Cell, 7> doors_below{Cell(2, 5), Cell(4, 5), Cell(6, 5), Cell(1, 4),
                                          Cell(5, 3), Cell(2, 2), Cell(6, 2)};
constexpr Cell stair_door(4, 2), through_door(3, 0);
/// Windows between rooms and corridor, below these cells.
constexpr std::array<Cell, 6> panes_below{Cell(0, 5), Cell(1, 5), Cell(3, 4), Cell(7, 3), Cell(5, 2), Cell(7, 2)};

/// Where a module's cells are in the plan.
struct Module {
  int i, j;

  bool mirrored() const { return i % 2 == 1; }
  Cell cell(Cell c) const { return {i * module_x + (mirrored() ? module_x - 1 - c.x : c.x), j * module_y + c.y}; }
};

void add_module(Plan& plan, const Module& module, int first_room, bool last_column, bool has_stairs) {
  for (int y = 0; y < module_y; ++y) {
    for (int x = 0; x < module_x; ++x) {
      const char letter = drawing[static_cast<std::size_t>(module_y - 1 - y)][static_cast<std::size_t>(x)];
      plan.set_room(module.cell({x, y}), first_room + static_cast<int>(letters.find(letter)));
    }
  }
  const glm::ivec2 below(0, 1);
  for (const Cell c : doors_below) plan.opening(module.cell(c), below) = Opening::door;
  plan.opening(module.cell(stair_door), below) = Opening::door;
  for (const Cell c : panes_below) plan.opening(module.cell(c), below) = Opening::window;
  if (module.j > 0 && !has_stairs) plan.opening(module.cell(through_door), below) = Opening::door;
  if (!last_column) {
    const int row = module.j * module_y + (module.mirrored() ? corridor_in : corridor_out);
    plan.opening({(module.i + 1) * module_x, row}, {1, 0}) = Opening::door;
  }
}

void add_windows(Plan& plan, const std::vector<char>& shaft, int spacing) {
  if (spacing == 0) return;
  const auto wants = [&](Cell c, int k) { return k % spacing == 0 && !shaft[static_cast<std::size_t>(plan.room(c))]; };
  for (int x = 0; x < plan.columns(); ++x) {
    for (const int y : {0, plan.rows()}) {
      if (wants({x, y == 0 ? 0 : y - 1}, x)) plan.opening({x, y}, {0, 1}) = Opening::window;
    }
  }
  for (int y = 0; y < plan.rows(); ++y) {
    for (const int x : {0, plan.columns()}) {
      if (wants({x == 0 ? 0 : x - 1, y}, y)) plan.opening({x, y}, {1, 0}) = Opening::window;
    }
  }
}

FloorPlan make_row(const FloorLayout& layout) {
  FloorPlan result{Plan(2 * layout.rooms_in_row, 2), {}, {}, {}, {0, 0}, {}};
  for (int room = 0; room < layout.rooms_in_row; ++room) {
    for (int k = 0; k < 4; ++k) result.plan.set_room({2 * room + k % 2, k / 2}, room);
    if (room > 0) result.plan.opening({2 * room, room % 2}, {1, 0}) = Opening::door;
    result.visits.push_back({2 * room + 1, (room + 1) % 2});
  }
  result.corridor.assign(static_cast<std::size_t>(layout.rooms_in_row), 0);
  result.shaft = result.corridor;
  return result;
}

}  // namespace

FloorPlan make_floor_plan(const FloorLayout& layout, bool stairs) {
  if (layout.rooms_in_row > 0) return make_row(layout);
  const int nx = layout.modules_x, ny = layout.modules_y;
  FloorPlan result{Plan(nx * module_x, ny * module_y), {}, {}, {}, {0, corridor_in}, {}};
  result.corridor.assign(static_cast<std::size_t>(nx * ny * rooms_per_module), 0);
  result.shaft = result.corridor;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int first_room = (j * nx + i) * rooms_per_module;
      const bool has_stairs = stairs && j == 0 && i % 4 == 0;
      const Module module{i, j};
      add_module(result.plan, module, first_room, i + 1 == nx, has_stairs);
      result.corridor[static_cast<std::size_t>(first_room)] = 1;
      if (!has_stairs) continue;
      result.shaft[static_cast<std::size_t>(first_room + stair_room)] = 1;
      result.shafts.push_back(module.cell({3, 0}));
    }
  }
  add_windows(result.plan, result.shaft, layout.window_spacing);

  const auto visit = [&](int i, int j, Cell c) {
    if (i < nx && j < ny) result.visits.push_back(Module{i, j}.cell(c));
  };
  visit(0, 0, {0, 6});  // a
  visit(0, 0, {2, 3});  // d
  visit(0, 0, {6, 6});  // e, c
  visit(1, 0, {6, 1});  // h
  visit(1, 1, {1, 6});  // through b and the g above it into a
  visit(1, 1, {7, 3});  // e
  visit(0, 1, {6, 0});  // h
  visit(0, 1, {1, 0});  // d, f
  return result;
}

}  // namespace sightline::models
