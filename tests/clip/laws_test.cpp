// The laws of clip() on small scenes in which nothing is in general position, in rationals and by brute force.
// SIGHTLINE_CASES=n makes n cases instead of the usual few, SIGHTLINE_FIRST=k begins with seed k.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/clip/shots.hpp"

namespace sightline::testing {
namespace {

std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* wanted = std::getenv(name);
  return wanted == nullptr ? usual : std::strtoull(wanted, nullptr, 10);
}

TEST(ClipLaws, DegenerateScenes) {
  const std::uint64_t first = setting("SIGHTLINE_FIRST", 0), count = setting("SIGHTLINE_CASES", 50);
  std::size_t pieces = 0, surfaces = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Shot shot = degenerate(seed);
    const ClipOptions options;
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    ExactPieces exact(shot.scene, shot.cameras, options, result);
    EXPECT_EQ(exact.faults(), "") << "seed " << seed;
    EXPECT_EQ(exact.wrong_rays(seed, 2), "") << "seed " << seed;
    EXPECT_EQ(unlike_tracer(shot, exact, result), "") << "seed " << seed;
    pieces += result.pieces.size();
    surfaces += shot.scene.surfaces().size();
  }
  EXPECT_GT(pieces, surfaces);  // something was cut
}

// The pieces differ, what is seen of each polygon does not: to the last bit of its area.
TEST(ClipLaws, TheOrderOfTheCamerasChangesNothingThatIsSeen) {
  for (std::uint64_t seed = 4000; seed < 4020; ++seed) {
    const Shot shot = degenerate(seed);
    const ClipOptions options;
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    const ExactPieces exact(shot.scene, shot.cameras, options, result);
    std::vector<std::uint32_t> order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end())) {
      std::vector<Camera> cameras;
      for (const std::uint32_t k : order) cameras.push_back(shot.cameras[k]);
      const ClipResult other = clip(shot.scene, cameras, options);
      const ExactPieces turned(shot.scene, cameras, options, other);
      for (PolygonId p = 0; p < shot.scene.polygon_count(); ++p)
        for (std::uint32_t c = 0; c < 3; ++c)
          EXPECT_EQ(exact.exact_area(p, order[c]), turned.exact_area(p, c)) << "seed " << seed;
    }
  }
}

// Polygons a thousandth of a pixel wide, and slivers, before a wall: each is seen, and hides what it hides.
TEST(ClipLaws, PolygonsOfLessThanAPixel) {
  Random random(21);
  PolygonSoup soup;
  const auto add = [&](const std::vector<glm::dvec3>& corners) {
    for (const glm::dvec3& v : corners) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(v);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  add({{-8, 8, -8}, {8, 8, -8}, {8, 8, 8}, {-8, 8, 8}});
  for (int k = 0; k < 30; ++k) {
    const glm::dvec3 at{random.between(-64, 64) / 32.0, 4 + random.between(0, 8) / 8.0, random.between(-64, 64) / 32.0};
    const double wide = 0x1p-20, long_side = random.once_in(3) ? 1 : wide;
    add({at, at + glm::dvec3{wide, 0, random.between(0, 1) * wide}, at + glm::dvec3{0, 0, long_side}});
  }
  const Scene scene = make_scene(soup);
  const std::vector<Camera> cameras{make_camera({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 60, 1),
                                    make_camera({0.5, 0.25, 0}, {0, 1, 0}, {0, 0, 1}, 60, 1)};
  ClipOptions options;
  for (const bool sampling : {false, true}) {
    options.sampling = sampling;
    const ClipResult result = clip(scene, cameras, options);
    ExactPieces exact(scene, cameras, options, result);
    EXPECT_EQ(exact.faults() + exact.wrong_rays(22, 2), "");
    for (PolygonId p = 0; p <= 30; ++p) EXPECT_GT(exact.area(p, 0) + exact.area(p, 1), 0) << p;
  }
}

TEST(ClipLaws, Regions) {
  for (std::uint64_t seed = 2000; seed < 2040; ++seed) {
    const Shot shot = degenerate(seed);
    Random random(seed);
    ClipOptions options;
    for (std::size_t c = 0; c < shot.cameras.size(); ++c) {
      options.regions.emplace_back();
      while (options.regions.back().size() < c) {
        TextureRegion region{random.once_in(2), {}};
        for (int k = 0; k < 3; ++k)
          region.points.emplace_back(random.between(-1, 9) / 8.0, random.between(-1, 9) / 8.0);
        const glm::dvec2 a = region.points[1] - region.points[0], b = region.points[2] - region.points[0];
        if (a.x * b.y != a.y * b.x) options.regions.back().push_back(region);
      }
    }
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    ExactPieces exact(shot.scene, shot.cameras, options, result);
    EXPECT_EQ(exact.faults(), "") << "seed " << seed;
    EXPECT_EQ(exact.wrong_rays(seed, 2), "") << "seed " << seed;
  }
}

TEST(ClipLaws, RefusesRegionsThatAreNotConvex) {
  const Shot shot = model("rooms", 60);
  for (const std::vector<glm::dvec2>& points : {std::vector<glm::dvec2>{{0, 0}, {1, 0}},
                                                {{0, 0}, {0.5, 0.5}, {1, 1}},
                                                {{0, 0}, {1, 0}, {0.25, 0.25}, {0, 1}},
                                                {{0, 0}, {1, 0}, {0, 1}, {1, 1}},
                                                {{0, 0}, {1, 0}, {NAN, 1}}}) {
    ClipOptions options;
    options.regions = {{{true, points}}};
    EXPECT_THROW(clip(shot.scene, shot.cameras, options), std::invalid_argument);
  }
}

// A polygon behind many, none of which hides it alone; with a hole of less than a pixel, and without.
TEST(ClipLaws, ThroughAHoleOfLessThanAPixel) {
  for (const double hole : {0.0, 0x1p-40}) {
    PolygonSoup soup;
    const auto quad = [&](double x0, double x1, double z0, double z1, double y) {
      const auto first = static_cast<std::uint32_t>(soup.vertices.size());
      for (const auto& [x, z] : {std::pair{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}) soup.vertices.emplace_back(x, y, z);
      for (std::uint32_t k = 0; k < 4; ++k) soup.corners.push_back(first + k);
      soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    };
    quad(-1, 1, -1, 1, 4);
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < 8; ++k) {
        const double x = i / 4.0 - 1, z = k / 4.0 - 1;
        quad(x, x + 0.25, z + (i == 3 && k == 3 ? hole : 0), z + 0.25, 2);
      }
    const Scene scene = make_scene(soup);
    const std::vector<Camera> cameras{Camera{}};
    for (const int buffer : {16, 512}) {
      ClipOptions options;
      options.buffer = buffer;
      const ClipResult result = clip(scene, cameras, options);
      ExactPieces exact(scene, cameras, options, result);
      EXPECT_EQ(exact.faults() + exact.wrong_rays(5, 3), "");
      EXPECT_EQ(exact.area(0, 0) > 0, hole > 0);
      EXPECT_EQ(result.pieces[1].polygon == 0, hole > 0);
    }
  }
}

// What the lowest index owns where polygons lie in one plane, from both sides.
TEST(ClipLaws, CoplanarPolygons) {
  PolygonSoup soup;
  soup.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {5, 1, 0}, {1, 5, 0}};
  soup.corners = {3, 4, 5, 0, 1, 2, 0, 2, 1};
  soup.first = {0, 3, 6, 9};
  const Scene scene = make_scene(soup);
  const std::vector<Camera> cameras{make_camera({1, 2, 9}, {0, 0, -1}, {0, 1, 0}, 60, 1),
                                    make_camera({1, 2, -9}, {0, 0, 1}, {0, 1, 0}, 60, 1),
                                    make_camera({9, 2, 0}, {-1, 0, 0}, {0, 0, 1}, 60, 1)};  // in their plane
  const ClipOptions options;
  const ClipResult result = clip(scene, cameras, options);
  ExactPieces exact(scene, cameras, options, result);
  EXPECT_EQ(exact.faults() + exact.wrong_rays(7, 4), "");
  EXPECT_EQ(result.cameras.size(), 2 * (result.pieces.size() - 2));  // polygon 2, and what polygon 0 covers of 1
  EXPECT_GT(exact.area(1, 0), 0);
  EXPECT_EQ(exact.area(2, 0), 0);
}

// An eye whose place in the scene's own unit is beyond the largest double: filters that are not numbers decide nothing.
TEST(ClipLaws, EyesBeyondTheDoubles) {
  PolygonSoup soup = make_model("rooms").soup;
  for (glm::dvec3& v : soup.vertices) v *= 0x1p-500;
  const Scene scene = make_scene(soup);
  std::vector<Camera> cameras;
  for (const double far : {0x1p-400, 1.0, 0x1p600})
    cameras.push_back(make_camera(glm::dvec3{1, 0.75, 0.5} * far, {-1, -0.75, -0.5}, {0, 0, 1}, 80, 1.25));
  const ClipOptions options;
  const ClipResult result = clip(scene, cameras, options);
  ExactPieces exact(scene, cameras, options, result);
  EXPECT_EQ(exact.faults() + exact.wrong_rays(11, 1), "");
}

}  // namespace
}  // namespace sightline::testing
