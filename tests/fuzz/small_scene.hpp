// Bytes as a scene of a few polygons and cameras, in which nearly nothing is in general position.
#pragma once

#include "scene/camera.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sightline::fuzz {

struct SmallScene {
  PolygonSoup soup;
  SceneOptions options;
  std::vector<Camera> cameras;
};

/// Bytes that are missing count as 0. At most 7 polygons of at most 6 corners; coordinates are whole numbers from -4 to
/// 3, some of them a unit in the last place off, thirds, or scaled by a power of two; so is the eye of each of
/// `cameras` cameras, which looks along whole numbers. A camera whose vectors depend on each other looks straight ahead
/// instead.
SmallScene small_scene(const std::uint8_t* data, std::size_t size, int cameras);

}  // namespace sightline::fuzz
