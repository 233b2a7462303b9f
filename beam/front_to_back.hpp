// The engine `front-to-back`. Internal to beam/.
#pragma once

#include <memory>

#include "beam/view.hpp"
#include "bsp/tree.hpp"

namespace sightline {

/// Polygons in the order of a tree from the eye outwards, each cut out of what is still open (the future work of
/// Funkhouser 1999, section 6, after Fuchs 1980): beams are split at edges of polygons that are seen, nowhere else.
std::unique_ptr<Engine> front_to_back_engine(const BspTree& tree, double min_angle, double max_distance);

}  // namespace sightline
