// One generator a model; `make_model` chooses among them.
#pragma once

#include "models/model.hpp"

namespace sightline::models {

inline constexpr int walk_cameras = 100;

Model make_rooms();
Model make_maze(std::uint32_t polygons, std::uint64_t seed);
Model make_arena();
Model make_city(std::uint32_t polygons, std::uint64_t seed);
Model make_floor(std::uint32_t polygons, std::uint64_t seed);
Model make_building(std::uint32_t polygons, std::uint64_t seed);
Model make_tower();
Model make_campus(std::uint64_t seed);
Model make_random(std::uint32_t polygons, std::uint64_t seed);

}  // namespace sightline::models
