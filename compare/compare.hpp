// Methods side by side: run time against error.
#pragma once

#include "compare/method.hpp"
#include "compare/reference.hpp"

#include <functional>
#include <span>

namespace sightline::comparison {

struct ViewResult {
  double seconds = 0;  // processor time from the camera to the result in memory
  Error error;         // of a view that failed: as if nothing had been shown
  std::string why;     // it failed; empty when it did not
};

struct MethodResult {
  std::string name;
  double prepare_seconds = 0;  // what it keeps between views: tree, complex, bounding volumes
  std::vector<ViewResult> views;
};

/// The figures of a method over all cameras.
struct Summary {
  double seconds = 0;              // median of the views that did not fail; NaN where all did
  double missed = 0, falsely = 0;  // polygons, mean
  double wrong_area = 0;           // mean
  double worst_area = 0;           // largest
  std::size_t failed = 0;
};
Summary summary_of(const MethodResult& method);
/// Of the views that did not fail alone.
Summary summary_of_done(const MethodResult& method);

/// Runs every method on every camera, on one thread, and measures each against the exact map, which the engine
/// `front-to-back` makes once more for every view. `step` is called after each camera.
std::vector<MethodResult> compare_methods(const Scene& scene, std::span<const Camera> cameras,
                                          std::span<const MethodName> methods, const std::function<void()>& step);

}  // namespace sightline::comparison
