// Laws of the stitcher, on small scenes whose fragments are made by brute force, and examples worked out by hand.
#include "visibility_map/stitch.hpp"
#include "tests/stitch/brute_fragments.hpp"
#include "visibility_map/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace sightline::testing {
namespace {

PolygonSoup soup_of(std::vector<glm::dvec3> vertices, std::vector<std::vector<std::uint32_t>> polygons) {
  PolygonSoup soup;
  soup.source = "test.obj";
  soup.vertices = std::move(vertices);
  for (const auto& polygon : polygons) {
    soup.corners.insert(soup.corners.end(), polygon.begin(), polygon.end());
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

/// The camera of all examples: at (0,0,0), looks along y; (x, y, z) is seen at s = x / y + 1/2, t = z / y + 1/2.
VisibilityMap stitch(const Scene& scene, const Camera& camera = {}, const BruteOptions& options = {}) {
  SightlineTable table(scene.planes());
  table.reset(scene.planes(), scene.grid().point(camera.eye));
  Stitcher stitcher;
  VisibilityMap map;
  stitcher.stitch(scene, camera, table, brute_fragments(scene, &camera, table, options), map);
  return map;
}
VisibilityMap stitch(std::vector<glm::dvec3> vertices, std::vector<std::vector<std::uint32_t>> polygons) {
  return stitch(make_scene(soup_of(std::move(vertices), std::move(polygons))));
}

double sum_of(const VisibilityMap& map, double MapFace::*part) {
  return std::accumulate(map.faces.begin(), map.faces.end(), 0.0,
                         [&](double sum, const MapFace& f) { return sum + f.*part; });
}
std::uint32_t tail(const VisibilityMap& map, std::int32_t h) {
  return h >= 0 ? map.edges[static_cast<std::size_t>(h)].vertex[0]
                : map.edges[static_cast<std::size_t>(-h - 1)].vertex[1];
}
std::uint32_t head(const VisibilityMap& map, std::int32_t h) { return tail(map, -h - 1); }
std::size_t count(const VisibilityMap& map, EdgeKind kind) {
  return static_cast<std::size_t>(
      std::count_if(map.edges.begin(), map.edges.end(), [&](const MapEdge& e) { return e.kind == kind; }));
}
std::size_t vertex_at(const VisibilityMap& map, double s, double t) {
  for (std::size_t k = 0; k < map.vertices.size(); ++k) {
    if (map.vertices[k].st == glm::dvec2(s, t)) return k;
  }
  ADD_FAILURE() << "no vertex at " << s << ", " << t;
  return 0;
}

/// Everything that FORMATS says of the combinatorics.
void expect_sound(const VisibilityMap& map) {
  std::vector<int> used(2 * map.edges.size(), 0);
  ASSERT_EQ(map.first_edge.back(), map.loop_edges.size());
  std::uint32_t loops = 0;
  for (std::uint32_t f = 0; f < map.faces.size(); ++f) {
    const MapFace& face = map.faces[f];
    EXPECT_EQ(face.first_loop, loops);
    loops += face.loop_count;
    for (std::uint32_t l = face.first_loop; l < loops; ++l) {
      const auto loop = map.loop(l);
      double twice = 0;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::int32_t h = loop[k], next = loop[(k + 1) % loop.size()];
        const auto e = static_cast<std::size_t>(h >= 0 ? h : -h - 1);
        EXPECT_EQ(head(map, h), tail(map, next));
        EXPECT_EQ(h >= 0 ? map.edges[e].left : map.edges[e].right, f);
        ++used[2 * e + (h < 0)];
        const glm::dvec2 a = map.vertices[tail(map, h)].st, b = map.vertices[head(map, h)].st;
        twice += a.x * b.y - a.y * b.x;
      }
      if (!map.sphere) {
        EXPECT_EQ(twice > 0, l == face.first_loop) << "face " << f;
      }
    }
    EXPECT_GT(face.solid_angle, 0);
    EXPECT_TRUE(std::is_sorted(map.coincident_of(face).begin(), map.coincident_of(face).end()));
  }
  std::vector<int> degree(map.vertices.size(), 0);
  for (std::size_t e = 0; e < map.edges.size(); ++e) {
    const MapEdge& edge = map.edges[e];
    EXPECT_LT(edge.vertex[0], edge.vertex[1]);
    EXPECT_EQ(used[2 * e], edge.left != none);
    EXPECT_EQ(used[2 * e + 1], edge.right != none);
    EXPECT_EQ(edge.kind == EdgeKind::window, edge.left == none || edge.right == none);
    EXPECT_EQ(edge.kind == EdgeKind::silhouette, edge.owner != none);
    if (edge.left != none && edge.right != none) {
      EXPECT_NE(map.faces[edge.left].polygon, map.faces[edge.right].polygon);
    }
    ++degree[edge.vertex[0]];
    ++degree[edge.vertex[1]];
  }
  EXPECT_TRUE(std::all_of(degree.begin(), degree.end(), [](int d) { return d >= 2; }));
  for (const MapVertex& v : map.vertices) EXPECT_NE(v.line[0], v.line[1]);
  std::set<std::uint32_t> lines;
  for (const MapEdge& e : map.edges) lines.insert(e.line);
  for (const MapVertex& v : map.vertices) lines.insert({v.line[0], v.line[1]});
  EXPECT_EQ(lines.size(), map.lines.size());
}

TEST(Stitch, DoesNotDependOnTheFragments) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const Scene scene = make_scene(random_soup(random));
    const Camera camera = random_camera(random);
    const VisibilityMap map = stitch(scene, camera);
    const std::string json = map_json(map, scene);
    expect_sound(map);
    EXPECT_NEAR(sum_of(map, &MapFace::area), 1, 1e-14) << seed;
    for (int cuts = 1; cuts <= 3; cuts += 2) {
      ASSERT_EQ(json, map_json(stitch(scene, camera, {seed, cuts, true}), scene)) << "seed " << seed;
    }
  }
}

TEST(Stitch, DoesNotDependOnTheFragmentsWhereAlmostEverythingCoincides) {
  for (unsigned seed = 100; seed < 120; ++seed) {
    std::mt19937 random(seed);
    PolygonSoup soup = random_soup(random, 4);
    for (glm::dvec3& v : soup.vertices) {
      for (int k = 0; k < 3; ++k) v[k] += (static_cast<int>(random() % 3) - 1) * 0x1p-48;
    }
    const Scene scene = make_scene(soup);
    const Camera camera = random_camera(random);
    const VisibilityMap map = stitch(scene, camera);
    ASSERT_EQ(map_json(map, scene), map_json(stitch(scene, camera, {seed, 1, true}), scene)) << "seed " << seed;
    EXPECT_NEAR(sum_of(map, &MapFace::area), 1, 1e-14) << seed;
  }
}

TEST(Stitch, MirroredCameraMirrorsTheMap) {
  for (unsigned seed = 200; seed < 215; ++seed) {
    std::mt19937 random(seed);
    const Scene scene = make_scene(random_soup(random));
    const Camera camera = random_camera(random);
    Camera mirrored = camera;
    mirrored.right = -camera.right;
    const VisibilityMap a = stitch(scene, camera), b = stitch(scene, mirrored);
    expect_sound(b);
    ASSERT_EQ(a.faces.size(), b.faces.size());
    ASSERT_EQ(a.edges.size(), b.edges.size());
    const auto summary = [](const VisibilityMap& map) {
      std::vector<std::tuple<PolygonId, double, double>> faces;
      for (const MapFace& f : map.faces) faces.push_back({f.polygon, f.area, f.solid_angle});
      std::sort(faces.begin(), faces.end());
      return faces;
    };
    const auto fa = summary(a), fb = summary(b);
    for (std::size_t k = 0; k < fa.size(); ++k) {
      EXPECT_EQ(std::get<0>(fa[k]), std::get<0>(fb[k]));
      EXPECT_NEAR(std::get<1>(fa[k]), std::get<1>(fb[k]), 1e-12);
      EXPECT_NEAR(std::get<2>(fa[k]), std::get<2>(fb[k]), 1e-12);
    }
  }
}

TEST(Stitch, SphereIsWholeAndAgreesWithTheWindow) {
  for (unsigned seed = 300; seed < 308; ++seed) {
    std::mt19937 random(seed);
    const Scene scene = make_scene(random_soup(random));
    const Camera camera = random_camera(random);
    SightlineTable table(scene.planes());
    Stitcher stitcher;
    VisibilityMap map, again;
    for (const int cuts : {0, 2}) {
      table.reset(scene.planes(), scene.grid().point(camera.eye));
      const Fragments fragments = brute_fragments(scene, nullptr, table, {seed, cuts, cuts > 0});
      stitcher.stitch_sphere(scene, camera.eye, table, fragments, cuts == 0 ? map : again);
    }
    expect_sound(map);
    EXPECT_NEAR(sum_of(map, &MapFace::solid_angle), 4 * std::numbers::pi, 1e-12) << seed;
    ASSERT_EQ(map.faces.size(), again.faces.size()) << seed;
    ASSERT_EQ(map.lines, again.lines);
    ASSERT_EQ(map.loop_edges, again.loop_edges);
    for (std::size_t k = 0; k < map.vertices.size(); ++k) {
      ASSERT_EQ(map.vertices[k].direction, again.vertices[k].direction);
      ASSERT_EQ(map.vertices[k].scene_vertex, again.vertices[k].scene_vertex);
    }
    // A polygon shows no more in the window than on the sphere.
    std::map<PolygonId, double> seen;
    for (const MapFace& f : map.faces) seen[f.polygon] += f.solid_angle;
    for (const MapFace& f : stitch(scene, camera).faces) seen[f.polygon] -= f.solid_angle;
    for (const auto& [polygon, rest] : seen) EXPECT_GT(rest, -1e-12) << "polygon " << polygon;
  }
}

TEST(Stitch, EmptySphereIsOneFace) {
  // The only polygon contains the eye in its plane.
  const Scene scene = make_scene(soup_of({{1, 0, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}}));
  SightlineTable table(scene.planes());
  table.reset(scene.planes(), scene.grid().point({0, 0, 0}));
  Stitcher stitcher;
  VisibilityMap map;
  stitcher.stitch_sphere(scene, {0, 0, 0}, table, brute_fragments(scene, nullptr, table, {}), map);
  ASSERT_EQ(map.faces.size(), 1u);
  EXPECT_EQ(map.faces[0].polygon, none);
  EXPECT_EQ(map.faces[0].loop_count, 0u);
  EXPECT_EQ(map.faces[0].solid_angle, 4 * std::numbers::pi);
}

// A square [-1,1]^2 at y = 4, seen in the middle half of the window.
const std::vector<glm::dvec3> square{{-1, 4, -1}, {1, 4, -1}, {1, 4, 1}, {-1, 4, 1}};

TEST(Stitch, OneSquareIsAHole) {
  const VisibilityMap map = stitch(square, {{0, 1, 2, 3}});
  expect_sound(map);
  ASSERT_EQ(map.faces.size(), 2u);
  EXPECT_EQ(map.edges.size(), 8u);
  EXPECT_EQ(map.faces[0].polygon, none);
  EXPECT_EQ(map.faces[0].loop_count, 2u);
  EXPECT_EQ(map.faces[1].polygon, 0u);
  EXPECT_EQ(map.faces[0].area, 0.75);
  EXPECT_EQ(map.faces[1].area, 0.25);
  // A square pyramid: 4 asin(sin^2 of the half angle), here with tan = 1/4.
  EXPECT_NEAR(map.faces[1].solid_angle, 4 * std::asin(1.0 / 17), 1e-15);
  EXPECT_EQ(map.vertices[vertex_at(map, 0.25, 0.75)].scene_vertex, 3u);
  EXPECT_EQ(map.vertices[vertex_at(map, 0, 0)].scene_vertex, none);
  EXPECT_EQ(count(map, EdgeKind::silhouette), 4u);
  ASSERT_EQ(map.lines.size(), 8u);
  EXPECT_EQ(map.lines[4], (MapLine{MapLine::edge, {0, 1}}));
  EXPECT_EQ(map.lines[7], (MapLine{MapLine::edge, {2, 3}}));
}

TEST(Stitch, CoplanarNeighboursMeetInASeamAndOverlapBelongsToTheLowest) {
  auto vertices = square;
  for (const glm::dvec3& p : {glm::dvec3(0, 4, -1), {2, 4, -1}, {2, 4, 1}, {0, 4, 1}}) vertices.push_back(p);
  const VisibilityMap map = stitch(vertices, {{0, 1, 2, 3}, {4, 5, 6, 7}});
  expect_sound(map);
  EXPECT_EQ(count(map, EdgeKind::seam), 1u);
  for (const MapFace& f : map.faces) {
    if (f.polygon == 0) {
      ASSERT_EQ(f.coincident_count, 1u);
      EXPECT_EQ(map.coincident_of(f)[0], 1u);
      EXPECT_EQ(f.area, 0.25);
    } else {
      EXPECT_EQ(f.coincident_count, 0u);
    }
    if (f.polygon == 1) {
      EXPECT_EQ(f.area, 0.125);
    }
  }
}

TEST(Stitch, DiagonalsLeaveNoTrace) {
  // Not planar: two triangles, one polygon.
  auto vertices = square;
  vertices[2].y = 5;
  const VisibilityMap map = stitch(vertices, {{0, 1, 2, 3}});
  expect_sound(map);
  EXPECT_EQ(map.faces.size(), 2u);
  EXPECT_EQ(count(map, EdgeKind::silhouette), 4u);
}

TEST(Stitch, CreaseOnASharedEdgeAndOnOneThatEndsOnAFloor) {
  // A roof of two squares that share the edge 0-3, and a fin that stands on the left one.
  const VisibilityMap roof =
      stitch({{0, 4, -1}, {-1, 6, -1}, {-1, 6, 1}, {0, 4, 1}, {1, 6, -1}, {1, 6, 1}}, {{0, 1, 2, 3}, {0, 4, 5, 3}});
  expect_sound(roof);
  ASSERT_EQ(count(roof, EdgeKind::crease), 1u);
  // A wall that ends on a larger one, inside it.
  const VisibilityMap fin =
      stitch({{-4, 8, -4}, {4, 8, -4}, {4, 8, 4}, {-4, 8, 4}, {1, 8, -1}, {1, 8, 1}, {1, 4, 1}, {1, 4, -1}},
             {{0, 1, 2, 3}, {4, 5, 6, 7}});
  expect_sound(fin);
  ASSERT_EQ(count(fin, EdgeKind::crease), 1u);
  for (const MapEdge& e : fin.edges) {
    if (e.kind == EdgeKind::crease) {
      EXPECT_EQ(fin.lines[e.line], (MapLine{MapLine::edge, {4, 5}}));
    }
    if (e.kind == EdgeKind::silhouette) {
      EXPECT_EQ(e.owner, 1u);
    }
  }
}

TEST(Stitch, CreaseTurnsIntoIntersectionWhereTheEdgeEnds) {
  // Polygon 1 has the vertex 4 on polygon 0's plane in the middle of its cut: its edge 4-5 lies in the plane, and from
  // 4 on its inside passes through.
  const VisibilityMap map = stitch({{-4, 8, -4},
                                    {4, 8, -4},
                                    {4, 8, 4},
                                    {-4, 8, 4},
                                    {1, 8, 0},
                                    {1, 8, 2},
                                    {1, 4, 2},
                                    {1, 4, -2},
                                    {1, 12, -2},
                                    {1, 12, 0}},
                                   {{0, 1, 2, 3}, {4, 5, 6, 7, 8, 9}});
  expect_sound(map);
  ASSERT_EQ(count(map, EdgeKind::crease), 1u);
  ASSERT_EQ(count(map, EdgeKind::intersection), 1u);
  EXPECT_EQ(map.vertices[vertex_at(map, 0.625, 0.5)].scene_vertex, 4u);
  for (const MapEdge& e : map.edges) {
    if (e.kind == EdgeKind::intersection) {
      EXPECT_EQ(map.lines[e.line].kind, MapLine::planes);
    }
  }
}

TEST(Stitch, CrossingEdgesThatAreCollinearInTheWindowAreSplit) {
  // Both squares end on the plane x = 0, one leaning forwards above, the other below.
  const VisibilityMap map =
      stitch({{0, 4, -1}, {0, 6, 1}, {-2, 6, 1}, {-2, 4, -1}, {0, 6, -1}, {0, 4, 1}, {2, 4, 1}, {2, 6, -1}},
             {{0, 1, 2, 3}, {4, 5, 6, 7}});
  expect_sound(map);
  const std::size_t v = vertex_at(map, 0.5, 0.5);
  const MapVertex& vertex = map.vertices[v];
  EXPECT_EQ(map.lines[vertex.line[0]].kind, MapLine::edge);
  EXPECT_EQ(map.lines[vertex.line[1]].kind, MapLine::planes);
  std::set<PolygonId> owners;
  for (const MapEdge& e : map.edges) {
    if (e.vertex[0] == v || e.vertex[1] == v) owners.insert(e.owner);
  }
  EXPECT_EQ(owners, (std::set<PolygonId>{0, 1}));
}

TEST(Stitch, RefusesFragmentsThatDoNotTile) {
  const Scene scene = make_scene(soup_of(square, {{0, 1, 2, 3}}));
  const Camera camera;
  SightlineTable table(scene.planes());
  table.reset(scene.planes(), scene.grid().point(camera.eye));
  Fragments fragments = brute_fragments(scene, &camera, table, {});
  Stitcher stitcher;
  VisibilityMap map;
  Fragments gap = fragments;
  gap.fragments.pop_back();
  EXPECT_THROW(stitcher.stitch(scene, camera, table, gap, map), std::logic_error);
  Fragments twice = fragments;
  twice.fragments.push_back(twice.fragments.front());
  EXPECT_THROW(stitcher.stitch(scene, camera, table, twice, map), std::logic_error);
  // And goes on afterwards.
  stitcher.stitch(scene, camera, table, fragments, map);
  expect_sound(map);
}

}  // namespace
}  // namespace sightline::testing
