// The report of a run (`--report`, `--json`).
#pragma once

#include "app/options.hpp"
#include "bsp/tree.hpp"
#include "photos/photos.hpp"
#include "scene/scene.hpp"
#include "winged_pair/complex.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sightline::app {

/// Of the complex, or of the tree for an engine that needs no cells.
struct ComplexFigures {
  double seconds = 0;  // from a scene in memory to the complex or tree; 0 when it was read from a file
  bool from_file = false;
  bool lazy = false;                  // divided only where a camera looked
  std::size_t nodes = 0, pieces = 0;  // of the tree
  std::size_t cells = 0, faces = 0, edges = 0, vertices = 0, pairs = 0, bytes = 0;
};
ComplexFigures figures_of(const Complex& complex);
ComplexFigures figures_of(const BspTree& tree);

struct CameraFigures {
  double seconds = 0;  // from a camera to its finished map in memory
  std::uint32_t beams = 0, cells = 0, faces = 0, edges = 0, vertices = 0;
  double left_out = 0;  // with --min-angle: a bound on the part of the window that was not followed
  std::string error;    // why it failed; empty when it did not
};

/// Of the pieces of `clip`.
struct ClipFigures {
  std::size_t pieces = 0, seen = 0, cuts = 0, buffer_proofs = 0;
  double buffer_seconds = 0, clip_seconds = 0;
};

/// Of the textures that `clip --photos` made.
struct PhotoFigures {
  PhotoStats stats;
  int guard = 0;
  std::size_t pages = 0;
};

struct Report {
  std::string command;
  std::optional<Scene> scene;
  std::optional<ComplexFigures> complex;
  std::vector<CameraFigures> cameras;
  double seconds = 0;  // the whole run, reading and writing included
  int exit_code = 0;
  std::optional<ClipFigures> clip = {};
  std::optional<PhotoFigures> photos = {};
};

/// The report as JSON, with the decision tallies and the peak of memory of this process.
std::string report_json(const Report& report, const CommonOptions& options);
/// Writes it where the options ask for it.
void publish(const Report& report, const CommonOptions& options);

}  // namespace sightline::app
