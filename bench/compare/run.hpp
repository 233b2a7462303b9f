// Scenes times methods times cameras.
#pragma once

#include "bench/compare/child.hpp"
#include "bench/compare/subjects.hpp"

namespace sightline::peers {

struct RunOptions {
  std::size_t cameras = 24;  // of a scene, evenly spread over those that it has; 0: all
  int passes = 5;            // over the cameras, of fast methods; each camera's median counts
  double budget = 120;       // seconds that one method may take of one scene: then it gets no further camera or pass
  ChildLimits child;
};

/// One method's answer to one camera, judged by the reference.
struct ViewResult {
  ViewResult() { outcome.status = Status::not_begun; }
  bool begun() const { return outcome.status != Status::not_begun; }
  bool done() const { return outcome.status == Status::done; }

  Outcome outcome;
  bool judged = false;
  std::uint32_t missed = 0;   // polygons that are visible and were not named
  std::uint32_t falsely = 0;  // polygons named that are not visible
};

struct MethodResult {
  std::string name;
  Method::Kind kind;
  Cost cost;
  std::string fault;              // why it could not be prepared
  std::vector<ViewResult> views;  // by camera; not begun where the budget ran out before
};

struct SceneResult {
  std::string name;
  std::uint32_t polygons = 0, vertices = 0;
  std::uint32_t left_out = 0;  // polygons that cross themselves: the peers are not given them
  int bits = 0;
  double read_seconds = 0;           // from polygons in memory to the exact scene
  std::vector<std::size_t> cameras;  // their indices
  double ray_seconds = 0;            // one incoherent ray: the median over the cameras; 0: not measured
  std::vector<MethodResult> methods;

  /// The first map that was made: what the others are judged and measured by; nullptr where there is none.
  const MethodResult* reference() const;
  /// Of the maps that it made.
  std::vector<double> visible_polygons() const, map_vertices() const;
};

SceneResult run(Subject subject, const Methods& methods, const RunOptions& options);

/// 0 for no values.
double median(std::vector<double> values);

}  // namespace sightline::peers
