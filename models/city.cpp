// Blocks of houses and towers, some set back in steps, along staggered streets.
#include "models/generators.hpp"
#include "models/mesh.hpp"
#include "models/random_numbers.hpp"
#include "models/walk.hpp"

#include <algorithm>
#include <stdexcept>

namespace sightline::models {
namespace {

// All lengths are multiples of a quarter of a metre.
constexpr int m = units_per_metre, quarter = m / 4;
constexpr int street = 16 * m, pavement = 2 * m, kerb = quarter;
constexpr Point lot(16 * m, 18 * m, 0);
constexpr int lots_x = 3, lots_y = 2, lots = lots_x * lots_y;
constexpr int block_x = lots_x * lot.x + 2 * pavement, block_y = lots_y * lot.y + 2 * pavement;
constexpr int pitch_x = block_x + street, pitch_y = block_y + street;
constexpr int district = 6;  // columns
constexpr int boxes_per_block = 9;
constexpr int tallest = 64 * m;

/// The least corner of a block. Every other row is shifted by half a block, and every other district of six columns
/// likewise, so that no street runs straight through a large city.
Point block_corner(int column, int row) {
  const int d = column / district;
  return {column * pitch_x + d * (pitch_x / 2) + row % 2 * (pitch_x / 2), row * pitch_y + d % 2 * (pitch_y / 2), 0};
}

int quarters_between(RandomNumbers& random, int least_metres, int most_metres) {
  return random.between(4 * least_metres, 4 * most_metres) * quarter;
}

/// A house on its lot, with `storeys` boxes one on the other, each smaller than the one below.
void building(Mesh& mesh, RandomNumbers& random, const Point& corner, int storeys) {
  Point lo = corner + Point{random.below(5) * quarter, random.below(5) * quarter, kerb};
  Point hi = corner + lot - Point{random.below(5) * quarter, random.below(5) * quarter, 0};
  hi.z = random.chance(1, 12) ? quarters_between(random, 28, 44) : quarters_between(random, 6, 20);
  mesh.box(lo, hi, standing);
  for (int k = 1; k < storeys; ++k) {
    const int inset = random.between(4, 8) * quarter;
    lo += Point(inset, random.between(4, 8) * quarter, 0);
    hi -= Point(inset, random.between(4, 8) * quarter, 0);
    lo.z = hi.z;
    hi.z += quarters_between(random, 3, 9);
    mesh.box(lo, hi, standing);
  }
}

/// A raised block with a kerb, and `boxes - 1` boxes of houses on it.
void block(Mesh& mesh, RandomNumbers& random, const Point& corner, int boxes) {
  if (boxes == 0) return;
  mesh.box(corner, corner + Point(block_x, block_y, kerb), standing);
  const int first = random.below(lots);
  for (int k = 0; k < lots; ++k) {
    const int storeys = (boxes - 1 + lots - 1 - k) / lots;
    if (storeys == 0) continue;
    const int place = (first + k) % lots;
    const Point at = corner + Point(pavement + place % lots_x * lot.x, pavement + place / lots_x * lot.y, 0);
    building(mesh, random, at, storeys);
  }
}

/// How many of the boxes the first `block` blocks have. Every seventh has a fifth of what the others have.
int boxes_up_to(std::int64_t block, std::int64_t blocks, std::int64_t boxes) {
  const auto weight = [](std::int64_t count) { return 5 * count - 4 * ((count + 3) / 7); };
  return static_cast<int>(boxes * weight(block) / weight(blocks));
}

/// Through streets at the height of a walker, zigzag, towards the edge of the city; then back along a street, up and
/// over the roofs.
std::vector<Waypoint> route(int columns, int rows) {
  // Where the street before a column leaves the one before a row.
  const auto crossing = [](int column, int row) {
    const Point c = block_corner(column, row);
    return glm::dvec3(c.x - street / 2, c.y - street / 2, 0) / static_cast<double>(m);
  };
  const int near_columns = std::min(columns, district), first_street = std::min(rows - 1, 4);
  const int last_street = first_street > 3 ? 2 : 1;
  const glm::dvec3 eye(0, 0, 1.75);
  std::vector<Waypoint> way;
  if (near_columns > 2 && first_street > 1) way.push_back({crossing(near_columns - 1, first_street) + eye});
  for (int row = first_street - 1; row >= last_street; --row) {
    const int column = row == last_street ? 1 : row % 2 == 0 ? near_columns / 4 : near_columns * 3 / 4;
    const glm::dvec3 to = crossing(column, row);
    way.push_back({glm::dvec3(to.x, crossing(column, row + 1).y, 0) + eye});
    way.push_back({to + eye});
  }
  if (way.empty()) way.push_back({crossing(0, 0) + eye});
  const glm::dvec3 start = way.back().at;
  const double end = static_cast<double>(block_corner(near_columns - 1, 0).x + block_x) / m;
  const auto along = [&](double part, double z) { return glm::dvec3(start.x + part * (end - start.x), start.y, z); };
  way.push_back({along(0.125, 3)});
  way.push_back({along(0.25, 22), -0.1});
  way.push_back({along(0.5, static_cast<double>(tallest) / m), -0.3});
  way.push_back({along(0.625, static_cast<double>(tallest) / m), -0.4});
  return way;
}

}  // namespace

Model make_city(std::uint32_t polygons, std::uint64_t seed) {
  if (polygons < 11 || polygons > 4'000'000) throw std::invalid_argument("city: polygons must be 11 to 4000000");
  // Every box has five sides; the ground makes up for what is missing.
  const int boxes = (static_cast<int>(polygons) - 1) / 5, ground = static_cast<int>(polygons) - 5 * boxes;
  const int wanted = (boxes + boxes_per_block - 1) / boxes_per_block;
  int columns = 1;
  while (columns * columns < wanted) ++columns;
  const int rows = (wanted + columns - 1) / columns;

  RandomNumbers random(seed);
  Mesh mesh;
  mesh.object("ground");
  const Point last = block_corner(columns - 1, rows - 1) + Point(block_x + pitch_x, block_y + pitch_y, 0);
  for (int k = 0; k < ground; ++k) {
    const auto edge = [&](int i) { return i == ground ? last.x : last.x / ground / quarter * quarter * i; };
    const int y0 = -2 * street;
    const int x0 = k == 0 ? y0 : edge(k), x1 = edge(k + 1);
    mesh.polygon({{x0, y0, 0}, {x1, y0, 0}, {x1, last.y, 0}, {x0, last.y, 0}});
  }
  const std::int64_t blocks = columns * rows;
  for (std::int64_t b = 0; b < blocks; ++b) {
    mesh.object("block " + std::to_string(b));
    block(mesh, random, block_corner(static_cast<int>(b % columns), static_cast<int>(b / columns)),
          boxes_up_to(b + 1, blocks, boxes) - boxes_up_to(b, blocks, boxes));
  }
  return {mesh.take("city"), walk(route(columns, rows), walk_cameras,
                                  {.corner = 6, .behind = 6, .ahead = 6, .yaw = 0.12, .yaw_waves = 7, .pitch = 0.12})};
}

}  // namespace sightline::models
