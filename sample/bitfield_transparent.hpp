// Which polygons are transparent: by name, or from a list. (Meruvia and Strothotte, section 3.4.)
#pragma once

#include "scene/scene.hpp"

#include <filesystem>

namespace sightline {

/// The polygons of these objects (`o` or `g`) and, where `file`, from which the scene was read, is an OBJ, of these
/// materials (`usemtl`); ascending. Throws InputError for a name that no polygon has, and where the file cannot be read.
std::vector<PolygonId> polygons_named(const Scene& scene, const std::filesystem::path& file,
                                      std::span<const std::string> names);

/// Polygons by index, with blanks or line ends between them and `#` comments; ascending, nothing twice. Throws
/// InputError naming file and line.
std::vector<PolygonId> read_polygon_list(const std::filesystem::path& file, std::uint32_t polygons);

}  // namespace sightline
