// The scenes under comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sightline::peers {

struct Subject {
  std::string name;
  PolygonSoup soup;
  std::vector<Camera> cameras;
};

/// Names of subjects: `maze`, `building:100000` (a model with a number of polygons), `city@17` (rotated by 17 degrees),
/// or a file `NAME.obj`, `NAME.obj.gz` with `NAME.cameras` beside it.
/// The default ones: five models, their rotated copies, and every scene in the folder, where there is one.
std::vector<std::string> default_subjects(const std::filesystem::path& folder);

/// Throws std::exception where there is none of that name.
Subject make_subject(const std::string& name);

}  // namespace sightline::peers
