// A map file as it stands.
#pragma once

#include "verify/report.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::verify {

inline constexpr std::uint32_t none = UINT32_MAX;

struct MapLine {
  enum Kind { window, edge, planes } kind = window;
  std::array<std::uint32_t, 6> v{};  // window: v[0] is 0 left, 1 right, 2 bottom, 3 top
};
struct MapVertex {
  std::array<double, 2> st{};
  std::array<std::uint32_t, 2> lines{};
  std::uint32_t scene_vertex = none;
};
enum class EdgeKind { silhouette, crease, seam, intersection, window };
const char* name_of(EdgeKind kind);
struct MapEdge {
  std::array<std::uint32_t, 2> vertices{};
  std::uint32_t line = 0, left = none, right = none;
  EdgeKind kind = EdgeKind::window;
  std::uint32_t owner = none;
};
struct MapFace {
  std::uint32_t polygon = none;
  std::vector<std::uint32_t> coincident;
  std::vector<std::vector<std::int32_t>> loops;
  double area = 0, solid_angle = 0;
};
struct MapFile {
  std::uint32_t scene_vertices = 0, scene_polygons = 0;
  std::string snap;  // empty: none
  std::array<double, 3> eye{}, forward{}, right{}, up{};
  std::vector<MapLine> lines;
  std::vector<MapVertex> vertices;
  std::vector<MapEdge> edges;
  std::vector<MapFace> faces;
};

/// Reads a map. What is JSON but not such a map is reported under "schema", and then there is no result; so is every
/// index that is out of range. Throws InputError where the text is no JSON.
std::optional<MapFile> parse_map(const std::string& file, std::string_view text, Report& report);

inline std::uint32_t edge_of(std::int32_t entry) {
  return static_cast<std::uint32_t>(entry >= 0 ? entry : -(entry + 1));
}

}  // namespace sightline::verify
