// Furniture for the cells of a storey.
#pragma once

#include "models/random_numbers.hpp"
#include "models/storey.hpp"

namespace sightline::models {

/// Puts furniture into the cells of every level, about evenly, and at most `budget` polygons of it. It keeps a quarter
/// of a cell away from the borders of its cell, unless it stands at a wall.
void furnish(Mesh& mesh, const std::vector<Storey>& storeys, const std::vector<Cell>& cells, int budget,
             RandomNumbers& random);

}  // namespace sightline::models
