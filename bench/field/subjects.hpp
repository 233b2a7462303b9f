// The scenes of Blais and Poulin's measurements, made anew: as many objects, triangles and cells.
#pragma once

#include "sample/field_slab.hpp"
#include "scene/read.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace sightline::bench {

/// A scene that is looked at from its front (lower y), and the field that the paper measured it with.
struct Subject {
  std::string name;
  PolygonSoup soup;
  std::uint32_t cells = 0;  // wanted
  std::array<std::uint32_t, 4> samples{};
};

/// 6 objects of 231,060 triangles in all, a field of 16 x 16, 16 x 16, 4,680 cells.
Subject turtles();
/// 8 objects of 60,064 triangles in all, a field of 12 x 12, 48 x 48, 1,364 cells.
Subject cars();
/// One object, a field of 8 x 8, 32 x 32, 235 cells: a ball with dents of 69,696 triangles, or that of a file.
Subject bunny(const std::string& file);

/// Cameras before the scene that go from its left to its right, and look at its middle.
std::vector<CameraLine> animation(const PolygonSoup& soup, std::size_t frames);

/// One slab that fits the cameras of an animation: uv at infinity, with the directions of their windows; st in the
/// middle of the scene, as large as lines in these directions need that meet the scene's box.
FieldSlab slab_for(const FieldBox& box, std::span<const Camera> cameras);

}  // namespace sightline::bench
