// What a comparison found: tables, JSON, pictures.
#pragma once

#include <cstdio>
#include <filesystem>
#include <span>

#include "bench/compare/run.hpp"

namespace sightline::peers {

/// A method on a scene in a few figures. Ratios are taken camera by camera, of the cameras that both have done.
struct Figures {
  std::size_t views = 0, cut_off = 0, failed = 0, judged = 0;  // views: those that were begun
  double median_seconds = 0, worst_seconds = 0;                // a view that was cut off counts as the cut-off
  double to_ours = 0, to_ours_least = 0, to_ours_most = 0;     // time / time of the reference; 0: none
  double to_limit = 0, to_limit_most = 0;                      // time / (map vertices x one ray); 0: none
  std::size_t missed = 0, falsely = 0;                         // polygons, of all judged views
  std::size_t wrong_views = 0;
};
Figures figures_of(const SceneResult& scene, const MethodResult& method);

/// One scene: a row a method.
void print_scene(std::FILE* out, const SceneResult& scene);
/// All scenes: a row a scene, the measure that counts.
void print_summary(std::FILE* out, std::span<const SceneResult> scenes);
/// Everything, view by view.
std::string json(std::span<const SceneResult> scenes);
/// Time against scene size (unrotated models of `building`) and against map vertices: data for gnuplot in the folder,
/// and size.svg, complexity.svg where gnuplot is installed. Says on standard error where it is not.
void draw(const std::filesystem::path& folder, std::span<const SceneResult> scenes);

}  // namespace sightline::peers
