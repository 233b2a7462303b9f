// What is kept of a map, and how two texts of maps are compared.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "visibility_map/map.hpp"

namespace sightline::golden {

/// One line of MODEL.txt. The fingerprint is taken over all bytes of the map file but the values of "solid_angle",
/// which go through the platform's atan2 and may differ in their last bits; their sum is kept beside it.
struct Row {
  std::size_t camera = 0, faces = 0, edges = 0, vertices = 0, lines = 0;
  std::uint64_t fingerprint = 0;
  double solid_angle = 0;
};
Row row_of(std::size_t camera, const VisibilityMap& map, const std::string& json);
/// Empty if the two are alike, else what differs first, for a reader.
std::string difference(const Row& kept, const Row& now);

std::string text_of(const std::string& model, const std::vector<Row>& rows);
/// Throws std::runtime_error naming the file where it is missing or is none of ours.
std::vector<Row> read_rows(const std::filesystem::path& file);

/// Compares two map files by lines: byte for byte, solid angles within `angle_tolerance`. Empty if they are alike, else
/// the first line that differs, from both.
std::string difference(std::string_view kept, std::string_view now);

std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

inline constexpr double angle_tolerance = 1e-12;  // steradians

}  // namespace sightline::golden
