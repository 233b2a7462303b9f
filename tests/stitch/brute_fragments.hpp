// Fragments of small scenes by brute force: the view is cut along every sightline that could matter, and every cell is
// labelled by one exact ray.
#pragma once

#include "scene/camera.hpp"
#include "visibility_map/fragment.hpp"

#include <random>

namespace sightline::testing {

/// A convex region of the view.
using Cell = std::vector<SightlineRef>;

/// The part of a cell on the inner side of a line; empty if it has no area.
Cell part_inside(SightlineTable& table, const Cell& cell, SightlineRef line);
/// Replaces each cell by its parts on both sides of the line.
void cut_cells(SightlineTable& table, std::vector<Cell>& cells, SightlineRef line);
/// The four sides of the window, counter-clockwise.
Cell window_cell(SightlineTable& table, const Camera& camera);
/// The eight octants of the sphere.
std::vector<Cell> octant_cells(SightlineTable& table);

/// Which pieces are seen at an inner ray of the cell: the nearest and those in the same plane there, ascending.
std::vector<SurfaceId> look(const Scene& scene, const SightlineTable& table, const Cell& cell);

struct BruteOptions {
  unsigned seed = 0;     // of the following
  int extra_cuts = 0;    // along random lines
  bool shuffle = false;  // fragments in random order, their sides beginning anywhere
};
/// Fragments that tile the camera's window (the sphere if `camera` is null). `table` holds the eye.
Fragments brute_fragments(const Scene& scene, const Camera* camera, SightlineTable& table, const BruteOptions& options);

/// A small scene full of degeneracies: triangles, rectangles along the axes, L shapes, quadrilaterals that are not
/// planar, all on a grid of small integers.
PolygonSoup random_soup(std::mt19937& random, int most = 8);
/// A camera of small numbers that looks at such a scene.
Camera random_camera(std::mt19937& random);

}  // namespace sightline::testing
