// Scenes with cameras for the tests of clip(), and what its results are compared with.
#pragma once

#include <algorithm>

#include "beam/trace.hpp"
#include "clip/clip.hpp"
#include "models/model.hpp"
#include "tests/clip/exact_pieces.hpp"
#include "tests/oracle/scenes.hpp"
#include "visibility_map/write.hpp"

namespace sightline::testing {

struct Shot {
  Scene scene;
  std::vector<Camera> cameras;
};

/// A degenerate scene with several cameras, each placed where a case of its own would have it.
inline Shot degenerate(std::uint64_t seed) {
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

inline Shot model(const std::string& name, std::size_t every, std::uint32_t polygons = 0, double degrees = 0) {
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
inline std::string unlike_tracer(const Shot& shot, const ExactPieces& pieces, const ClipResult& result) {
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

inline bool same(const ClipResult& a, const ClipResult& b) {
  const auto piece = [](const ClipPiece& p, const ClipPiece& q) {
    return p.polygon == q.polygon && p.surface == q.surface && p.first_corner == q.first_corner &&
           p.corner_count == q.corner_count && p.first_camera == q.first_camera && p.camera_count == q.camera_count &&
           p.partly_count == q.partly_count;
  };
  const auto corner = [](const ClipCorner& p, const ClipCorner& q) { return p.at == q.at && p.side == q.side; };
  return std::ranges::equal(a.pieces, b.pieces, piece) && std::ranges::equal(a.corners, b.corners, corner) &&
         a.cameras == b.cameras;
}

}  // namespace sightline::testing
