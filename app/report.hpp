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

/// Of ID bitfields.
struct BitfieldFigures {
  std::size_t samples = 0;
  bool exact = false;
  unsigned pixels = 0;
  std::size_t bits = 0;  // of each field
  std::size_t transparent = 0, faces = 0;
  std::size_t plain_bytes = 0, hierarchical_bytes = 0, compressed_bytes = 0, file_bytes = 0, list_bytes = 0;
  double mean_list = 0;  // polygons, over the faces of the hull; 0 where no lists were made
  double seconds = 0;    // build: for the samples; query: for what is made beforehand
};

/// Of one camera that was looked up in bitfields.
struct BitfieldViewFigures {
  double seconds = 0;
  std::uint32_t face = 0;  // of the hull; none: the camera is that of an exact sample
  std::vector<std::uint32_t> samples;
  std::size_t polygons = 0;
};

/// Of a visibility field.
struct FieldFigures {
  std::size_t slabs = 0, samples = 0, ids = 0, cells = 0, lists = 0, mipmaps = 0;
  std::uint64_t array_bytes = 0, memory_bytes = 0, file_bytes = 0;
  std::uint64_t rays = 0;  // 0 and 0 where it was read
  double seconds = 0;
};

/// Of one camera that was looked up in a field.
struct FieldViewFigures {
  double seconds = 0;
  std::size_t cells = 0, polygons = 0, looked_up = 0;
  double covered = 0;  // part of the pixels that lie in some slab
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
  std::optional<BitfieldFigures> bitfield = {};
  std::vector<BitfieldViewFigures> bitfield_views = {};
  std::optional<FieldFigures> field = {};
  std::vector<FieldViewFigures> field_views = {};
};

/// The report as JSON, with the decision tallies and the peak of memory of this process.
std::string report_json(const Report& report, const CommonOptions& options);
/// Writes it where the options ask for it.
void publish(const Report& report, const CommonOptions& options);

}  // namespace sightline::app
