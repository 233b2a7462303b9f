// Pieces without T-junctions, and pieces looked up by samples.
#include <gtest/gtest.h>

#include "tests/clip/shots.hpp"

namespace sightline::testing {
namespace {

TFreePieces as_they_are(const ClipResult& result) {
  TFreePieces plain;
  for (const ClipPiece& piece : result.pieces) {
    for (std::uint32_t k = 0; k < piece.corner_count; ++k) plain.corners.push_back(piece.first_corner + k);
    plain.first.push_back(static_cast<std::uint32_t>(plain.corners.size()));
  }
  return plain;
}

TEST(TFree, NoCornerInsideASide) {
  std::size_t added = 0, faulty = 0;
  for (std::uint64_t seed = 3000; seed < 3030; ++seed) {
    const Shot shot = degenerate(seed);
    const ClipOptions options;
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    const TFreePieces joined = t_free(shot.scene, shot.cameras, options, result);
    const ExactPieces exact(shot.scene, shot.cameras, options, result);
    EXPECT_EQ(exact.t_faults(joined), "") << "seed " << seed;
    faulty += exact.t_faults(as_they_are(result)).find("a corner inside a side") != std::string::npos;
    added += joined.corners.size() - result.corners.size();
  }
  EXPECT_GT(added, 0u);
  EXPECT_GT(faulty, 0u);
}

TEST(TFree, OnModelsWithRegions) {
  for (const Shot& shot : {model("rooms", 40), model("rooms", 60, 0, 17), model("random", 8, 60)}) {
    ClipOptions options;
    options.regions = {{{true, {{0.1, 0.1}, {0.9, 0.2}, {0.5, 0.95}}}, {false, {{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}}}}};
    const ClipResult result = clip(shot.scene, shot.cameras, options);
    const TFreePieces joined = t_free(shot.scene, shot.cameras, options, result);
    const ExactPieces exact(shot.scene, shot.cameras, options, result);
    EXPECT_EQ(exact.t_faults(joined), "") << shot.scene.soup().source;
    EXPECT_GT(joined.corners.size(), result.corners.size());
  }
}

// A long side against many short ones, far away from zero, where neighbouring doubles are a part of a side apart.
TEST(TFree, FarFromZero) {
  PolygonSoup soup;
  const double far = 0x1p40;
  const auto quad = [&](double x0, double x1, double y0, double y1) {
    for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.emplace_back(far + x, far + 3 * x + y, far - x + 2 * y);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  quad(0, 1, 0, 1);
  for (int k = 0; k < 16; ++k) quad(k / 16.0, (k + 1) / 16.0, 1, 2);
  const Scene scene = make_scene(soup);
  const ClipOptions options;
  const std::vector<Camera> cameras;
  const ClipResult result = clip(scene, cameras, options);
  const TFreePieces joined = t_free(scene, cameras, options, result);
  EXPECT_EQ(joined.first[1], 4u + 15u);
  EXPECT_EQ(ExactPieces(scene, cameras, options, result).t_faults(joined), "");
}

TEST(Sampling, ChangesNoByte) {
  std::uint64_t proofs = 0;
  for (const Shot& shot : {model("city", 50), model("tower", 12), model("maze", 60, 0, 17), model("random", 8, 120)}) {
    ClipOptions options;
    const ClipResult usual = clip(shot.scene, shot.cameras, options);
    options.sampling = true;
    for (const int buffer : {16, 300}) {
      options.buffer = buffer;
      const ClipResult other = clip(shot.scene, shot.cameras, options);
      EXPECT_TRUE(same(usual, other)) << shot.scene.soup().source << " " << buffer;
      proofs += other.stats.buffer_proofs;
    }
  }
  EXPECT_GT(proofs, 100u);
  for (std::uint64_t seed = 1000; seed < 1050; ++seed) {
    Shot shot = degenerate(seed);
    shot.cameras[0].right = -shot.cameras[0].right;  // mirrored
    ClipOptions options;
    const ClipResult usual = clip(shot.scene, shot.cameras, options);
    options.sampling = true;
    EXPECT_TRUE(same(usual, clip(shot.scene, shot.cameras, options))) << "seed " << seed;
  }
}

}  // namespace
}  // namespace sightline::testing
