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

/// What each camera sees of each polygon, beside the tracer's list. Fractions within 1e-12; the tracer finds its areas from
/// corners rounded to doubles, so that a polygon of which hardly anything is seen is given those roundings too.
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

TEST(Clip, ThreadsChangeNothing) {
  const Shot shot = model("city", 20);
  ClipOptions options;
  const ClipResult one = clip(shot.scene, shot.cameras, options);
  options.threads = 3;
  EXPECT_TRUE(same(one, clip(shot.scene, shot.cameras, options)));
}

}  // namespace
}  // namespace sightline::testing
