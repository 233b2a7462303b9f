// Which polygons are seen from viewpoints: the samples of a scene, by ID buffers or exactly. (Meruvia and Strothotte,
// section 3.1.)
#pragma once

#include "sample/bitfield.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace sightline {

struct BitfieldSampling {
  /// By the exact map: nothing that is seen is missed, however small. Else by an ID buffer.
  bool exact = false;
  /// A side of the ID buffer. The usual number makes as many pixels as the paper's 1320 x 1074.
  unsigned pixels = 1191;
  /// Of filling in by connectivity (bitfield_connect.hpp); 0: none.
  unsigned fill_rounds = 0;
  /// Ascending. They hide nothing, and their bits are always set.
  std::vector<PolygonId> transparent;
  /// 0: a bit a polygon. Else a bit a patch of at most that many polygons (bitfield_patches.hpp).
  std::uint32_t patch = 0;
  unsigned threads = 1;
  /// Called after every sample, from any thread.
  std::function<void()> step = [] {};
  /// Where given, set to the memory that sampling alone needs: the exact tree, or one buffer.
  std::size_t* building_bytes = nullptr;
};

/// What is kept of a scene, in memory or in a file: a bitfield for each camera, the same for any number of threads.
struct BitfieldSamples {
  std::string source;              // the scene's file, without its folder
  std::uint32_t polygons = 0;      // of the scene
  std::uint64_t scene_number = 0;  // scene_number(), to tell a file that belongs to another scene
  glm::dvec3 centre{0};            // directions of viewpoints are counted from here
  bool exact = false;
  unsigned pixels = 0;  // 0 where exact
  unsigned fill_rounds = 0;
  std::uint32_t patch = 0;  // 0: a bit a polygon
  std::vector<Camera> cameras;
  std::vector<IdBitfield> fields;  // of one size
  bool operator==(const BitfieldSamples& other) const;
};

/// Laws. 1: an exact sample has just the polygons of its camera's map, the lowest of those in one place, where nothing
/// is transparent, filled in or patched. 2: fill_rounds, transparent polygons and patches each give supersets of what
/// the same scene without those polygons gives. 3: threads change nothing.
BitfieldSamples sample_bitfields(const Scene& scene, std::span<const Camera> cameras, const BitfieldSampling& options);

/// Whether these samples are of this scene, and of the same options.
bool samples_of(const BitfieldSamples& samples, const Scene& scene);

/// Equal in all four vectors.
bool same_camera(const Camera& a, const Camera& b);

/// A hash (64-bit FNV-1a) of everything that decides what is seen: coordinates, polygons, options.
std::uint64_t scene_number(const Scene& scene);

}  // namespace sightline
