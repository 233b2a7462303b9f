// Maps as files. All texts are the same bytes for the same map.
#pragma once

#include "visibility_map/map.hpp"

#include <filesystem>
#include <string>

namespace sightline {

/// What a map file says of its scene.
struct MapScene {
  std::string source;  // the file's name
  std::uint64_t vertices = 0;
  std::uint64_t polygons = 0;
  std::string snap;  // unit as the user wrote it; empty: null in the file
};
MapScene map_scene(const Scene& scene);

/// The map file of the contract (format "sightline-map", version 1): one element of an array a line, 17 significant
/// digits, independent of the locale; -0 is written as 0. Throws std::invalid_argument for a sphere map, which has no
/// window and so no file.
std::string map_json(const VisibilityMap& map, const MapScene& scene);
std::string map_json(const VisibilityMap& map, const Scene& scene);
/// How a map is drawn. Faces that see nothing are left as paper.
struct DrawOptions {
  enum class Fill {
    polygon,  // a muted colour for each polygon, by its index, lighter or darker by its orientation
    shaded,   // one warm grey, lighter or darker by orientation
    empty     // a line drawing
  };
  int width = 1024;  // pixels (PDF: points); the height follows the camera's aspect
  Fill fill = Fill::polygon;
  bool edges = true;        // thin lines: creases, seams, intersections
  bool silhouettes = true;  // heavy lines
};

/// SVG: one path a face (class "face", data-polygon the polygon or "none"), then one path an edge with its kind as
/// class, silhouettes heavy. PNG and PDF show the same drawing. Files are written under a temporary name and renamed.
/// Errors: std::invalid_argument for a sphere map, or where a side would be below 1 or above 32,767 pixels;
/// std::system_error where a file cannot be written.
std::string map_svg(const VisibilityMap& map, const Scene& scene, int width = 1024);
std::string map_svg(const VisibilityMap& map, const Scene& scene, const DrawOptions& options);
void write_map_png(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene, int width = 1024);
void write_map_png(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene,
                   const DrawOptions& options);
void write_map_pdf(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene, int width = 1024);
void write_map_pdf(const std::filesystem::path& file, const VisibilityMap& map, const Scene& scene,
                   const DrawOptions& options);

/// Visible part of one polygon in one map.
struct PolygonVisibility {
  PolygonId polygon;
  bool full;        // nothing of its projection inside the window is hidden
  double area;      // part of the window
  double fraction;  // of its own projection inside the window
};
/// The polygons seen, ascending; polygons not listed are hidden.
std::vector<PolygonVisibility> visible_polygons(const VisibilityMap& map, const Scene& scene);
/// CSV rows "camera,polygon,status,area,fraction" without the header line, which `csv_header` holds.
std::string map_csv(const VisibilityMap& map, const Scene& scene, std::size_t camera);
inline constexpr const char* csv_header = "camera,polygon,status,area,fraction\n";

}  // namespace sightline
