// Interpenetrating convex polygons of random sizes and orientations in a box: Yu's model III.
#include "models/generators.hpp"
#include "models/mesh.hpp"
#include "models/random_numbers.hpp"
#include "models/walk.hpp"

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <stdexcept>

namespace sightline::models {
namespace {

constexpr int half_box = 32 * units_per_metre;

std::int64_t cross(const glm::ivec2& o, const glm::ivec2& a, const glm::ivec2& b) {
  return static_cast<std::int64_t>(a.x - o.x) * (b.y - o.y) - static_cast<std::int64_t>(a.y - o.y) * (b.x - o.x);
}

/// The strict corners of the convex hull, counter-clockwise.
std::vector<glm::ivec2> hull(std::vector<glm::ivec2> points) {
  std::sort(points.begin(), points.end(),
            [](const glm::ivec2& a, const glm::ivec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::ivec2> ring;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = ring.size();
    for (const glm::ivec2& p : points) {
      while (ring.size() > base + 1 && cross(ring[ring.size() - 2], ring.back(), p) <= 0) ring.pop_back();
      ring.push_back(p);
    }
    ring.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return ring;
}

Point random_point(RandomNumbers& random, int limit) {
  return {random.between(-limit, limit), random.between(-limit, limit), random.between(-limit, limit)};
}

/// Corners on the lattice of two short vectors, so that they lie in one plane exactly. `reach`: of the vectors.
std::vector<Point> random_polygon(RandomNumbers& random, int reach) {
  while (true) {
    const Point centre = random_point(random, half_box);
    const Point u = random_point(random, reach), v = random_point(random, reach);
    const Point normal(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    if (normal == Point(0)) continue;
    const int corners = random.between(3, 6);
    std::vector<glm::ivec2> points(static_cast<std::size_t>(corners));
    for (glm::ivec2& p : points) {
      p.x = random.between(-6, 6);
      p.y = random.between(-6, 6);
    }
    std::vector<Point> polygon;
    for (const glm::ivec2& p : hull(points)) polygon.push_back(centre + u * p.x + v * p.y);
    const bool inside = std::all_of(polygon.begin(), polygon.end(), [](const Point& p) {
      return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= half_box;
    });
    if (inside && polygon.size() == static_cast<std::size_t>(corners)) return polygon;
  }
}

}  // namespace

Model make_random(std::uint32_t polygons, std::uint64_t seed) {
  if (polygons < 1 || polygons > 4'000'000) throw std::invalid_argument("random: polygons must be 1 to 4000000");
  // The more polygons, the smaller: their areas add up to about the same.
  int reach = 40;
  while (reach > 3 && static_cast<std::int64_t>(reach) * reach * polygons > 1'600'000) --reach;
  RandomNumbers random(seed);
  Mesh mesh;
  for (std::uint32_t k = 0; k < polygons; ++k) {
    if (k % 100 == 0) mesh.object("cluster " + std::to_string(k / 100));
    mesh.polygon(random_polygon(random, reach));
  }

  // Two rings of six around the box, and four within that look towards its corners.
  static constexpr std::array<std::array<double, 2>, 6> ring{
      {{72.25, 3.5}, {33.75, 61.25}, {-37.5, 58.75}, {-70.5, -4.25}, {-34.25, -63.5}, {38.5, -60.25}}};
  std::vector<CameraLine> cameras;
  for (std::size_t k = 0; k < 12; ++k) {
    const auto [x, y] = ring[k % 6];
    cameras.push_back(look_at({k < 6 ? x : y, k < 6 ? y : -x, k < 6 ? -20.359375 : 33.640625}, {0, 0, 0}));
  }
  for (int k = 0; k < 4; ++k) {
    const double x = k & 1 ? 1 : -1, y = k & 2 ? 1 : -1;
    cameras.push_back(look_at({2.515625 * x + 0.171875, 3.234375 * y - 0.203125, 1.453125 + 0.015625 * k},
                              {30 * x, 30 * y, 8 * x * y}));
  }
  return {mesh.take("random"), cameras};
}

}  // namespace sightline::models
