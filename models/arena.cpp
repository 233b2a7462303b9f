// An amphitheatre: sand with pillars, eight-sided stands with gates, a passage round within them, a gallery on top.
#include "models/generators.hpp"
#include "models/mesh.hpp"
#include "models/random_numbers.hpp"
#include "models/walk.hpp"

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>

namespace sightline::models {
namespace {

constexpr int m = units_per_metre;
// Distances of the eight walls from the middle; multiples of 12, so that the corners lie on the grid.
constexpr int sand = 24 * m, tier_depth = 12, tiers = 12, passage_in = 30 * m, passage_out = 33 * m;
constexpr int gallery_in = sand + tiers * tier_depth, gallery_out = gallery_in + 60, facade = gallery_out + 12;
constexpr int podium = 4 * m, tier_rise = m / 2, gallery_floor = podium + tiers * tier_rise;
constexpr int gallery_ceiling = gallery_floor + 7 * m / 2, roof = gallery_ceiling + m / 2;
constexpr int gate_half = 3 * m / 2, gate_height = 5 * m / 2, passage_height = 3 * m;

/// Corner i of an octagon that is nearly regular: 5/12 stands for tan 22.5 degrees. Side i runs from corner i to i + 1;
/// sides 0, 2, 4, 6 face along the axes.
Point corner(int i, int r, int z) {
  const int q = 5 * r / 12;
  const std::array<glm::ivec2, 8> ring{glm::ivec2(r, -q), glm::ivec2(r, q),   glm::ivec2(q, r),   glm::ivec2(-q, r),
                                       glm::ivec2(-r, q), glm::ivec2(-r, -q), glm::ivec2(-q, -r), glm::ivec2(q, -r)};
  const glm::ivec2 p = ring[static_cast<std::size_t>(i) % 8];
  return {p.x, p.y, z};
}

enum class Seen { from_inside, from_outside };  // from the middle or above; from outside or below

void add_strip(Mesh& mesh, int side, int r0, int z0, int r1, int z1, Seen seen) {
  std::array<Point, 4> ring{corner(side, r0, z0), corner(side + 1, r0, z0), corner(side + 1, r1, z1),
                            corner(side, r1, z1)};
  if (seen == Seen::from_inside) std::reverse(ring.begin(), ring.end());
  mesh.polygon(ring);
}

void add_ring(Mesh& mesh, int r0, int z0, int r1, int z1, Seen seen) {
  for (int side = 0; side < 8; ++side) add_strip(mesh, side, r0, z0, r1, z1, seen);
}

/// A wall with gates in the sides along the axes.
void add_gate_wall(Mesh& mesh, int r, int z1, Seen seen) {
  const auto quad = [&](Point a, Point b, int low) {
    std::array<Point, 4> ring{Point(a.x, a.y, low), Point(b.x, b.y, low), Point(b.x, b.y, z1), Point(a.x, a.y, z1)};
    if (seen == Seen::from_inside) std::reverse(ring.begin(), ring.end());
    mesh.polygon(ring);
  };
  for (int side = 0; side < 8; ++side) {
    if (side % 2 == 1) {
      add_strip(mesh, side, r, 0, r, z1, seen);
      continue;
    }
    const Point a = corner(side, r, 0), b = corner(side + 1, r, 0), along = (b - a) / (10 * r / 12);
    const Point middle = (a + b) / 2, c = middle - along * gate_half, d = middle + along * gate_half;
    quad(a, c, 0);
    quad(d, b, 0);
    quad(c, d, gate_height);
  }
}

/// The four ways from one wall to another.
void add_tunnels(Mesh& mesh, int r0, int r1) {
  for (const int sign : {1, -1}) {
    const int lo = std::min(sign * r0, sign * r1), hi = std::max(sign * r0, sign * r1);
    mesh.hollow({lo, -gate_half, 0}, {hi, gate_half, gate_height}, front | back | top | bottom);
    mesh.hollow({-gate_half, lo, 0}, {gate_half, hi, gate_height}, left | right | top | bottom);
  }
}

void add_gallery(Mesh& mesh) {
  mesh.object("gallery");
  add_ring(mesh, gallery_in, gallery_floor, gallery_out, gallery_floor, Seen::from_inside);
  add_ring(mesh, gallery_out, gallery_floor, gallery_out, gallery_ceiling, Seen::from_inside);
  add_ring(mesh, gallery_in, gallery_ceiling, gallery_out, gallery_ceiling, Seen::from_outside);
  add_ring(mesh, gallery_in, gallery_ceiling, gallery_in, roof, Seen::from_inside);
  add_ring(mesh, gallery_in, roof, facade, roof, Seen::from_inside);
  mesh.object("columns");
  for (int side = 0; side < 8; ++side) {
    const Point a = corner(side, gallery_in + 12, 0), b = corner(side + 1, gallery_in + 12, 0);
    for (int k = 0; k < 3; ++k) {
      const Point at = a + (b - a) * (2 * k + 1) / 6;
      mesh.box(at + Point(-4, -4, gallery_floor), at + Point(4, 4, gallery_ceiling), around);
    }
  }
}

/// Four by four pillars with eight sides, two of which are only stumps, and crates in rows between them.
void add_obstacles(Mesh& mesh) {
  RandomNumbers random(1);
  const auto crate = [&](const Point& at) {
    const Point half{random.between(8, 16), random.between(8, 16), 0};
    mesh.box(at - half, at + half + Point(0, 0, random.between(12, 40)), standing);
  };
  mesh.object("pillars");
  for (int k = 0; k < 16; ++k) {
    const Point at((k % 4 * 8 - 12) * m, (k / 4 * 8 - 12) * m, 0);
    if (k == 6 || k == 9) {
      crate(at);
      continue;
    }
    const Point up(0, 0, (3 + k * 7 % 3) * m);
    std::array<Point, 8> top_ring;
    for (int i = 0; i < 8; ++i) {
      const Point a = at + corner(i, 12, 0), b = at + corner(i + 1, 12, 0);
      mesh.polygon({a, b, b + up, a + up});
      top_ring[static_cast<std::size_t>(i)] = a + up;
    }
    mesh.polygon(top_ring);
  }
  mesh.object("crates");
  for (int k = 0; k < 16; ++k) crate({(k % 4 * 8 - 12) * m, (k / 4 * 8 - 8) * m, 0});
}

}  // namespace

Model make_arena() {
  Mesh mesh;
  mesh.object("sand");
  std::array<Point, 8> ring;
  for (int i = 0; i < 8; ++i) ring[static_cast<std::size_t>(i)] = corner(i, sand, 0);
  mesh.polygon(ring);
  mesh.object("podium");
  add_gate_wall(mesh, sand, podium, Seen::from_inside);
  for (int k = 0; k < tiers; ++k) {
    mesh.object("tier " + std::to_string(k));
    const int r = sand + k * tier_depth, z = podium + k * tier_rise;
    add_ring(mesh, r, z, r + tier_depth, z, Seen::from_inside);
    add_ring(mesh, r + tier_depth, z, r + tier_depth, z + tier_rise, Seen::from_inside);
  }
  add_gallery(mesh);
  mesh.object("gates");
  add_tunnels(mesh, sand, passage_in);
  add_tunnels(mesh, passage_out, facade);
  mesh.object("passage");
  add_gate_wall(mesh, passage_in, passage_height, Seen::from_outside);
  add_gate_wall(mesh, passage_out, passage_height, Seen::from_inside);
  add_ring(mesh, passage_in, 0, passage_out, 0, Seen::from_inside);
  add_ring(mesh, passage_in, passage_height, passage_out, passage_height, Seen::from_outside);
  mesh.object("facade");
  add_gate_wall(mesh, facade, roof, Seen::from_outside);
  mesh.object("ground");
  add_ring(mesh, facade, 0, 2 * facade, 0, Seen::from_inside);
  add_obstacles(mesh);

  // Through a gate, round within the stands, between the pillars, and up for a look over all.
  const double eye = 1.625;
  const std::vector<Waypoint> way{
      {{-50, 0, eye}},    {{-31.5, 0, eye}},    {{-31.5, -13.125, eye}}, {{-13.125, -31.5, eye}}, {{0, -31.5, eye}},
      {{0, -5.875, eye}}, {{8, -5.875, eye}},   {{8, 18.5, eye}, 0.1},   {{-8, 18.5, eye}, 0.1},  {{-8, -18, eye}},
      {{0, -18, 8}, 0},   {{0, -4, 14}, -0.15}, {{0, 16, 14}, -0.2}};
  return {mesh.take("arena"), walk(way, walk_cameras, {.corner = 1, .yaw = 0.25, .yaw_waves = 7, .pitch = 0.1})};
}

}  // namespace sightline::models
