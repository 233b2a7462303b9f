// Data files for gnuplot, and a call of it.
#include <algorithm>
#include <cstdlib>
#include <map>

#include "bench/compare/report.hpp"
#include "scene/read.hpp"

namespace sightline::peers {
namespace {

/// One block of points a method, named in its first line.
using Blocks = std::vector<std::pair<std::string, std::vector<std::pair<double, double>>>>;

void add(Blocks& blocks, const std::string& name, double x, double y) {
  auto at = std::ranges::find(blocks, name, &Blocks::value_type::first);
  if (at == blocks.end()) at = blocks.insert(blocks.end(), {name, {}});
  at->second.emplace_back(x, y);
}

void write_blocks(const std::filesystem::path& file, Blocks& blocks) {
  std::string text;
  for (auto& [name, points] : blocks) {
    std::ranges::sort(points);
    if (!text.empty()) text += "\n\n";
    text += "\"" + name + "\"\n";
    char line[64];
    for (const auto& [x, y] : points) {
      std::snprintf(line, sizeof line, "%.6g %.6g\n", x, y);
      text += line;
    }
  }
  write_file(file, text);
}

}  // namespace

void draw(const std::filesystem::path& folder, std::span<const SceneResult> scenes) {
  std::filesystem::create_directories(folder);
  Blocks size, complexity, size_floors, floors;  // the floors come last: drawn in grey
  for (const SceneResult& s : scenes) {
    const MethodResult* reference = s.reference();
    const bool of_sizes = s.name.starts_with("building") && s.name.find('@') == std::string::npos;
    for (const MethodResult& m : s.methods) {
      if (m.kind == Method::Kind::ray) continue;
      const Figures f = figures_of(s, m);
      // A median of views that were cut off is no time.
      if (of_sizes && f.median_seconds > 0 && 2 * f.cut_off < f.views) {
        add(size, m.name, s.polygons, f.median_seconds * 1e3);
      }
      for (std::size_t k = 0; reference != nullptr && k < m.views.size(); ++k) {
        if (!m.views[k].done() || !reference->views[k].done()) continue;
        add(complexity, m.name, reference->views[k].outcome.vertices, m.views[k].outcome.seconds * 1e3);
      }
    }
    if (reference == nullptr || !(s.ray_seconds > 0)) continue;
    for (const double n : s.map_vertices()) add(floors, "a ray a vertex", n, n * s.ray_seconds * 1e3);
    if (of_sizes) add(size_floors, "a ray a vertex", s.polygons, median(s.map_vertices()) * s.ray_seconds * 1e3);
  }
  size.insert(size.end(), size_floors.begin(), size_floors.end());
  complexity.insert(complexity.end(), floors.begin(), floors.end());
  write_blocks(folder / "size.dat", size);
  write_blocks(folder / "complexity.dat", complexity);
  for (const std::string picture : {"size", "complexity"}) {
    if ((picture == "size" ? size : complexity).empty()) continue;
    const std::string command =
        "gnuplot -e \"folder='" + folder.string() + "'\" '" SIGHTLINE_COMPARE_SCRIPTS "/" + picture + ".gp'";
    if (std::system(command.c_str()) != 0) {
      std::fprintf(stderr, "compare: no picture without gnuplot (Debian: gnuplot-nox); the command was: %s\n",
                   command.c_str());
    }
  }
}

}  // namespace sightline::peers
