// What a comparison says: a table, JSON, a line a view, a picture.
#pragma once

#include "compare/compare.hpp"

#include <filesystem>

namespace sightline::comparison {

/// For people; a line a method, and a line below for each that failed somewhere.
std::string table(std::span<const MethodResult> methods);
/// {"methods": [{"name", "seconds" (a camera, median; null where all failed), "missed", "false" (polygons a camera,
/// mean), "wrong_area" (mean), "worst_area" (window = 1)}], "cameras": n}
std::string json(std::span<const MethodResult> methods, std::size_t cameras);
/// camera,method,seconds,missed,false,wrong_area,worst_area,failed
std::string csv(std::span<const MethodResult> methods);
/// Writes PATH.svg and PATH.png: run time against wrong area, and against polygons missed or falsely reported. Both
/// axes are logarithmic, with a place for zero below. Throws std::system_error.
void write_picture(const std::filesystem::path& path, std::span<const MethodResult> methods, const std::string& title);

}  // namespace sightline::comparison
