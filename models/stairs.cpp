#include "models/stairs.hpp"

#include <algorithm>

namespace sightline::models {
namespace {

constexpr int rise = 4, run = 6, risers = 7;  // of each flight
constexpr int half_gap = 4;                   // between the flights
constexpr int half_landing = 2 * units_per_metre;
static_assert(2 * risers * rise == storey_height && slab == 2 * rise);

/// A flight between x0 and x1 that rises from a landing's edge (y, z) along y to the edge of the next landing, whose
/// edge is the last riser. The side at the wall is left out: x0 is the free one if `left_free`, else x1. The first
/// flight of all stands on the floor, the others hang on the landing.
void add_flight(Mesh& mesh, int x0, int x1, int y, int z, int step_y, bool left_free, bool stands) {
  const auto across = [&](glm::ivec2 a, glm::ivec2 b) {  // a strip from x0 to x1 between two points (y, z)
    std::vector<Point> ring{{x0, a.x, a.y}, {x1, a.x, a.y}, {x1, b.x, b.y}, {x0, b.x, b.y}};
    if (step_y < 0) std::reverse(ring.begin(), ring.end());
    mesh.polygon(ring);
  };
  std::vector<glm::ivec2> profile;
  if (stands) profile.emplace_back(y + step_y, z);
  profile.emplace_back(y, stands ? z : z - rise);
  glm::ivec2 foot(y, z);
  for (int k = 1; k < risers; ++k) {
    const glm::ivec2 edge(foot.x, foot.y + rise), next(edge.x + step_y, edge.y);
    across(foot, edge);
    across(edge, next);
    profile.push_back(edge);
    profile.push_back(next);
    foot = next;
  }
  profile.emplace_back(foot.x, foot.y - rise);
  across(profile.back(), profile.front());  // the soffit
  std::vector<Point> side;
  for (const glm::ivec2& p : profile) side.emplace_back(left_free ? x0 : x1, p.x, p.y);
  // Where it rises along +y, the profile runs clockwise seen from the right.
  if (left_free != (step_y > 0)) std::reverse(side.begin(), side.end());
  mesh.polygon(side);
}

struct Shaft {
  int x0, x1, y0, y1, middle, near_edge, far_edge;
  explicit Shaft(Cell corner)
      : x0(corner.x * cell_size + half_wall),
        x1((corner.x + 2) * cell_size - half_wall),
        y0(corner.y * cell_size + half_wall),
        y1((corner.y + 2) * cell_size - half_wall),
        middle((corner.x + 1) * cell_size),
        near_edge(y0 + half_landing),
        far_edge(near_edge + (risers - 1) * run) {}
};

}  // namespace

void add_stairs(Mesh& mesh, Cell corner, int level) {
  const Shaft s(corner);
  const int floor = level * storey_height, half = floor + risers * rise, above = floor + storey_height;
  mesh.object("stairs " + std::to_string(level));
  // Up along the right side towards lower y, then back along the left.
  add_flight(mesh, s.middle + half_gap, s.x1, s.far_edge, floor, -run, true, level == 0);
  mesh.box({s.x0, s.y0, half - slab}, {s.x1, s.near_edge, half}, top | bottom | back);
  add_flight(mesh, s.x0, s.middle - half_gap, s.near_edge, half, run, false, false);
  mesh.box({s.x0, s.far_edge, above - slab}, {s.x1, s.y1, above}, top | bottom | front);
}

std::vector<Waypoint> way_upstairs(Cell corner, int level, double eye_height) {
  const Shaft s(corner);
  const int floor = level * storey_height, half = floor + risers * rise, above = floor + storey_height;
  const auto at = [&](int x, int y, int z, double pitch) {
    return Waypoint{glm::dvec3(x, y, z) / static_cast<double>(units_per_metre) + glm::dvec3(0, 0, eye_height), pitch};
  };
  const int right_x = (s.middle + half_gap + s.x1) / 2, left_x = (s.x0 + s.middle - half_gap) / 2;
  const int landing_y = (s.far_edge + s.y1) / 2, turn_y = (s.y0 + s.near_edge) / 2;
  return {at(right_x, landing_y, floor, 0.1), at(right_x, s.far_edge, floor, 0.3), at(right_x, s.near_edge, half, 0.2),
          at(right_x, turn_y, half, 0),       at(left_x, turn_y, half, 0),         at(left_x, s.near_edge, half, 0.3),
          at(left_x, s.far_edge, above, 0.2), at(left_x, landing_y, above, 0),     at(right_x, landing_y, above, 0)};
}

}  // namespace sightline::models
