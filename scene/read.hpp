// Reading polygon files and cameras.
#pragma once

#include "scene/camera.hpp"
#include "scene/errors.hpp"
#include "scene/scene.hpp"

#include <filesystem>

namespace sightline {

/// Reads .obj, .ply, .off or .stl (by extension, any case; the last three ASCII or binary where the format has both).
/// Throws InputError. Coordinates are the doubles that the text parses to, correctly rounded.
PolygonSoup read_polygons(const std::filesystem::path& file);
/// Reads `NAME.cameras` and reduces each line to its vectors (see camera.hpp). Throws InputError.
std::vector<Camera> read_cameras(const std::filesystem::path& file);

/// Writes OBJ / cameras so that reading gives the same doubles (shortest decimals). Temporary name, then renamed.
void write_obj(const std::filesystem::path& file, const PolygonSoup& soup);
struct CameraLine {
  glm::dvec3 eye, forward, up;
  double vertical_fov_degrees, aspect;
};
void write_cameras(const std::filesystem::path& file, std::span<const CameraLine> cameras);
/// Writes text to a temporary file beside `file` and renames it: an interrupted run leaves no half file.
/// Throws std::system_error.
void write_file(const std::filesystem::path& file, std::string_view content);
/// Removes the temporary files of every write_file that has not come to its end, which then never does: call it right
/// before the process ends. Allocates nothing.
void remove_temporary_files() noexcept;

}  // namespace sightline
