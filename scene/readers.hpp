// The readers behind read_polygons, one a format. Each gets the whole file and throws InputError.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <string_view>

namespace sightline {

/// `file` is the name for messages. The result's `source` is left empty.
PolygonSoup read_obj(const std::string& file, std::string_view text);
PolygonSoup read_ply(const std::string& file, std::string_view bytes);
PolygonSoup read_off(const std::string& file, std::string_view text);
PolygonSoup read_stl(const std::string& file, std::string_view bytes);

/// The whole file in memory. Throws InputError where it cannot be read or is empty.
std::string load_file(const std::string& file);

}  // namespace sightline
