// The paper's two tables on our models or on files: what the complex costs, what the maps cost.
#include <sys/resource.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "beam/trace.hpp"
#include "bench/cpu_seconds.hpp"
#include "bsp/build.hpp"
#include "exact/tally.hpp"
#include "models/model.hpp"
#include "scene/read.hpp"
#include "winged_pair/check.hpp"

namespace {

using namespace sightline;

struct Subject {
  std::string name;
  PolygonSoup soup;
  std::vector<Camera> cameras;
};

Subject of_model(const std::string& name, const ModelOptions& options) {
  Model model = make_model(name, options);
  Subject s{name, std::move(model.soup), {}};
  for (const CameraLine& c : model.cameras) {
    s.cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  return s;
}

struct Spread {
  std::vector<double> values;
  void add(double v) { values.push_back(v); }
  void print(const char* format) {
    std::sort(values.begin(), values.end());
    double sum = 0;
    for (const double v : values) sum += v;
    std::printf(" | ");
    std::printf(format, values.front());
    std::printf(" | ");
    std::printf(format, sum / static_cast<double>(values.size()));
    std::printf(" | ");
    std::printf(format, values.back());
  }
};

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void print_tally(const Tally& t) {
  std::printf("  decisions: identity %llu, filter %llu, exact", static_cast<unsigned long long>(t.identity),
              static_cast<unsigned long long>(t.filter));
  for (std::size_t k = 0; k < t.exact.size(); ++k) {
    if (t.exact[k] != 0) std::printf(" %d:%llu", Tally::widths[k], static_cast<unsigned long long>(t.exact[k]));
  }
  std::printf("\n");
}

int passes = 1;

/// Table 2: the maps of all cameras, by whatever engine the tracer has. Of several passes each camera's best counts:
/// what it costs when nothing else gets in the way.
void trace_all(const Subject& subject, double polygons, Tracer& tracer) {
  Spread beams, fragments, faces, edges, milliseconds;
  VisibilityMap map;
  TraceStats stats;
  tracer.trace(subject.cameras[0], map, &stats);  // warms the buffers
  std::vector<double> best(subject.cameras.size(), INFINITY);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t k = 0; k < best.size(); ++k) {
      const double before_map = cpu_seconds();
      tracer.trace(subject.cameras[k], map);
      best[k] = std::min(best[k], cpu_seconds() - before_map);
    }
  }
  for (std::size_t k = 0; k < best.size(); ++k) {
    tracer.trace(subject.cameras[k], map, &stats);
    milliseconds.add(best[k] * 1e3);
    beams.add(stats.beams);
    fragments.add(stats.fragments);
    faces.add(stats.faces);
    edges.add(stats.edges);
  }
  std::printf("%-14s | %.0f", subject.name.c_str(), polygons);
  beams.print("%.0f");
  faces.print("%.0f");
  edges.print("%.0f");
  milliseconds.print("%.3f");
  std::printf(" | fragments");
  fragments.print("%.0f");
  std::printf("\n");
}

/// The engine that has no complex: the tree in place of table 1.
void run_on_tree(const Subject& subject, bool decisions) {
  const Scene scene = make_scene(subject.soup);
  const double start = cpu_seconds();
  const BspTree tree(scene);
  const double growing = cpu_seconds() - start;
  const BspTree::Size size = tree.size();
  std::printf("%-14s | %u | %zu nodes | %zu pieces | %.3f | %.1f MB, peak %.0f MB\n", subject.name.c_str(),
              scene.polygon_count(), size.nodes, size.pieces, growing, static_cast<double>(size.bytes) / 1e6,
              peak_megabytes());
  if (subject.cameras.empty()) return;
  const Tally before = tally_total();
  Tracer tracer(tree);
  trace_all(subject, scene.polygon_count(), tracer);
  if (decisions) print_tally(tally_total() - before);
}

void run(Subject& subject, const BuildOptions& how, bool prove, bool decisions) {
  const double start = cpu_seconds();
  const Scene scene = make_scene(subject.soup);
  const double read = cpu_seconds() - start;
  const Tally before = tally_total();
  BuildStats built;
  const double scene_ready = cpu_seconds();
  const Complex complex = build(scene, how, &built);
  const double building = cpu_seconds() - scene_ready;
  const double n = scene.polygon_count();
  std::printf(
      "%-14s | %.0f | %zu | %zu | %zu | %zu | %.3f | cells %.2f, faces %.2f a polygon | %.1f MB, peak %.0f MB | scene "
      "%.3f s, "
      "splits %u, bits %d\n",
      subject.name.c_str(), n, complex.cells.size(), complex.faces.size(), complex.edges.size(),
      complex.vertices.size(), building, static_cast<double>(complex.cells.size()) / n,
      static_cast<double>(complex.faces.size()) / n, static_cast<double>(built.bytes) / 1e6, peak_megabytes(), read,
      built.splits, scene.grid().bits());
  const Tally after = tally_total();
  if (decisions) print_tally(after - before);
  if (prove) {
    for (const std::string& fault : check(complex, scene)) std::printf("  FAULT %s\n", fault.c_str());
  }
  if (subject.cameras.empty()) return;
  Tracer tracer(scene, complex);
  trace_all(subject, n, tracer);
  if (decisions) print_tally(tally_total() - after);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Tables 1 and 2 of Funkhouser 1999 on models and files"};
  std::vector<std::string> names;
  ModelOptions options;
  std::string scene_file, camera_file;
  BuildOptions how;
  bool prove = false, decisions = false, tree = false;
  app.add_option("models", names, "models; default: the paper's six");
  app.add_option("--polygons", options.polygons);
  app.add_option("--rotate", options.rotate_degrees);
  app.add_option("--scene", scene_file);
  app.add_option("--cameras", camera_file);
  app.add_option("--split", how.weights.split, "weights of the choice of cuts: see bsp/weights.hpp");
  app.add_option("--area", how.weights.area);
  app.add_option("--cover", how.weights.cover);
  app.add_option("--axis", how.weights.axis);
  app.add_option("--passes", passes, "each camera's best of so many passes");
  app.add_flag("--tree", tree, "engine front-to-back, on a tree, in place of cells");
  app.add_flag("--check", prove, "prove each complex (slow)");
  app.add_flag("--decisions", decisions, "count decisions by stage");
  CLI11_PARSE(app, argc, argv);
  if (scene_file.empty() && names.empty()) names = {"rooms", "maze", "arena", "city", "floor", "building"};
  std::printf("model | polygons | cells | faces | edges | vertices | seconds\n");
  std::printf(
      "model | polygons | beams min | avg | max | faces min | avg | max | edges min | avg | max | ms min | avg | "
      "max\n");
  try {
    for (const std::string& name : names) {
      Subject s = of_model(name, options);
      tree ? run_on_tree(s, decisions) : run(s, how, prove, decisions);
    }
    if (!scene_file.empty()) {
      Subject s{scene_file, read_polygons(scene_file), {}};
      if (!camera_file.empty()) s.cameras = read_cameras(camera_file);
      tree ? run_on_tree(s, decisions) : run(s, how, prove, decisions);
    }
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 3;
  }
}
