// Programs that come with the command.
#pragma once

#include <filesystem>
#include <string>

namespace sightline::comparison {

/// A program beside the running executable, or where the installation puts it; throws std::runtime_error if it is in
/// neither place.
std::filesystem::path companion(const std::string& program);

}  // namespace sightline::comparison
