// Polygons lumped together in cells, which are marked and shown as wholes: fewer are missed, and more is shown than is
// seen. (Blais and Poulin, Sampling visibility in three-space, sections 3.2 and 8.)
#pragma once

#include "sample/field_slab.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace sightline {

/// A partition of a scene's polygons.
struct FieldCells {
  std::vector<std::uint32_t> of;  // of each polygon its cell, or `none` where it has no area
  std::uint32_t count = 0;        // every one of them has a polygon
};

/// Objects that are gridded each for itself: those that the file names, or what hangs together by common vertices.
/// Returns each polygon's object, numbered by first appearance, `none` for polygons without area.
enum class FieldObjects : std::uint8_t { named, connected };
std::vector<std::uint32_t> field_objects(const Scene& scene, FieldObjects kind);

/// Every polygon a cell of its own.
FieldCells cells_of_polygons(const Scene& scene);
/// A grid of cubes over each object, with `along` cubes (1 to 4096, need not be whole) on the longest side of the
/// object's own box; a polygon lies where the middle of its box does.
FieldCells cells_of_objects(const Scene& scene, const std::vector<std::uint32_t>& objects, double along);
/// One such grid over the whole scene.
FieldCells cells_of_scene(const Scene& scene, double along);
/// An octree over the whole scene. A cube with more than one polygon is divided while its side is longer than `samples`
/// times the distance of neighbouring rays there: those of one (u,v) through neighbouring (s,t), in the finest slab. So
/// cells are larger where rays are farther apart, and no smaller than half of what rays can tell apart. At most 16
/// deep.
FieldCells cells_of_octree(const Scene& scene, const std::vector<FieldSlab>& slabs,
                           const std::array<std::uint32_t, 4>& uvst, double samples);

/// `polygon`, `object:N`, `scene:N` or `octree:N`, read.
struct CellName {
  enum Kind : std::uint8_t { polygon, object, scene, octree } kind = object;
  double setting = 16;
};
/// Throws std::invalid_argument with what is wanted.
CellName parse_cells(const std::string& text);

/// The box of all polygons that have an area.
FieldBox box_of(const Scene& scene);

}  // namespace sightline
