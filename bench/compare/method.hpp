// What all methods under comparison have in common: prepared once for a scene, then asked for view after view.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/cpu_seconds.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sightline::peers {

/// What preparing a scene cost; zeros where a method keeps nothing between views.
struct Cost {
  double seconds = 0;
  std::size_t bytes = 0;
};

enum class Status : int { done, cut_off, failed, not_begun };

/// One view by one method.
struct Outcome {
  Status status = Status::done;
  double seconds = 0;  // processor time from the camera to the result in memory; for rays: of one ray
  std::uint32_t faces = 0, edges = 0, vertices = 0;  // of the result, where it has such
  bool gives_visible = false;
  std::vector<PolygonId> visible;                           // ascending
  std::vector<std::pair<PolygonId, PolygonId>> coincident;  // exact maps only: seen polygon, one in the same place
  std::string note;                                         // why it failed
};

inline Outcome failure(std::string why) {
  Outcome out;
  out.status = Status::failed;
  out.note = std::move(why);
  return out;
}

/// What a caller wants of a view besides its time.
enum class Want { time, visible };

class Method {
 public:
  enum class Kind {
    map,   // an exact map of ours: the reference
    peer,  // another program's answer
    ray    // the time of one ray: the unit of the measure
  };

  Method(std::string name, Kind kind) : name_(std::move(name)), kind_(kind) {}
  virtual ~Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  const std::string& name() const { return name_; }
  Kind kind() const { return kind_; }
  /// Must a view be computed in a process of its own, since it may take for ever or crash?
  virtual bool in_child() const { return false; }
  /// The scene outlives the method's use of it.
  virtual Cost prepare(const Scene& scene) = 0;
  virtual Outcome map(const Camera& camera, Want want) = 0;
  /// Frees what `prepare` made.
  virtual void release() = 0;

 private:
  std::string name_;
  Kind kind_;
};

using Methods = std::vector<std::unique_ptr<Method>>;

/// A way to some methods, or the reason why there is none in this build.
struct Source {
  std::string name;
  std::string package;            // Debian's, for the line that says what is missing
  std::function<Methods()> make;  // empty: left out of this build
};
/// Ours first, each engine of the build; then the peers.
std::vector<Source> sources();

// One function a file; a peer's exists only where its library was found.
Methods make_ours();
Methods make_embree();
Methods make_cgal();
Methods make_occt();
Methods make_gl2ps();

}  // namespace sightline::peers
