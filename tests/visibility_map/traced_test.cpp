// Queries on maps of random small scenes, full of alignments, against plain rational arithmetic.
#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "visibility_map/locate.hpp"
#include "visibility_map/read.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace sightline {
namespace {

using Rational = mpq_class;
using Vector = std::array<Rational, 3>;

Vector vector(const glm::dvec3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Triangles with corners on a small grid, seen from a place of the grid.
struct Traced {
  explicit Traced(unsigned seed) {
    std::mt19937_64 random(seed);
    const auto coordinate = [&](int range) { return static_cast<double>(random() % (2 * range + 1)) - range; };
    PolygonSoup triangles;
    triangles.source = "random.obj";
    const std::uint64_t count = 4 + random() % 20;
    for (std::uint64_t k = 0; k < count; ++k) {
      for (int corner = 0; corner < 3; ++corner) {
        triangles.corners.push_back(static_cast<std::uint32_t>(triangles.vertices.size()));
        triangles.vertices.emplace_back(coordinate(4), 1 + random() % 6, coordinate(4));
      }
      triangles.first.push_back(static_cast<std::uint32_t>(triangles.corners.size()));
    }
    scene = make_scene(std::move(triangles), {.snap = "", .one_sided = random() % 4 == 0});
    camera = {{coordinate(2), coordinate(1) - 1, coordinate(2)}, {0, 1, 0}, {2, 0, 0}, {0, 0, 1.5}};
    if (random() % 3 == 0) camera.forward = {0.25, 1, -0.5};
    const Complex complex = build(scene);
    Tracer(scene, complex).trace(camera, map);
  }

  /// Corners of a triangle in the camera's coordinates (w, x, y): p - eye = w forward + x right + y up.
  std::vector<Vector> triangle(PolygonId p) const {
    const Vector f = vector(camera.forward), r = vector(camera.right), u = vector(camera.up);
    const Vector ru = cross(r, u), uf = cross(u, f), fr = cross(f, r);
    const Rational det = dot(f, ru);
    std::vector<Vector> corners;
    for (const std::uint32_t v : scene.corners(p)) {
      const Vector d = minus(vector(scene.soup().vertices[v]), vector(camera.eye));
      corners.push_back({dot(d, ru) / det, dot(d, uf) / det, dot(d, fr) / det});
    }
    return corners;
  }
  /// Is it opaque towards the eye? Its plane contains the eye, or it is seen from the wrong side: no.
  bool opaque(PolygonId p) const {
    if (scene.surfaces(p).empty()) return false;
    const std::vector<Vector> c = triangle(p);
    const int side = sgn(dot(cross(c[0], c[1]), c[2]));
    // In the camera's coordinates orientation is that of the basis, which is left-handed for forward, right, up.
    return side != 0 && (!scene.options().one_sided || side > 0);
  }
  /// Area of the projection inside the window.
  Rational projected(PolygonId p) const {
    std::vector<Vector> corners = triangle(p);
    for (const std::array<int, 3>& side : {std::array{1, 2, 0}, {1, -2, 0}, {1, 0, 2}, {1, 0, -2}}) {
      const auto inside = [&](const Vector& v) -> Rational { return side[0] * v[0] + side[1] * v[1] + side[2] * v[2]; };
      std::vector<Vector> clipped;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector &a = corners[k], &b = corners[(k + 1) % corners.size()];
        const Rational da = inside(a), db = inside(b);
        if (da >= 0) clipped.push_back(a);
        if (sgn(da) * sgn(db) < 0) {
          Vector cut;
          for (std::size_t i = 0; i < 3; ++i) cut[i] = (a[i] * db - b[i] * da) / (db - da);
          clipped.push_back(cut);
        }
      }
      corners = clipped;
    }
    Rational twice = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vector &a = corners[k], &b = corners[(k + 1) % corners.size()];
      if (a[0] == 0 || b[0] == 0) return 0;
      twice += (a[1] * b[2] - a[2] * b[1]) / (a[0] * b[0]);
    }
    return abs(twice) / 2;
  }
  /// Line of the map in the camera's coordinates.
  Vector line(const MapLine& l) const {
    if (l.kind == MapLine::window) {
      const std::array<std::array<int, 3>, 4> sides{{{1, 2, 0}, {1, -2, 0}, {1, 0, 2}, {1, 0, -2}}};
      return {sides[l.v[0]][0], sides[l.v[0]][1], sides[l.v[0]][2]};
    }
    const auto at = [&](int k) { return minus(vector(scene.soup().vertices[l.v[k]]), vector(camera.eye)); };
    Vector n;
    if (l.kind == MapLine::edge) {
      n = cross(at(0), at(1));
    } else {
      const Vector p = cross(minus(at(1), at(0)), minus(at(2), at(0))),
                   q = cross(minus(at(4), at(3)), minus(at(5), at(3)));
      const Rational dp = dot(p, at(0)), dq = dot(q, at(3));
      for (std::size_t i = 0; i < 3; ++i) n[i] = dq * p[i] - dp * q[i];
    }
    return {dot(n, vector(camera.forward)), dot(n, vector(camera.right)), dot(n, vector(camera.up))};
  }
  Rational area(const MapFace& face) const {
    Rational twice = 0;
    for (std::uint32_t k = 0; k < face.loop_count; ++k) {
      std::vector<Vector> at;
      for (const std::int32_t e : map.loop(face.first_loop + k)) {
        const MapEdge& edge = map.edges[static_cast<std::size_t>(e >= 0 ? e : -e - 1)];
        const MapVertex& v = map.vertices[edge.vertex[e >= 0 ? 0 : 1]];
        at.push_back(cross(line(map.lines[v.line[0]]), line(map.lines[v.line[1]])));
      }
      for (std::size_t i = 0; i < at.size(); ++i) {
        const Vector &a = at[i], &b = at[(i + 1) % at.size()];
        twice += (a[1] * b[2] - a[2] * b[1]) / (a[0] * b[0]);
      }
    }
    return twice / 2;
  }
  /// The polygon seen at a point: the nearest, the lowest index among equals. `clear`: no polygon's border is there.
  PolygonId seen(const glm::dvec2& st, bool& clear) const {
    const Vector ray{1, Rational(st.x) - Rational(1, 2), Rational(st.y) - Rational(1, 2)};
    PolygonId nearest = none;
    Rational least;
    clear = true;
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
      if (!opaque(p)) continue;
      const std::vector<Vector> c = triangle(p);
      const int turn = sgn(dot(cross(c[0], c[1]), c[2]));
      bool inside = true, border = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const int side = sgn(dot(cross(c[k], c[(k + 1) % 3]), ray)) * turn;
        inside = inside && side >= 0;
        border = border || side == 0;
      }
      if (!inside) continue;
      const Vector n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
      const Rational depth = dot(n, c[0]) / dot(n, ray);
      if (depth <= 0) continue;
      if (border) clear = false;
      if (nearest == none || depth < least) nearest = p, least = depth;
    }
    return nearest;
  }

  Scene scene;
  Camera camera;
  VisibilityMap map;
};

TEST(TracedMaps, VisiblePartsAreThoseOfRationals) {
  int full = 0, partial = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Traced traced(seed);
    std::vector<Rational> areas(traced.scene.polygon_count());
    for (const MapFace& face : traced.map.faces) {
      const Rational area = traced.area(face);
      EXPECT_NEAR(face.area, area.get_d(), 1e-12);
      if (face.polygon != none) areas[face.polygon] += area;
    }
    std::vector<char> listed(areas.size());
    for (const PolygonVisibility& v : visible_polygons(traced.map, traced.scene)) {
      const Rational whole = traced.projected(v.polygon);
      listed[v.polygon] = 1;
      EXPECT_EQ(v.full, areas[v.polygon] == whole) << "seed " << seed << " polygon " << v.polygon;
      EXPECT_NEAR(v.area, areas[v.polygon].get_d(), 1e-12);
      EXPECT_NEAR(v.fraction, Rational(areas[v.polygon] / whole).get_d(), 1e-12);
      v.full ? ++full : ++partial;
    }
    for (PolygonId p = 0; p < areas.size(); ++p) EXPECT_EQ(listed[p] != 0, areas[p] > 0);
  }
  EXPECT_GT(full, 50);
  EXPECT_GT(partial, 50);
}

TEST(TracedMaps, LocationFindsWhatARayHits) {
  std::mt19937_64 random(17);
  for (unsigned seed = 201; seed <= 215; ++seed) {
    const Traced traced(seed);
    const Locator locator(traced.map, traced.scene);
    for (int round = 0; round < 150; ++round) {
      // Half of the points on a grid that many edges pass through.
      const auto coordinate = [&] {
        return round % 2 == 0 ? std::generate_canonical<double, 53>(random) : static_cast<double>(random() % 65) / 64;
      };
      const glm::dvec2 st{coordinate(), coordinate()};
      bool clear = false;
      const PolygonId seen = traced.seen(st, clear);
      const MapPlace place = locator.at(st);
      ASSERT_NE(place.kind, MapPlace::outside);
      if (place.kind == MapPlace::face) {
        // On the border of what is seen there is an edge, unless something coplanar goes on beyond it.
        if (clear) {
          EXPECT_EQ(traced.map.faces[place.index].polygon, seen) << "seed " << seed;
        }
      } else if (place.kind == MapPlace::edge) {
        EXPECT_TRUE(!clear || traced.map.edges[place.index].kind == EdgeKind::intersection ||
                    traced.map.edges[place.index].kind == EdgeKind::window)
            << "seed " << seed;
      }
    }
  }
}

TEST(TracedMaps, FilesGiveTheSameMapBack) {
  for (unsigned seed = 301; seed <= 320; ++seed) {
    const Traced traced(seed);
    const std::string json = map_json(traced.map, traced.scene);
    const MapFile read = parse_map(json, "traced.map.json");
    EXPECT_EQ(map_json(read.map, read.scene), json);
    EXPECT_EQ(map_csv(read.map, traced.scene, 0), map_csv(traced.map, traced.scene, 0));
  }
}

}  // namespace
}  // namespace sightline
