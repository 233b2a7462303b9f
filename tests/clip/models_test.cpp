// The laws of clip() on the models: beside the tracer, in rationals, and against itself.
#include <gtest/gtest.h>

#include "tests/clip/shots.hpp"

namespace sightline::testing {
namespace {

TEST(ClipModels, InRationalsAndBesideTheTracer) {
  for (const Shot& shot : {model("rooms", 50), model("maze", 40), model("city", 50), model("building", 50, 600),
                           model("tower", 12), model("campus", 5), model("random", 8, 120), model("maze", 60, 0, 17)}) {
    const ClipOptions options;
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    ExactPieces exact(shot.scene, shot.cameras, options, result);
    EXPECT_EQ(exact.faults(), "") << shot.scene.soup().source;
    EXPECT_EQ(exact.wrong_rays(1, 1, 20), "") << shot.scene.soup().source;
    EXPECT_EQ(unlike_tracer(shot, exact, result), "") << shot.scene.soup().source;
  }
}

TEST(ClipModels, NeitherBufferNorThreadsChangeAByte) {
  for (const Shot& shot : {model("city", 50), model("tower", 12), model("maze", 60, 0, 17)}) {
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
  for (std::uint64_t seed = 1000; seed < 1050; ++seed) {
    const Shot shot = degenerate(seed);
    ClipOptions options;
    options.buffer = 1;
    const ClipResult coarse = clip(shot.scene, shot.cameras, options);
    options.buffer = 64;
    EXPECT_TRUE(same(coarse, clip(shot.scene, shot.cameras, options))) << "seed " << seed;
  }
}

TEST(ClipModels, WhatIsSeenDoesNotDependOnTheOrderOfTheCameras) {
  Shot shot = model("random", 5, 80);
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
TEST(ClipModels, Threshold) {
  const Shot shot = model("tower", 12);
  ClipOptions options;
  const std::size_t all = clip(shot.scene, shot.cameras, options).pieces.size();
  std::size_t before = all;
  for (const double threshold : {0.1, 1.0}) {
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

}  // namespace
}  // namespace sightline::testing
