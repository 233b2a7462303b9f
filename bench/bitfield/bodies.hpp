// Bodies of the sizes of Meruvia and Strothotte's three models, with as little and as much self-occlusion.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace sightline {

/// bunny: a bumpy ball with two ears, 65,024 triangles, little of which hides other parts. gears: nine toothed wheels
/// on three shafts, 73,440. brain: a ball with deep, narrow, winding folds, 277,728. Coordinates are multiples of
/// 2^-12. Throws std::invalid_argument for any other name.
PolygonSoup make_body(const std::string& name);
const std::vector<std::string>& body_names();

}  // namespace sightline
