// The laws of clip(), in rationals and by brute force.
#include "clip/clip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "beam/trace.hpp"
#include "models/model.hpp"
#include "tests/clip/exact_pieces.hpp"
#include "tests/oracle/scenes.hpp"
#include "visibility_map/write.hpp"

namespace sightline::testing {
namespace {

std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* wanted = std::getenv(name);
  return wanted == nullptr ? usual : std::strtoull(wanted, nullptr, 10);
}

struct Shot {
  Scene scene;
  std::vector<Camera> cameras;
};

/// A degenerate scene with several cameras, each placed where a case of its own would have it.
Shot degenerate(std::uint64_t seed) {
  SceneMaker maker(seed);
  Shot shot;
  Case last;
  for (int k = 0; k < 3; ++k) {
    last = maker.make(3 + static_cast<int>(seed % 4));
    shot.cameras.push_back(last.camera);
  }
  shot.scene = make_scene(last.soup, last.options);
  return shot;
}

Shot model(const std::string& name, std::size_t every, std::uint32_t polygons = 0, double degrees = 0) {
  ModelOptions options;
  options.polygons = polygons;
  options.rotate_degrees = degrees;
  const Model made = make_model(name, options);
  Shot shot{make_scene(made.soup), {}};
  for (std::size_t k = 0; k < made.cameras.size(); k += every) {
    const CameraLine& c = made.cameras[k];
    shot.cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  return shot;
}

/// What each camera sees of each polygon, beside the tracer's list. Fractions within 1e-12; the tracer finds its areas
/// from corners rounded to doubles, so that a polygon of which hardly anything is seen is given those roundings too.
std::string unlike_tracer(const Shot& shot, const ExactPieces& pieces, const ClipResult& result) {
  std::string text;
  const BspTree tree(shot.scene);
  Tracer tracer(tree);
  for (std::uint32_t c = 0; c < shot.cameras.size(); ++c) {
    VisibilityMap map;
    tracer.trace(shot.cameras[c], map);
    std::vector<char> some(shot.scene.polygon_count(), 0), all(shot.scene.polygon_count(), 1);
    for (const ClipPiece& piece : result.pieces) {
      some[piece.polygon] = some[piece.polygon] || pieces.lists(piece, c);
      all[piece.polygon] = all[piece.polygon] && pieces.lists(piece, c);
    }
    const auto differs = [&](PolygonId p, const std::string& what) {
      text += "camera " + std::to_string(c) + " polygon " + std::to_string(p) + ": " + what + "\n";
    };
    for (const PolygonVisibility& v : visible_polygons(map, shot.scene)) {
      constexpr double rounding = 1e-15;
      const double area = pieces.area(v.polygon, c), whole = v.fraction > 0 ? v.area / v.fraction : 0;
      if (!(std::abs(area - v.area) <= 1e-12 * whole + rounding))
        differs(v.polygon, "area " + std::to_string(area) + " for " + std::to_string(v.area));
      if (!some[v.polygon]) differs(v.polygon, "no piece of it is seen");
      if (all[v.polygon] && !v.full) differs(v.polygon, "all of it is seen");
      some[v.polygon] = 0;
    }
    for (PolygonId p = 0; p < some.size(); ++p)
      if (some[p]) differs(p, "it is not seen");
  }
  return text;
}

bool same(const ClipResult& a, const ClipResult& b) {
  const auto piece = [](const ClipPiece& p, const ClipPiece& q) {
    return p.polygon == q.polygon && p.surface == q.surface && p.first_corner == q.first_corner &&
           p.corner_count == q.corner_count && p.first_camera == q.first_camera && p.camera_count == q.camera_count &&
           p.partly_count == q.partly_count;
  };
  const auto corner = [](const ClipCorner& p, const ClipCorner& q) { return p.at == q.at && p.side == q.side; };
  return std::ranges::equal(a.pieces, b.pieces, piece) && std::ranges::equal(a.corners, b.corners, corner) &&
         a.cameras == b.cameras;
}

TEST(Clip, DegenerateScenes) {
  const std::uint64_t first = setting("SIGHTLINE_FIRST", 0), count = setting("SIGHTLINE_CASES", 80);
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

TEST(Clip, Models) {
  for (const Shot& shot : {model("rooms", 25), model("maze", 20), model("city", 25), model("building", 25, 600),
                           model("tower", 8), model("campus", 3), model("random", 6, 200), model("maze", 50, 0, 17)}) {
    const ClipOptions options;
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    ExactPieces exact(shot.scene, shot.cameras, options, result);
    EXPECT_EQ(exact.faults(), "") << shot.scene.soup().source;
    EXPECT_EQ(exact.wrong_rays(1, 1, 20), "") << shot.scene.soup().source;
    EXPECT_EQ(unlike_tracer(shot, exact, result), "") << shot.scene.soup().source;
  }
}

TEST(Clip, NeitherBufferNorThreadsChangeAByte) {
  for (const Shot& shot : {model("city", 20), model("tower", 12), model("maze", 30, 0, 17)}) {
    ClipOptions options;
    const ClipResult usual = clip(shot.scene, shot.cameras, options);
    options.threads = 3;
    std::vector<std::uint64_t> proofs;
    for (const int buffer : {32, 256, 2048}) {
      options.buffer = buffer;
      const ClipResult other = clip(shot.scene, shot.cameras, options);
      EXPECT_TRUE(same(usual, other)) << shot.scene.soup().source << " " << buffer;
      proofs.push_back(other.stats.buffer_proofs);
    }
    EXPECT_LT(proofs[0], proofs[2]);  // they do prove different things
  }
  for (std::uint64_t seed = 1000; seed < 1100; ++seed) {
    const Shot shot = degenerate(seed);
    ClipOptions options;
    options.buffer = 1;
    const ClipResult coarse = clip(shot.scene, shot.cameras, options);
    options.buffer = 64;
    EXPECT_TRUE(same(coarse, clip(shot.scene, shot.cameras, options))) << "seed " << seed;
  }
}

TEST(Clip, WhatIsSeenDoesNotDependOnTheOrderOfTheCameras) {
  Shot shot = model("random", 4, 120);
  const ClipOptions options;
  const ClipResult result = clip(shot.scene, shot.cameras, options);
  Shot turned = shot;
  std::ranges::reverse(turned.cameras);
  const ClipResult other = clip(turned.scene, turned.cameras, options);
  const ExactPieces one(shot.scene, shot.cameras, options, result), two(turned.scene, turned.cameras, options, other);
  const auto count = static_cast<std::uint32_t>(shot.cameras.size());
  for (PolygonId p = 0; p < shot.scene.polygon_count(); ++p)
    for (std::uint32_t c = 0; c < count; ++c) EXPECT_NEAR(one.area(p, c), two.area(p, count - 1 - c), 1e-15);
}

TEST(Clip, Regions) {
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

TEST(Clip, RefusesRegionsThatAreNotConvex) {
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

double surface_area(const ClipResult& result, const ClipPiece& piece) {
  glm::dvec3 sum{0};
  const auto at = [&](std::uint32_t k) {
    const auto& x = result.corners[piece.first_corner + k].at;
    return glm::dvec3(x[0], x[1], x[2]);
  };
  for (std::uint32_t k = 2; k < piece.corner_count; ++k) sum += glm::cross(at(k - 1) - at(0), at(k) - at(0));
  return glm::length(sum) / 2;
}

// What is partly seen below the threshold is neither cut nor called visible; all else is as exact as ever.
TEST(Clip, Threshold) {
  const Shot shot = model("tower", 8);
  ClipOptions options;
  const std::size_t all = clip(shot.scene, shot.cameras, options).pieces.size();
  std::size_t before = all;
  for (const double threshold : {0.01, 0.1, 1.0}) {
    options.threshold = threshold;
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    EXPECT_LT(result.pieces.size(), before);
    before = result.pieces.size();
    std::size_t partly = 0;
    for (const ClipPiece& piece : result.pieces) {
      partly += piece.partly_count > 0;
      if (piece.partly_count > 0) {
        EXPECT_LT(surface_area(result, piece), threshold * 1.000001);
      }
    }
    EXPECT_GT(partly, 0u);
    ExactPieces exact(shot.scene, shot.cameras, options, result);
    EXPECT_EQ(exact.faults(), "");
    const std::string wrong = exact.wrong_rays(3, 1, 100);
    EXPECT_EQ(wrong.find("is listed and does not see it"), std::string::npos);
  }
}

// A polygon behind many, none of which hides it alone; with a hole of less than a pixel, and without.
TEST(Clip, ThroughAHoleOfLessThanAPixel) {
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
TEST(Clip, CoplanarPolygons) {
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

}  // namespace
}  // namespace sightline::testing
