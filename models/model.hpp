// The papers' test models, made anew: Funkhouser 1999 (figure 7, table 1) and Yu (table 1).
#pragma once

#include "scene/read.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace sightline {

struct ModelOptions {
  std::uint32_t polygons = 0;  // wanted number; 0: the paper's. Met exactly where the model can be scaled
  std::uint64_t seed = 1;      // same seed, same model, on every platform
  double rotate_degrees = 0;   // about the axis (1,2,3) through the origin, in rounded doubles
};

/// Polygons and the cameras that go with them, all 60 degrees high and 4:3: 100 along a walk for the first six models,
/// as many as in the paper for the others. Unrotated, vertices are multiples of 1/16 and eyes of 1/64; z is up. Laws,
/// each tested: (1) no two vertices are equal and none is unused; (2) every polygon is exactly planar and simple; (3)
/// it runs counter-clockwise seen from its open side (rooms, maze and random have walls without thickness, which have
/// no such side); (4) no eye is on a polygon or within a wall, and in rooms, maze, arena and city the straight step
/// from one eye to the next is free (elsewhere steps may cut a corner); (5) every polygon belongs to a named object;
/// (6) a rotated copy has the same polygons, its lengths kept to rounding.
struct Model {
  PolygonSoup soup;
  std::vector<CameraLine> cameras;
};

/// rooms, maze, arena, city, floor, building, tower, campus, random.
std::vector<std::string> model_names();

/// Makes a model. Throws std::invalid_argument, naming the model, when there is none of that name, when it cannot have
/// that number of polygons (rooms, arena, tower and campus have the paper's only; the others from a few up to some
/// millions), or when the angle is not finite.
Model make_model(const std::string& name, const ModelOptions& options = {});

}  // namespace sightline
