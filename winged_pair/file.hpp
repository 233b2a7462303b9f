// The `.wp` file: ASCII, exact, read back bit for bit.
#pragma once

#include "scene/errors.hpp"
#include "winged_pair/complex.hpp"

#include <filesystem>

namespace sightline {

/// Writes the scene and the complex (temporary name, then renamed). Throws std::system_error.
void write_wp(const std::filesystem::path& file, const Scene& scene, const Complex& complex);

struct SceneAndComplex {
  Scene scene;
  Complex complex;
};
/// Reads them back: the same ids, the same numbers, the same order. Throws InputError naming file, line and item.
SceneAndComplex read_wp(const std::filesystem::path& file);

}  // namespace sightline
