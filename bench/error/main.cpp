// bench_error: what `sightline compare` prints, and the memory that the methods take, camera after camera.
#include "bsp/tree.hpp"
#include "compare/compare.hpp"
#include "compare/memory.hpp"
#include "compare/report.hpp"
#include "scene/read.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

namespace sightline::bench {
namespace {

using comparison::MethodName;
using comparison::TellsMemory;

struct ErrorOptions {
  std::string scene, cameras, methods;
};

/// The same methods, which are noted as they are made: a name's place, and the method if it knows its memory.
std::vector<MethodName> noted(std::vector<MethodName> names, std::vector<const TellsMemory*>& known) {
  known.assign(names.size(), nullptr);
  for (std::size_t k = 0; k < names.size(); ++k) {
    names[k].make = [make = names[k].make, &note = known[k]](const Scene& scene) {
      std::unique_ptr<comparison::Method> method = make(scene);
      note = dynamic_cast<const TellsMemory*>(method.get());
      return method;
    };
  }
  return names;
}

std::string kilobytes(std::size_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", static_cast<double>(bytes) / 1e3);
  return text;
}

int run(const ErrorOptions& options) {
  std::vector<const TellsMemory*> known;
  const std::vector<MethodName> methods = noted(comparison::parse_methods(options.methods), known);
  const std::vector<Camera> cameras = read_cameras(options.cameras);
  const Scene scene = make_scene(read_polygons(options.scene));
  std::vector<comparison::MethodMemory> memory(methods.size());
  const auto results = comparison::compare_methods(scene, cameras, methods, [&] {
    for (std::size_t k = 0; k < known.size(); ++k) {
      if (known[k] != nullptr) memory[k] = known[k]->memory();
    }
  });
  std::printf("%u polygons, %zu cameras\n%s", scene.polygon_count(), cameras.size(),
              comparison::table(results).c_str());
  for (std::size_t k = 0; k < methods.size(); ++k) {
    if (known[k] == nullptr) continue;
    std::printf("memory, kB: %s keeps %s, making it needs %s more\n", methods[k].text.c_str(),
                kilobytes(memory[k].kept).c_str(), kilobytes(memory[k].building).c_str());
  }
  std::printf("memory, kB: the exact engine's tree, whole, %s\n", kilobytes(BspTree(scene).size().bytes).c_str());
  return 0;
}

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  CLI::App app("Run time against error, and memory");
  sightline::bench::ErrorOptions options;
  app.add_option("scene", options.scene, "Polygon file")->required()->type_name("SCENE");
  app.add_option("--cameras", options.cameras, "Cameras file")->required()->type_name("C");
  app.add_option("--methods", options.methods, "As for sightline compare")->required()->type_name("LIST");
  CLI11_PARSE(app, argc, argv);
  try {
    return sightline::bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_error: %s\n", error.what());
    return 1;
  }
}
