// Four rooms around a table and a way through them: 20 polygons.
#include "models/generators.hpp"
#include "models/mesh.hpp"
#include "models/walk.hpp"

namespace sightline::models {
namespace {

constexpr int m = units_per_metre;
constexpr int height = 3 * m, door_height = 2 * m + 2;

/// A wall without thickness from (a) to (b), with a doorway from (c) to (d) between: three polygons.
void wall_with_door(Mesh& mesh, const Point& a, const Point& c, const Point& d, const Point& b) {
  const Point up(0, 0, height), lintel(0, 0, door_height);
  mesh.polygon({a, c, c + up, a + up});
  mesh.polygon({d, b, b + up, d + up});
  mesh.polygon({c + lintel, d + lintel, d + up, c + up});
}

}  // namespace

Model make_rooms() {
  Mesh mesh;
  mesh.object("shell");
  mesh.hollow({0, 0, 0}, {16 * m, 12 * m, height});
  mesh.object("wall south");
  wall_with_door(mesh, {8 * m, 0, 0}, {8 * m, 2 * m, 0}, {8 * m, 3 * m, 0}, {8 * m, 6 * m, 0});
  mesh.object("wall west");
  wall_with_door(mesh, {0, 6 * m, 0}, {5 * m, 6 * m, 0}, {6 * m, 6 * m, 0}, {8 * m, 6 * m, 0});
  mesh.object("wall north");  // one polygon that leaves the doorway out
  mesh.polygon({{8 * m, 6 * m, 0},
                {8 * m, 8 * m, 0},
                {8 * m, 8 * m, door_height},
                {8 * m, 9 * m, door_height},
                {8 * m, 9 * m, 0},
                {8 * m, 12 * m, 0},
                {8 * m, 12 * m, height},
                {8 * m, 6 * m, height}});
  mesh.object("wall east");  // an opening up to the ceiling
  mesh.polygon({{8 * m, 6 * m, 0}, {13 * m, 6 * m, 0}, {13 * m, 6 * m, height}, {8 * m, 6 * m, height}});
  mesh.polygon({{15 * m, 6 * m, 0}, {16 * m, 6 * m, 0}, {16 * m, 6 * m, height}, {15 * m, 6 * m, height}});
  mesh.object("table");
  mesh.box({11 * m, 2 * m, 0}, {13 * m, 3 * m, 3 * m / 4}, standing);

  const std::vector<Waypoint> way{{{2, 2.5, 1.625}},   {{9.75, 2.5, 1.625}}, {{9.75, 4.5, 1.625}},
                                  {{14, 4.5, 1.625}},  {{14, 10, 1.625}},    {{10, 8.5, 1.625}},
                                  {{5.5, 8.5, 1.625}}, {{5.5, 3.5, 1.625}},  {{2, 3.5, 1.625}}};
  return {mesh.take("rooms"), walk(way, walk_cameras, {.ahead = 4, .yaw = 0.2})};
}

}  // namespace sightline::models
