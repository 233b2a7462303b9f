// Walls, doorways, windows, floors and ceilings of a storey.
#pragma once

#include "models/plan.hpp"

namespace sightline::models {

inline constexpr int storey_height = 7 * units_per_metre / 2;  // from floor to floor
inline constexpr int room_height = 3 * units_per_metre;
inline constexpr int slab = storey_height - room_height;
inline constexpr int sill = units_per_metre;  // of a window, above the floor

/// A storey in its place. Rooms with `shaft` are open to the storeys above and below.
struct Storey {
  const Plan& plan;
  const std::vector<char>& shaft;  // per room
  int level;
  int levels;

  int floor() const { return level * storey_height; }
  std::string name() const { return "storey " + std::to_string(level); }
};

/// The rooms, and the outer walls from `base` up to the floor above.
void add_storey(Mesh& mesh, const Storey& storey, int base);

}  // namespace sightline::models
