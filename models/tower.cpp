// A bell tower with rows of windows, mouldings, dentils, balustrades and a belfry with arches: Yu's model I.
#include "models/generators.hpp"
#include "models/mesh.hpp"
#include "models/walk.hpp"

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>

namespace sightline::models {
namespace {

constexpr int m = units_per_metre;

/// Draws each thing four times, once for each side. Points are given for the side that faces -y.
class FourSides {
 public:
  explicit FourSides(Mesh& mesh) : mesh_(mesh) {}

  void polygon(std::initializer_list<Point> corners) { polygon(std::vector<Point>(corners)); }
  void polygon(std::vector<Point> corners) {
    for (int side = 0; side < 4; ++side) {
      mesh_.polygon(corners);
      for (Point& p : corners) p = {-p.y, p.x, p.z};
    }
  }
  /// An upright rectangle at distance h from the middle, seen from outside; `inside`: from the middle.
  void wall(int x0, int x1, int z0, int z1, int h, bool inside = false) {
    if (inside) std::swap(x0, x1);
    polygon({{x0, -h, z0}, {x1, -h, z0}, {x1, -h, z1}, {x0, -h, z1}});
  }
  /// A box that stands out from `back_h` to `h`; its faces are named as seen on this side.
  void box(int x0, int x1, int z0, int z1, int back_h, int h, unsigned sides) {
    if (sides & front) wall(x0, x1, z0, z1, h);
    if (sides & back) wall(x0, x1, z0, z1, back_h, true);
    if (sides & left) polygon({{x0, -back_h, z0}, {x0, -h, z0}, {x0, -h, z1}, {x0, -back_h, z1}});
    if (sides & right) polygon({{x1, -h, z0}, {x1, -back_h, z0}, {x1, -back_h, z1}, {x1, -h, z1}});
    if (sides & bottom) polygon({{x0, -back_h, z0}, {x1, -back_h, z0}, {x1, -h, z0}, {x0, -h, z0}});
    if (sides & top) polygon({{x0, -h, z1}, {x1, -h, z1}, {x1, -back_h, z1}, {x0, -back_h, z1}});
  }
  /// A recess in the wall at h: its four inner sides and, at `back_h`, its back.
  void recess(int x0, int x1, int z0, int z1, int back_h, int h) {
    wall(x0, x1, z0, z1, back_h);
    polygon({{x0, -h, z0}, {x0, -back_h, z0}, {x0, -back_h, z1}, {x0, -h, z1}});
    polygon({{x1, -back_h, z0}, {x1, -h, z0}, {x1, -h, z1}, {x1, -back_h, z1}});
    polygon({{x0, -h, z0}, {x1, -h, z0}, {x1, -back_h, z0}, {x0, -back_h, z0}});
    polygon({{x0, -back_h, z1}, {x1, -back_h, z1}, {x1, -h, z1}, {x0, -h, z1}});
  }
  /// The body of a square profile, of points (half width, height) from below.
  void profile(std::initializer_list<glm::ivec2> points) {
    const glm::ivec2* before = nullptr;
    for (const glm::ivec2& p : points) {
      if (before) {
        const glm::ivec2 a = *before;
        if (p.x == 0) {
          polygon({{-a.x, -a.x, a.y}, {a.x, -a.x, a.y}, {0, 0, p.y}});
        } else {
          polygon({{-a.x, -a.x, a.y}, {a.x, -a.x, a.y}, {p.x, -p.x, p.y}, {-p.x, -p.x, p.y}});
        }
      }
      before = &p;
    }
  }

 private:
  Mesh& mesh_;
};

/// Blocks under an overhang that begins at height z on a wall at h.
void add_dentils(FourSides& sides, int count, int pitch, int z, int h) {
  for (int k = 0; k < count; ++k) {
    const int x = (2 * k + 1 - count) * pitch / 2;
    sides.box(x - 2, x + 2, z - 5, z, h, h + 5, front | left | right | bottom);
  }
}

/// Posts under a rail, both between h - 4 and h, on a floor at z.
void add_balustrade(FourSides& sides, int count, int pitch, int z, int h) {
  const int half = count * pitch / 2 + 4, rail = z + 14;
  for (int k = 0; k < count; ++k) {
    const int x = (2 * k + 1 - count) * pitch / 2;
    sides.box(x - 1, x + 1, z, rail, h - 3, h - 1, around);
  }
  sides.box(-half, half, rail, rail + 2, h - 4, h, all);
}

/// Five columns of windows in a wall at h.
void add_windows(FourSides& sides, int h, int z0, int z1, int rows) {
  constexpr int columns = 5, pitch = 26, half_width = 6, height = 40;
  const int row = (z1 - z0) / rows;
  int x = -h;
  for (int c = 0; c < columns; ++c) {
    const int middle = (c - columns / 2) * pitch, a = middle - half_width, b = middle + half_width;
    sides.wall(x, a, z0, z1, h);
    int z = z0;
    for (int r = 0; r < rows; ++r) {
      const int sill = z0 + r * row + (row - height) / 2;
      sides.wall(a, b, z, sill, h);
      sides.recess(a, b, sill, sill + height, h - 5, h);
      z = sill + height;
    }
    sides.wall(a, b, z, z1, h);
    x = b;
  }
  sides.wall(x, h, z0, z1, h);
}

/// Three arches through the wall of the belfry, between `inner` and h, from z0 (sill) to z1 (top of the wall).
void add_arches(FourSides& sides, int inner, int h, int z0, int z1) {
  // Half a circle of radius 12 about (0, spring), as short numbers.
  static constexpr std::array<glm::ivec2, 9> arc{glm::ivec2(-12, 0), glm::ivec2(-11, 5), glm::ivec2(-8, 9),
                                                 glm::ivec2(-4, 11), glm::ivec2(0, 12),  glm::ivec2(4, 11),
                                                 glm::ivec2(8, 9),   glm::ivec2(11, 5),  glm::ivec2(12, 0)};
  constexpr int pitch = 34, radius = 12;
  const int spring = z1 - 32;
  for (const bool inside : {false, true}) {
    const int y = inside ? inner : h;
    int x = -y;
    for (int k = -1; k <= 1; ++k) {
      sides.wall(x, k * pitch - radius, z0, z1, y, inside);
      x = k * pitch + radius;
      for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
        const glm::ivec2 a = arc[i] + glm::ivec2(k * pitch, spring), b = arc[i + 1] + glm::ivec2(k * pitch, spring);
        std::vector<Point> ring{{a.x, -y, a.y}, {b.x, -y, b.y}, {b.x, -y, z1}, {a.x, -y, z1}};
        if (inside) std::reverse(ring.begin(), ring.end());
        sides.polygon(ring);
      }
    }
    sides.wall(x, y, z0, z1, y, inside);
  }
  for (int k = -1; k <= 1; ++k) {
    std::vector<glm::ivec2> opening{{k * pitch - radius, z0}};
    for (const glm::ivec2& p : arc) opening.push_back(p + glm::ivec2(k * pitch, spring));
    opening.emplace_back(k * pitch + radius, z0);
    for (std::size_t i = 0; i < opening.size(); ++i) {
      const glm::ivec2 a = opening[i], b = opening[(i + 1) % opening.size()];
      sides.polygon({{a.x, -h, a.y}, {a.x, -inner, a.y}, {b.x, -inner, b.y}, {b.x, -h, b.y}});
    }
  }
}

/// A bell with eight sides, hung from the ceiling at z1.
void add_bell(Mesh& mesh, int z1) {
  static constexpr std::array<glm::ivec2, 5> profile{glm::ivec2(36, 24), glm::ivec2(24, 36), glm::ivec2(24, 60),
                                                     glm::ivec2(12, 72), glm::ivec2(12, 80)};
  const auto corner = [&](int i, glm::ivec2 p) {
    const int r = p.x, q = 5 * p.x / 12;
    const std::array<glm::ivec2, 8> ring{glm::ivec2(r, -q), glm::ivec2(r, q),   glm::ivec2(q, r),   glm::ivec2(-q, r),
                                         glm::ivec2(-r, q), glm::ivec2(-r, -q), glm::ivec2(-q, -r), glm::ivec2(q, -r)};
    return Point(ring[static_cast<std::size_t>(i % 8)].x, ring[static_cast<std::size_t>(i % 8)].y, z1 - 80 + p.y);
  };
  std::vector<Point> mouth;
  for (int i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
      mesh.polygon(
          {corner(i, profile[k]), corner(i + 1, profile[k]), corner(i + 1, profile[k + 1]), corner(i, profile[k + 1])});
    }
    mouth.push_back(corner(8 - i, profile[0]));
  }
  mesh.polygon(mouth);
}

std::vector<CameraLine> cameras_around() {
  // Twenty-four directions, fifteen degrees apart.
  static constexpr std::array<double, 7> cosine{1, 0.96875, 0.859375, 0.703125, 0.5, 0.265625, 0};
  std::vector<CameraLine> cameras;
  for (std::size_t k = 0; k < 24; ++k) {
    double x = cosine[k % 6], y = cosine[6 - k % 6];
    for (std::size_t turn = 0; turn < k / 6; ++turn) {
      const double old = x;
      x = -y;
      y = old;
    }
    const double away = 30 + static_cast<double>(k * 11 % 24), height = 1.75 + static_cast<double>(k * 7 % 24) * 2.5;
    cameras.push_back(look_at({x * away + 0.078125, y * away - 0.109375, height}, {0, 0, 16 + height / 2}));
  }
  return cameras;
}

}  // namespace

Model make_tower() {
  constexpr std::uint32_t polygons = 2409;
  Mesh mesh;
  FourSides sides(mesh);
  mesh.object("steps");
  sides.profile({{112, 0}, {112, 4}, {104, 4}, {104, 8}, {96, 8}, {96, 12}, {84, 12}});
  mesh.object("base");
  sides.wall(-84, -14, 12, 88, 84);
  sides.wall(14, 84, 12, 88, 84);
  sides.wall(-14, 14, 60, 88, 84);
  sides.recess(-14, 14, 12, 60, 74, 84);
  sides.profile({{84, 88}, {88, 88}, {90, 92}, {90, 96}, {86, 100}, {76, 100}, {76, 104}, {72, 104}});
  mesh.object("shaft");
  add_windows(sides, 72, 104, 104 + 6 * 84, 6);
  mesh.object("lower cornice");
  add_dentils(sides, 14, 10, 608, 72);
  sides.profile({{72, 608}, {80, 608}, {84, 614}, {84, 620}, {60, 620}});
  mesh.object("lower balustrade");
  add_balustrade(sides, 18, 8, 620, 84);
  mesh.object("belfry");
  add_arches(sides, 52, 60, 620, 720);
  mesh.box({-52, -52, 620}, {52, 52, 620}, top);
  mesh.hollow({-52, -52, 720}, {52, 52, 720}, top);
  mesh.object("bell");
  add_bell(mesh, 720);
  mesh.object("upper cornice");
  add_dentils(sides, 13, 8, 720, 60);
  sides.profile({{60, 720}, {68, 720}, {70, 724}, {70, 728}, {48, 728}, {48, 752}, {52, 752}, {52, 756}, {44, 756}});
  mesh.object("upper balustrade");
  add_balustrade(sides, 15, 8, 728, 69);
  mesh.object("obelisks");
  for (const int x : {-62, 54}) {
    sides.box(x, x + 8, 728, 738, 46, 54, front | left | right | back);
    const Point tip(x + 4, -50, 762);
    const std::array<Point, 4> foot{Point(x, -54, 738), Point(x + 8, -54, 738), Point(x + 8, -46, 738),
                                    Point(x, -46, 738)};
    for (std::size_t i = 0; i < 4; ++i) sides.polygon({foot[i], foot[(i + 1) % 4], tip});
  }
  mesh.object("spire");
  sides.profile(
      {{44, 756}, {32, 804}, {34, 804}, {34, 808}, {30, 808}, {20, 848}, {22, 848}, {22, 852}, {18, 852}, {0, 924}});
  mesh.object("ground");
  // As many strips on both sides as are missing, around the steps.
  const int outer = 40 * m, inner = 112;
  mesh.box({-outer, -outer, 0}, {-inner, outer, 0}, top);
  mesh.box({inner, -outer, 0}, {outer, outer, 0}, top);
  mesh.box({-inner, -outer, 0}, {inner, -inner, 0}, top);
  const int strips = static_cast<int>(polygons - mesh.size());
  const auto cut = [&](int k) { return k == strips ? outer : inner + (outer - inner) / strips * k; };
  for (int k = 0; k < strips; ++k) mesh.box({-inner, cut(k), 0}, {inner, cut(k + 1), 0}, top);
  return {mesh.take("tower"), cameras_around()};
}

}  // namespace sightline::models
