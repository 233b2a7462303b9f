// Planar polygons of every kind: the pieces tile the even-odd interior.
#include "flat_geometry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline::test {
namespace {

using Loop = std::vector<std::array<int, 2>>;

/// A plane of space: (x, y) is put at origin + x u + y v. `scale` makes the coordinates long.
struct Place {
  glm::dvec3 u, v;
  double scale = 1;
};
const Place places[] = {{{1, 0, 0}, {0, 1, 0}},          {{0, 1, 0}, {1, 0, 0}},
                        {{0, 0, 1}, {1, 0, 0}},          {{1, 2, 3}, {-1, 4, 0}},
                        {{2, -1, 5}, {0, 3, 1}},         {{1, 1, 0}, {0, 0, 1}},
                        {{1, 2, 3}, {3, -2, 7}, 0.1},    {{0, -1, 1}, {1, 0, 1}, 0x1.2345678p-30},
                        {{1, 0, 1}, {0, 1, 1}, 0x1.9p80}};

PolygonSoup soup_of(const Loop& loop, const Place& place) {
  PolygonSoup soup;
  for (const auto& [x, y] : loop) {
    const glm::dvec3 p = static_cast<double>(x) * place.u + static_cast<double>(y) * place.v;
    soup.vertices.push_back(p * place.scale);
    soup.corners.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  return soup;
}

mpq_class twice_area_of_pieces(const Scene& scene, PolygonId p) {
  mpq_class sum;
  for (const Surface& s : scene.surfaces(p)) sum += abs(twice_area(flat_corners(scene, s)));
  return sum;
}

/// The pieces of polygon 0, which is planar: sound, disjoint, and together what the even-odd rule says.
void expect_tiling(const Scene& scene) {
  ASSERT_TRUE(scene.planar(0));
  const auto pieces = scene.surfaces(0);
  if (pieces.empty()) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(twice_even_odd_area(flat_loop(scene, 0, axis)), 0);
    EXPECT_EQ(scene.report().dropped, 1u);
    return;
  }
  EXPECT_EQ(scene.report().dropped, 0u);
  const int axis = axis_of(scene, pieces[0]);
  const FlatLoop loop = flat_loop(scene, 0, axis);
  for (const Surface& s : pieces) {
    EXPECT_EQ(s.plane, pieces[0].plane);
    expect_sound_surface(scene, s);
    const FlatLoop corners = flat_corners(scene, s);
    const Flat inside{(corners[0].x + corners[1].x + corners[2].x) / 3,
                      (corners[0].y + corners[1].y + corners[2].y) / 3};
    const int turns = winding_number(loop, inside);
    EXPECT_NE(turns % 2, 0);
    EXPECT_EQ(s.flipped, (turns > 0 ? 1 : -1) != slope_of(scene, s));
    for (const Surface& other : pieces) {  // disjoint: an edge of one has the other on its outer side
      if (&other == &s) continue;
      const FlatLoop theirs = flat_corners(scene, other);
      const auto separates = [&](const FlatLoop& a, const FlatLoop& b) {
        for (std::size_t k = 0; k < a.size(); ++k) {
          const Flat &p = a[k], &q = a[(k + 1) % a.size()];
          bool out = true;
          for (const Flat& c : b) out &= slope_of(scene, s) * sgn(cross(p, q, c)) <= 0;
          if (out) return true;
        }
        return false;
      };
      EXPECT_TRUE(separates(corners, theirs) || separates(theirs, corners));
    }
  }
  EXPECT_EQ(twice_area_of_pieces(scene, 0), twice_even_odd_area(loop));
}

struct Named {
  const char* name;
  Loop loop;
  std::uint32_t pieces;  // at most
  bool nonconvex, self_crossing;
};

const Named named[] = {
    {"square", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 1, false, false},
    {"square clockwise", {{0, 0}, {0, 2}, {2, 2}, {2, 0}}, 1, false, false},
    {"collinear and repeated",
     {{0, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}},
     1,
     false,
     false},
    {"spur outwards", {{0, 0}, {2, 0}, {2, 2}, {3, 3}, {2, 2}, {0, 2}}, 1, false, false},
    {"spur inwards", {{0, 0}, {4, 0}, {4, 4}, {2, 2}, {4, 4}, {0, 4}}, 1, false, false},
    {"spur along an edge", {{0, 0}, {4, 0}, {1, 0}, {4, 0}, {4, 4}, {0, 4}}, 1, false, false},
    {"edge that overshoots", {{0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}}, 1, false, false},
    {"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 2, true, false},
    {"U", {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3, true, false},
    {"arrow", {{0, 0}, {4, 0}, {1, 1}, {0, 4}}, 2, true, false},
    {"comb",
     {{0, 0}, {9, 0}, {9, 3}, {8, 3}, {8, 1}, {7, 1}, {7, 3}, {6, 3}, {6, 1}, {5, 1},
      {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
     6,
     true,
     false},
    {"keyhole", {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}, 4, true, false},
    {"bow tie", {{0, 0}, {2, 2}, {2, 0}, {0, 2}}, 2, true, true},
    {"pentagram", {{0, 3}, {6, 3}, {1, 0}, {3, 5}, {5, 0}}, 5, true, true},
    {"twice round", {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0, false, true},
    {"there and back", {{0, 0}, {2, 0}, {2, 2}, {2, 0}}, 0, false, false},
    {"all in a line", {{0, 0}, {2, 2}, {5, 5}, {1, 1}}, 0, false, false},
    {"one place", {{1, 1}, {1, 1}, {1, 1}}, 0, false, false},
    {"two squares that touch", {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}, 2, true, false},
};

TEST(Decompose, NamedLoopsInManyPlanes) {
  for (const Named& n : named) {
    for (const Place& place : places) {
      if (place.scale == 0.1) continue;  // not planar after rounding
      SCOPED_TRACE(n.name);
      const Scene scene = make_scene(soup_of(n.loop, place));
      expect_tiling(scene);
      EXPECT_LE(scene.surfaces(0).size(), n.pieces);
      EXPECT_EQ(scene.report().nonconvex, n.nonconvex ? 1u : 0u);
      EXPECT_EQ(scene.report().self_crossing, n.self_crossing && n.nonconvex ? 1u : 0u);
      EXPECT_EQ(scene.report().nonplanar, 0u);
    }
  }
}

RC_GTEST_PROP(Decompose, RandomLoopsTileTheEvenOddInterior, ()) {
  const int range = *rc::gen::element(3, 5, 50, 1000);  // a small one makes coincidences
  const int count = *rc::gen::inRange(3, 13);
  Loop loop;
  for (int k = 0; k < count; ++k) loop.push_back({*rc::gen::inRange(0, range), *rc::gen::inRange(0, range)});
  const Place& place = places[*rc::gen::inRange(0, 6)];
  expect_tiling(make_scene(soup_of(loop, place)));
}

RC_GTEST_PROP(Decompose, ReversingTheLoopFlipsThePieces, ()) {
  const int count = *rc::gen::inRange(3, 9);
  Loop loop;
  for (int k = 0; k < count; ++k) loop.push_back({*rc::gen::inRange(0, 6), *rc::gen::inRange(0, 6)});
  const Place& place = places[*rc::gen::inRange(0, 6)];
  const Scene forth = make_scene(soup_of(loop, place));
  std::reverse(loop.begin(), loop.end());
  const Scene back = make_scene(soup_of(loop, place));
  RC_ASSERT(forth.report().self_crossing == back.report().self_crossing);
  const auto flipped_area = [](const Scene& scene, bool flipped) {
    mpq_class sum;
    for (const Surface& s : scene.surfaces(0)) {
      if (s.flipped == flipped) sum += abs(twice_area(flat_corners(scene, s)));
    }
    return sum;
  };
  RC_ASSERT(flipped_area(forth, true) == flipped_area(back, false));
  RC_ASSERT(flipped_area(forth, false) == flipped_area(back, true));
}

/// A staircase of 400 steps and a star of 301 points: large loops, in good time and few pieces.
TEST(Decompose, LargeLoops) {
  Loop stairs;
  for (int k = 0; k < 400; ++k) {
    stairs.push_back({k, k});
    stairs.push_back({k + 1, k});
  }
  stairs.push_back({400, 400});
  stairs.push_back({-1, 400});
  stairs.push_back({-1, 0});
  const Scene scene = make_scene(soup_of(stairs, places[3]));
  const int axis = axis_of(scene, scene.surfaces(0)[0]);
  EXPECT_EQ(twice_area_of_pieces(scene, 0), abs(twice_area(flat_loop(scene, 0, axis))));
  EXPECT_LE(scene.surfaces(0).size(), 800u);

  Loop star;
  for (int k = 0; k < 301; ++k) {
    const double angle = 2 * std::acos(-1.0) * 150 * k / 301;
    star.push_back({static_cast<int>(1e6 * std::cos(angle)), static_cast<int>(1e6 * std::sin(angle))});
  }
  star.resize(61);  // every edge crosses most others
  const Scene crossing = make_scene(soup_of(star, places[0]));
  EXPECT_EQ(crossing.report().self_crossing, 1u);
  EXPECT_EQ(twice_area_of_pieces(crossing, 0), twice_even_odd_area(flat_loop(crossing, 0, 2)));
}

}  // namespace
}  // namespace sightline::test
