// Maps back from files.
#pragma once

#include "scene/errors.hpp"
#include "visibility_map/write.hpp"

#include <string_view>

namespace sightline {

/// A map and what its file says of the scene.
struct MapFile {
  MapScene scene;
  VisibilityMap map;
};

/// Reads a map file; throws InputError, one line, where the file is not a whole map of the contract: every reference
/// must be in range, every loop closed, and every edge stand once in a loop of the face on each of its sides. Whether
/// the map is right for its scene is for `verify` to say.
/// Law: map_json(m.map, m.scene) of what was read has the bytes of the file, for each file that map_json made.
/// Directions of vertices are computed anew from camera and st.
MapFile read_map(const std::filesystem::path& file);
/// The same from text; `name` stands for the file in messages.
MapFile parse_map(std::string_view json, const std::string& name);

}  // namespace sightline
