#include "visibility_map/locate.hpp"

#include "tests/visibility_map/sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace sightline {
namespace {

/// n x n quadrilaterals in the plane y = depth that fill the window, their inner vertices moved about at random.
struct Mesh {
  Mesh(std::uint32_t count, int y, unsigned seed) : n(count), depth(y) {
    std::mt19937_64 random(seed);
    const double unit = 0x1p-20;
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        const auto coordinate = [&](std::uint32_t k) {
          if (k == 0) return -0.5 * depth;
          if (k == n) return 0.5 * depth;
          const double jitter = std::generate_canonical<double, 53>(random) * 0.5 - 0.25;
          return std::round(depth * ((k + jitter) / n - 0.5) / unit) * unit;
        };
        const double x = coordinate(i);
        points.emplace_back(x, depth, coordinate(j));
      }
    }
    PolygonSoup polygons;
    polygons.vertices = points;
    Sketch sketch;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        const PointId p = at(i, j);
        const std::uint32_t upright = i == 0 ? 0 : i == n ? 1 : sketch.line(p, j < n ? at(i, j + 1) : at(i, j - 1));
        const std::uint32_t level = j == 0 ? 2 : j == n ? 3 : sketch.line(p, i < n ? at(i + 1, j) : at(i - 1, j));
        const auto seen = [&](double x) { return static_cast<double>(static_cast<long double>(x) / depth + 0.5L); };
        sketch.vertex({seen(points[p].x), seen(points[p].z)}, upright, level, p);
      }
    }
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t border = j == 0 ? 2 : j == n ? 3 : none;
        sketch.edge(at(i, j), at(i + 1, j), border == none ? sketch.line(at(i, j), at(i + 1, j)) : border,
                    border == none ? EdgeKind::seam : EdgeKind::window);
      }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        const std::uint32_t border = i == 0 ? 0 : i == n ? 1 : none;
        sketch.edge(at(i, j), at(i, j + 1), border == none ? sketch.line(at(i, j), at(i, j + 1)) : border,
                    border == none ? EdgeKind::seam : EdgeKind::window);
      }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::vector<std::uint32_t> loop{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        polygons.corners.insert(polygons.corners.end(), loop.begin(), loop.end());
        polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
        sketch.face(j * n + i, {loop}, 0, 0);
      }
    }
    map = std::move(sketch.result);
    scene = make_scene(std::move(polygons));
  }

  /// The place of a point, in rationals, from nothing but the mesh's points.
  MapPlace obvious(const glm::dvec2& st) const {
    const mpq_class s(st.x), t(st.y);
    if (s < 0 || s > 1 || t < 0 || t > 1) return {};
    std::vector<std::pair<mpq_class, mpq_class>> at;
    for (const glm::dvec3& p : points) {
      at.emplace_back(mpq_class(p.x) / depth + mpq_class(1, 2), mpq_class(p.z) / depth + mpq_class(1, 2));
    }
    for (std::uint32_t v = 0; v < at.size(); ++v) {
      if (at[v].first == s && at[v].second == t) return {MapPlace::vertex, v};
    }
    const auto turn = [&](std::uint32_t a, std::uint32_t b) {
      return sgn(mpq_class((at[b].first - at[a].first) * (t - at[a].second) -
                           (at[b].second - at[a].second) * (s - at[a].first)));
    };
    for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
      const auto [a, b] = map.edges[e].vertex;
      if (turn(a, b) != 0) continue;
      const mpq_class along = (s - at[a].first) * (s - at[b].first) + (t - at[a].second) * (t - at[b].second);
      if (along < 0) return {MapPlace::edge, e};
    }
    for (std::uint32_t f = 0; f < map.faces.size(); ++f) {
      bool inside = false;
      for (const std::int32_t entry : map.loop(map.faces[f].first_loop)) {
        const auto [a, b] = map.edges[static_cast<std::size_t>(entry >= 0 ? entry : -entry - 1)].vertex;
        if ((at[a].second > t) == (at[b].second > t)) continue;
        inside ^= (turn(a, b) > 0) == (at[b].second > at[a].second);
      }
      if (inside) return {MapPlace::face, f};
    }
    return {};
  }

  std::uint32_t n;
  int depth;
  std::vector<glm::dvec3> points;
  VisibilityMap map;
  Scene scene;
};

void expect_obvious(const Mesh& mesh, const Locator& locator, const glm::dvec2& st) {
  const MapPlace obvious = mesh.obvious(st);
  ASSERT_EQ(locator.at(st), obvious) << st.x << ' ' << st.y;
  ASSERT_EQ(locate(mesh.map, mesh.scene, st), obvious) << st.x << ' ' << st.y;
  ASSERT_EQ(locator.face_at(st), obvious.kind == MapPlace::face ? obvious.index : none);
}

/// A double and the two beside it.
std::array<double, 3> around(double x) { return {std::nextafter(x, -1), x, std::nextafter(x, 2)}; }

class Locate : public testing::TestWithParam<int> {};

TEST_P(Locate, AgreesWithRationals) {
  const Mesh mesh(5, GetParam(), 7);
  const Locator locator(mesh.map, mesh.scene);
  std::mt19937_64 random(11);
  for (int round = 0; round < 1500; ++round) {
    expect_obvious(mesh, locator,
                   {std::generate_canonical<double, 53>(random), std::generate_canonical<double, 53>(random)});
  }
  for (const MapVertex& v : mesh.map.vertices) {
    for (const double s : around(v.st.x)) {
      for (const double t : around(v.st.y)) expect_obvious(mesh, locator, {s, t});
    }
  }
  for (const MapEdge& e : mesh.map.edges) {
    const glm::dvec2 a = mesh.map.vertices[e.vertex[0]].st, b = mesh.map.vertices[e.vertex[1]].st;
    for (const double part : {0.5, 0.25, 0.1}) {
      const glm::dvec2 p = a + part * (b - a);
      for (const double t : around(p.y)) expect_obvious(mesh, locator, {p.x, t});
    }
  }
}

// At depth 1 and 2 the vertices are doubles, at 3 and 5 they are not.
INSTANTIATE_TEST_SUITE_P(Depths, Locate, testing::Values(1, 2, 3, 5));

TEST(LocateOutside, AndOnTheBorder) {
  const Mesh mesh(2, 1, 3);
  const Locator locator(mesh.map, mesh.scene);
  const double nan = std::nan("");
  for (const glm::dvec2 st : {glm::dvec2(-0x1p-60, 0.5), glm::dvec2(0.5, 1 + 0x1p-52), glm::dvec2(3, 3),
                              glm::dvec2(nan, 0.5), glm::dvec2(0.5, -INFINITY)}) {
    EXPECT_EQ(locator.at(st), MapPlace{});
    EXPECT_EQ(locate(mesh.map, mesh.scene, st), MapPlace{});
  }
  EXPECT_EQ(locator.at({0, 0}), (MapPlace{MapPlace::vertex, 0}));
  EXPECT_EQ(locator.at({1, 0.125}).kind, MapPlace::edge);
  EXPECT_EQ(locator.at({0x1p-1074, 0x1p-1074}).kind, MapPlace::face);
  EXPECT_EQ(locator.at({0x1p-1074, 0}).kind, MapPlace::edge);
}

TEST(LocateExact, PointsThatNoDoubleNames) {
  const Mesh mesh(3, 3, 5);
  const Locator locator(mesh.map, mesh.scene);
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    // s - 1/2 = x / 3 exactly; points have 20 bits after the point.
    const Integer x(std::ldexp(mesh.points[v].x, 20)), z(std::ldexp(mesh.points[v].z, 20));
    EXPECT_EQ(locator.at_exact({Integer(3 << 20), x, z}), (MapPlace{MapPlace::vertex, v}));
  }
  for (std::uint32_t e = 0; e < mesh.map.edges.size(); ++e) {
    const glm::dvec3 sum = mesh.points[mesh.map.edges[e].vertex[0]] + mesh.points[mesh.map.edges[e].vertex[1]];
    const Integer x(std::ldexp(sum.x, 20)), z(std::ldexp(sum.z, 20));
    EXPECT_EQ(locator.at_exact({Integer(6 << 20), x, z}), (MapPlace{MapPlace::edge, e}));
  }
  EXPECT_EQ(locator.at_exact({1, 1, 0}), MapPlace{});
}

TEST(LocateMany, CellsDoNotMatter) {
  const Mesh mesh(40, 3, 9);
  const Locator locator(mesh.map, mesh.scene);
  std::mt19937_64 random(13);
  std::vector<int> hits(mesh.map.faces.size());
  for (int round = 0; round < 20000; ++round) {
    const glm::dvec2 st{std::generate_canonical<double, 53>(random), std::generate_canonical<double, 53>(random)};
    const MapPlace place = locator.at(st);
    if (round % 100 == 0) {
      ASSERT_EQ(place, locate(mesh.map, mesh.scene, st));
    }
    ASSERT_EQ(place.kind, MapPlace::face);
    ++hits[place.index];
  }
  EXPECT_EQ(std::count(hits.begin(), hits.end(), 0), 0);
}

TEST(LocateHoles, TheWallAroundTheSquare) {
  const VisibilityMap map = SquareBeforeWall::map();
  const Scene scene = make_scene(SquareBeforeWall::polygons());
  const Locator locator(map, scene);
  EXPECT_EQ(locator.face_at({0.5, 0.5}), 1u);
  for (const glm::dvec2 st : {glm::dvec2(0.1, 0.5), glm::dvec2(0.9, 0.5), glm::dvec2(0.5, 0.1), glm::dvec2(0.5, 0.9)}) {
    EXPECT_EQ(locator.face_at(st), 0u);
  }
  EXPECT_EQ(locator.at({0.25, 0.5}), (MapPlace{MapPlace::edge, 7}));
  EXPECT_EQ(locator.at({0.25, 0.25}), (MapPlace{MapPlace::vertex, 4}));
  EXPECT_EQ(locator.face_at({std::nextafter(0.25, 0), 0.5}), 0u);
  EXPECT_EQ(locator.face_at({std::nextafter(0.25, 1), 0.5}), 1u);
}

TEST(LocateErrors, SphereAndStrangers) {
  VisibilityMap map = SquareBeforeWall::map();
  const Scene scene = make_scene(SquareBeforeWall::polygons());
  map.lines[4].v[1] = 99;
  EXPECT_THROW(locate(map, scene, {0.5, 0.25}), std::invalid_argument);
  map.sphere = true;
  EXPECT_THROW(Locator(map, scene), std::invalid_argument);
}

}  // namespace
}  // namespace sightline
