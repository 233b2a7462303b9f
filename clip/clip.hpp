// Yu's hybrid: polygons cut so that every piece is wholly visible or wholly hidden from each camera.
#pragma once

#include "scene/camera.hpp"
#include "scene/scene.hpp"

#include <glm/vec2.hpp>

namespace sightline {

/// What part of a photograph serves as texture: the inside of a convex polygon of the window, or its outside.
struct TextureRegion {
  bool interior = true;
  std::vector<glm::dvec2> points;  // (s, t), strictly convex, in either direction
};

struct ClipOptions {
  /// A partly visible piece below this area (scene units, squared) is not cut. 0: all are.
  double threshold = 0;
  /// Pixels along a side of each camera's buffer; 0: chosen. No result depends on it, only the time does.
  int buffer = 0;
  /// Looks polygons up in the buffers by samples of them, uniform in object space, instead of by scan conversion. No
  /// result depends on it either.
  bool sampling = false;
  /// Of each camera; a place counts as seen where it lies in all of them. Cameras beyond the end have none.
  std::vector<std::vector<TextureRegion>> regions;
  unsigned threads = 1;
};

/// The line that a side of a piece lies on, in the plane of its surface.
struct ClipSide {
  enum Kind : std::uint8_t {
    edge,          // of the scene's points a and b, which lie in the plane
    wedge,         // of the plane through the camera's eye and the scene's points a and b
    window,        // of the camera's window: a is the Window::Side
    region,        // of side b, from point b to the next, of the camera's region a
    intersection,  // of the plane of surface a
  } kind = edge;
  std::uint32_t camera = none;
  std::uint32_t a = none, b = none;
  bool operator==(const ClipSide&) const = default;
};

/// A corner is exactly where the sides before and after it meet; `at` has each world coordinate to the nearest double.
struct ClipCorner {
  std::array<double, 3> at;
  ClipSide side;  // from here to the next corner
};

/// corners[first_corner ..] run counter-clockwise seen from the front of the surface's plane.
struct ClipPiece {
  PolygonId polygon;
  SurfaceId surface;
  std::uint32_t first_corner, corner_count;
  std::uint32_t first_camera, camera_count;  // in ClipResult::cameras, ascending: those that see all of it
  std::uint32_t partly_count;                // those that follow there: see some of it, by the threshold
};

struct ClipStats {
  double buffer_seconds = 0, clip_seconds = 0;
  std::uint64_t buffer_proofs = 0;  // pieces that the buffer proved hidden
  std::uint64_t shadows = 0;        // pairs of surfaces looked at for a camera in object space
  std::uint64_t cuts = 0;           // of pieces by lines
};

struct ClipResult {
  std::vector<ClipPiece> pieces;  // ascending by surface
  std::vector<ClipCorner> corners;
  std::vector<std::uint32_t> cameras;
  ClipStats stats;
};

/// Laws. 1: the pieces of a surface tile it. 2: of no piece is a part visible and a part hidden from any camera, but
/// for those below the threshold. 3: a surface that no camera sees is one piece, whole. 4: the same result for every
/// size of the buffer and every number of threads. 5: what is visible from where does not depend on the order of the
/// cameras. Visible from a camera: nearest along a ray of its window (and regions) from the eye, the lowest index
/// owning what lies in one plane; a surface whose plane holds the eye is hidden. Throws std::invalid_argument for a
/// camera whose vectors are not finite or not independent, and for a region that is not strictly convex.
ClipResult clip(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options = {});

}  // namespace sightline
