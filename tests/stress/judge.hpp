// Maps judged by everything that can judge them, and counted.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tests/oracle/scenes.hpp"
#include "visibility_map/map.hpp"

namespace sightline::stress {

using testing::Case;
using testing::Random;

/// `usual`, times what SIGHTLINE_STRESS in the environment says (1 to 1,000,000).
std::uint64_t times(std::uint64_t usual);

/// Who judges.
struct Judges {
  bool complex = true;    // the winged-pair complex is checked, and the engine on it gives the same bytes
  bool hybrid = true;     // so does the engine that clips
  bool oracle = true;     // brute force over an arrangement: for scenes of a few polygons
  unsigned verifier = 1;  // every so many maps: all but the slowest
};

/// A scene before its judges. What is found wrong fails the running test and is written to the working folder as
/// stress-PROGRAM-NUMBER.obj, with the camera in its comments: a file for tests/corpus.
class Court {
 public:
  explicit Court(const PolygonSoup& soup, const SceneOptions& options = {}, const Judges& judges = {});
  ~Court();

  /// The map of this camera, once judged; empty where it could not be made. `what` names the case in messages.
  const VisibilityMap& check(const Camera& camera, const std::string& what);
  /// Blames the last camera: for laws that the caller knows.
  void fault(const std::string& what);
  const Scene& scene() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same for a scene with one camera.
void check(const Case& sample, const std::string& what, const Judges& judges = {});

/// A camera with any vectors: looks at `target`, its window `width` times as wide as it is far, half as high. Not
/// rounded beyond what doubles do; of another direction where eye and target are one.
Camera aimed(const glm::dvec3& eye, const glm::dvec3& target, double width);

}  // namespace sightline::stress
