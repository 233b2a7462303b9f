#include "app/describe.hpp"

#include <cstdio>

namespace sightline::app {

namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string describe(const Scene& scene) {
  const SceneReport& r = scene.report();
  std::string text = scene.soup().source + ": " + counted(scene.polygon_count(), "polygon") + ", " +
                     std::to_string(scene.grid().bits()) + "-bit coordinates";
  if (r.dropped != 0) text += "; " + std::to_string(r.dropped) + " without area dropped";
  if (r.nonplanar != 0) text += "; " + std::to_string(r.nonplanar) + " not planar, cut into triangles";
  if (r.nonconvex != 0) text += "; " + std::to_string(r.nonconvex) + " not convex";
  if (r.self_crossing != 0) text += "; " + std::to_string(r.self_crossing) + " crossing themselves";
  if (r.duplicates != 0) text += "; " + std::to_string(r.duplicates) + " on the vertices of an earlier one";
  if (!scene.options().snap.empty()) {
    text += "; snapped to " + scene.options().snap + ", moved by up to " + number(r.largest_displacement);
  }
  return text;
}

std::string describe(const ComplexFigures& c) {
  std::string text = c.nodes == 0 ? "complex: " + counted(c.cells, "cell") + ", " + counted(c.faces, "face")
                                  : "tree: " + counted(c.nodes, "node") + ", " + counted(c.pieces, "piece");
  if (c.lazy) return text + " so far, divided only where a camera looks";
  if (!c.from_file) text += ", built in " + number(c.seconds) + " s";
  return text;
}

}  // namespace sightline::app
