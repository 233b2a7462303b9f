// Stairs of two flights in a shaft of two by two cells.
#pragma once

#include "models/storey.hpp"
#include "models/walk.hpp"

namespace sightline::models {

/// The stairs from `level` to the one above, the landing there included. `corner`: the least cell of the shaft. Its
/// door is in the middle of the right cell's far (upper) side.
void add_stairs(Mesh& mesh, Cell corner, int level);

/// A way up those stairs, from the door below to the door above, at eye height over the floor.
std::vector<Waypoint> way_upstairs(Cell corner, int level, double eye_height);

}  // namespace sightline::models
