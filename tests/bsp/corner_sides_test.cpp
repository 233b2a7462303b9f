// Sides of the corners of pieces, against the predicate that is told nothing but the planes.
#include "bsp/corner_sides.hpp"

#include <gtest/gtest.h>

#include <random>

#include "bsp/pieces.hpp"
#include "models/model.hpp"

namespace sightline {
namespace {

/// Cuts surfaces by planes of others, again and again, and compares all signs on the way, those told by boxes too.
std::size_t compare_signs(const Scene& scene, std::size_t surfaces, std::size_t planes) {
  std::mt19937_64 random(3);
  const auto any_plane = [&](const Surface& near) {
    // Near in the list is near in space: planes through the surface, or a hair beside it.
    const std::size_t at = static_cast<std::size_t>(&near - scene.surfaces().data()) + random() % 48;
    return scene.surfaces()[at % scene.surfaces().size()].plane;
  };
  std::size_t cut = 0, told_by_box = 0;
  for (std::size_t k = 0; k < surfaces; ++k) {
    const auto s = static_cast<SurfaceId>(random() % scene.surfaces().size());
    Pieces pieces(scene, scene.planes());
    std::vector<Piece> parts{pieces.whole(s)};
    for (std::size_t i = 0; i < planes; ++i) {
      const PlaneId plane = any_plane(scene.surfaces()[s]);
      const Piece piece = parts[random() % parts.size()];
      CornerSides sides(scene, scene.planes(), s, plane);
      const Sign by_box = BoxSide(scene.planes().approx(plane)).of(piece.low, piece.high);
      for (const PieceCorner& c : pieces.corners(piece)) {
        const Sign side = vertex_side(scene.planes(), c.place, plane);
        EXPECT_EQ(sides.of(c), side);
        if (by_box != 0) {
          EXPECT_EQ(by_box, side);
        }
      }
      told_by_box += by_box != 0;
      if (pieces.sides(piece, plane) != 3) continue;
      Piece halves[2];
      pieces.split(piece, plane, halves[0], halves[1]);
      parts.insert(parts.end(), halves, halves + 2);
      ++cut;
    }
  }
  EXPECT_GT(told_by_box, surfaces);
  return cut;
}

TEST(CornerSides, AreThoseOfTheVertices) {
  for (const double degrees : {0.0, 17.0}) {
    for (const char* name : {"arena", "city", "floor", "random"}) {
      const Scene scene = make_scene(make_model(name, {.rotate_degrees = degrees}).soup);
      EXPECT_GT(compare_signs(scene, 1'000, 60), 100u) << name;
    }
  }
}

// A polygon that crosses itself has corners that are no points of the file, and sides that end amid its edges.
TEST(CornerSides, OfPolygonsThatCrossThemselves) {
  PolygonSoup soup;
  std::mt19937_64 random(11);
  for (int k = 0; k < 60; ++k) {
    const double z = static_cast<double>(random() % 3);
    for (int i = 0; i < 5; ++i) {
      glm::dvec3 p{static_cast<double>(random() % 7), static_cast<double>(random() % 7), z};
      if (k % 2 == 0) p = {p.x, p.z, p.y};
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(p);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  const Scene scene = make_scene(soup);
  EXPECT_GT(scene.report().self_crossing, 20u);
  EXPECT_GT(compare_signs(scene, 300, 60), 100u);
}

}  // namespace
}  // namespace sightline
