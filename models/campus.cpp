// Buildings with gables, wings and flat roofs on a terrain of triangles: Yu's model II.
#include "models/generators.hpp"
#include "models/mesh.hpp"
#include "models/random_numbers.hpp"
#include "models/walk.hpp"

#include <algorithm>
#include <array>

namespace sightline::models {
namespace {

constexpr int m = units_per_metre;
constexpr int squares = 14, square = 32 * m, extent = squares * square;
constexpr int gabled = 24, winged = 7, flat = 15;  // 6, 7 and 5 polygons each
constexpr int lots_per_row = 7;                    // of two by two squares each

/// Heights at the corners of the squares: a slope with hills.
class Terrain {
 public:
  explicit Terrain(RandomNumbers& random) {
    for (int k = 0; k < corners * corners; ++k) {
      const int x = k % corners, y = k / corners, hill = std::max(0, 30 - (x - 10) * (x - 10) - (y - 11) * (y - 11));
      heights_[static_cast<std::size_t>(k)] = (y * m) + hill * m / 2 + random.between(-m, m);
    }
  }
  Point corner(int x, int y) const {
    return {x * square, y * square, heights_[static_cast<std::size_t>(y * corners + x)]};
  }
  /// The lowest and highest corner of the squares that a lot of two by two covers.
  std::array<int, 2> range(int x, int y) const {
    std::array<int, 2> result{corner(x, y).z, corner(x, y).z};
    for (int k = 0; k < 9; ++k) {
      result[0] = std::min(result[0], corner(x + k % 3, y + k / 3).z);
      result[1] = std::max(result[1], corner(x + k % 3, y + k / 3).z);
    }
    return result;
  }

 private:
  static constexpr int corners = squares + 1;
  std::array<int, corners * corners> heights_;
};

void add_terrain(Mesh& mesh, const Terrain& terrain) {
  mesh.object("terrain");
  for (int y = 0; y < squares; ++y) {
    for (int x = 0; x < squares; ++x) {
      const Point a = terrain.corner(x, y), b = terrain.corner(x + 1, y), c = terrain.corner(x + 1, y + 1),
                  d = terrain.corner(x, y + 1);
      if ((x + y) % 2 == 0) {
        mesh.polygon({a, b, c});
        mesh.polygon({a, c, d});
      } else {
        mesh.polygon({a, b, d});
        mesh.polygon({b, c, d});
      }
    }
  }
}

void add_gabled(Mesh& mesh, const Point& lo, const Point& hi, int ridge) {
  const int y = (lo.y + hi.y) / 2;
  const Point a(lo.x, lo.y, hi.z), b(hi.x, lo.y, hi.z), c(hi.x, hi.y, hi.z), d(lo.x, hi.y, hi.z);
  const Point west(lo.x, y, ridge), east(hi.x, y, ridge);
  mesh.box(lo, hi, front | back);
  mesh.polygon({{lo.x, hi.y, lo.z}, lo, a, west, d});
  mesh.polygon({{hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, c, east, b});
  mesh.polygon({a, b, east, west});
  mesh.polygon({c, d, west, east});
}

/// Two wings at a right angle under one roof, which is not convex.
void add_winged(Mesh& mesh, const Point& lo, const Point& hi) {
  const int x = lo.x + (hi.x - lo.x) / 3, y = lo.y + (hi.y - lo.y) / 3;
  const std::array<Point, 6> ring{Point(lo.x, lo.y, hi.z), Point(hi.x, lo.y, hi.z), Point(hi.x, y, hi.z),
                                  Point(x, y, hi.z),       Point(x, hi.y, hi.z),    Point(lo.x, hi.y, hi.z)};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    mesh.polygon({{a.x, a.y, lo.z}, {b.x, b.y, lo.z}, b, a});
  }
  mesh.polygon(ring);
}

void add_building(Mesh& mesh, RandomNumbers& random, const Terrain& terrain, int lot, int number) {
  const int x = lot % lots_per_row * 2, y = lot / lots_per_row * 2;
  const auto [lowest, highest] = terrain.range(x, y);
  Point lo{x * square + random.between(6, 12) * m, y * square + random.between(6, 12) * m, lowest - m};
  Point hi{(x + 2) * square - random.between(6, 12) * m, (y + 2) * square - random.between(6, 12) * m,
           highest + random.between(8, 24) * m};
  mesh.object("building " + std::to_string(number));
  if (number < gabled) {
    add_gabled(mesh, lo, hi, hi.z + random.between(6, 12) * m);
  } else if (number < gabled + winged) {
    add_winged(mesh, lo, hi);
  } else {
    hi.z += random.between(0, 20) * m;
    mesh.box(lo, hi, standing);
  }
}

}  // namespace

Model make_campus(std::uint64_t seed) {
  RandomNumbers random(seed);
  const Terrain terrain(random);
  Mesh mesh;
  add_terrain(mesh, terrain);
  // Every lot but the last three, in an order that mixes the kinds.
  constexpr int buildings = gabled + winged + flat;
  static_assert(buildings <= lots_per_row * lots_per_row);
  for (int k = 0; k < buildings; ++k) add_building(mesh, random, terrain, k, k * 17 % buildings);

  // Seven views from the air around, three from the middle of paths between the lots.
  const double size = static_cast<double>(extent) / m;
  const glm::dvec3 middle(size / 2, size / 2, 10);
  static constexpr std::array<std::array<double, 3>, 7> air{{{-0.125, -0.0625, 90},
                                                             {0.5, -0.1875, 70},
                                                             {1.125, 0.0625, 110},
                                                             {1.1875, 0.625, 80},
                                                             {0.875, 1.125, 120},
                                                             {0.375, 1.1875, 75},
                                                             {-0.1875, 0.6875, 100}}};
  std::vector<CameraLine> cameras;
  for (const auto& [x, y, z] : air) cameras.push_back(look_at({x * size, y * size, z}, middle));
  for (const int k : {2, 6, 10}) {
    const Point ground = terrain.corner(k, 12 - k);
    const glm::dvec3 eye = glm::dvec3(ground) / static_cast<double>(m) + glm::dvec3(0.25, -0.5, 2.5);
    cameras.push_back(look_at(eye, {middle.x - 8, middle.y + 8, eye.z + 2}));
  }
  return {mesh.take("campus"), cameras};
}

}  // namespace sightline::models
