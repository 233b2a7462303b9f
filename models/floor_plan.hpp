// Plans of office floors: modules of eight rooms along a bent corridor.
#pragma once

#include "models/plan.hpp"

namespace sightline::models {

/// How a storey is made up. No rooms in a row: modules_x by modules_y modules.
struct FloorLayout {
  int modules_x = 1, modules_y = 1;
  int window_spacing = 1;  // every so many cells of the outer walls; 0: no windows
  int rooms_in_row = 0;    // rooms of two by two cells, each with a door to the next, and nothing else
};

/// A plan and what its rooms are for.
struct FloorPlan {
  Plan plan;
  std::vector<char> corridor;  // per room
  std::vector<char> shaft;     // per room: may hold stairs
  std::vector<Cell> shafts;    // their least cells
  Cell entrance;               // the cell behind the front door, which is in the wall on its left
  std::vector<Cell> visits;    // cells in rooms, worth a walk in this order
};

/// With `stairs`, some rooms at the lower side are shafts.
FloorPlan make_floor_plan(const FloorLayout& layout, bool stairs);

}  // namespace sightline::models
