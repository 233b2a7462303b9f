// Side by side, in one run: the engines of this library and the peers, on the same scenes and cameras.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "bench/compare/report.hpp"
#include "scene/read.hpp"

namespace {

using namespace sightline;
using namespace sightline::peers;

/// `wanted` names methods or sources, or begins their names; empty: all.
Methods chosen(const std::vector<std::string>& wanted) {
  Methods out;
  std::vector<bool> used(wanted.size());
  const auto is_wanted = [&](const std::string& name) {
    bool found = wanted.empty();
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (!name.starts_with(wanted[k])) continue;
      used[k] = found = true;
    }
    return found;
  };
  for (const Source& source : sources()) {
    const bool whole = is_wanted(source.name);
    if (!source.make) {
      std::fprintf(stderr, "compare: %s is not in this build (Debian: %s)\n", source.name.c_str(),
                   source.package.c_str());
      continue;
    }
    for (auto& method : source.make()) {
      // The unit of the measure is never left out.
      if (is_wanted(method->name()) || whole || method->kind() == Method::Kind::ray) out.push_back(std::move(method));
    }
  }
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (!used[k]) throw std::invalid_argument("no method '" + wanted[k] + "'");
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Exact visibility maps against the peers, side by side"};
  std::vector<std::string> names, wanted;
  RunOptions options;
  std::string json_file, pictures, folder = "../shared/scenes";
  bool sweep = false;
  app.add_option("scenes", names,
                 "maze, building:100000, city@17 (rotated by 17 degrees), FILE.obj, FILE.obj.gz; default: five models, "
                 "their rotated copies, and the folder of scenes");
  app.add_option("--methods", wanted, "names or their beginnings: ours, embree-1024, cgal, gl2ps, occt")
      ->delimiter(',');
  app.add_option("--folder", folder, "of more scenes, where it exists")->capture_default_str();
  app.add_flag("--sweep", sweep, "building of 1,000 to 1,000,000 polygons");
  app.add_option("--cameras", options.cameras, "of a scene, evenly spread; 0: all")->capture_default_str();
  app.add_option("--passes", options.passes, "over the cameras, of fast methods")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--cut-off", options.child.seconds, "of one view, in seconds")->capture_default_str();
  app.add_option("--budget", options.budget, "of one method on one scene, in seconds")->capture_default_str();
  app.add_option("--memory", options.child.gigabytes, "of one view, in GB")->capture_default_str();
  app.add_option("--json", json_file, "write everything here");
  app.add_option("--pictures", pictures, "draw into this folder");
  CLI11_PARSE(app, argc, argv);
  if (sweep) {
    for (const char* size : {"1000", "3000", "10000", "30000", "100000", "300000", "1000000"}) {
      names.push_back(std::string("building:") + size);
    }
  }
  if (names.empty()) {
    names = default_subjects(folder);
    if (!std::filesystem::is_directory(folder)) {
      std::fprintf(stderr, "compare: no folder %s: the models only\n", folder.c_str());
    }
  }
  try {
    const Methods methods = chosen(wanted);
    std::vector<SceneResult> results;
    for (const std::string& name : names) {
      results.push_back(run(make_subject(name), methods, options));
      print_scene(stdout, results.back());
      if (!json_file.empty()) write_file(json_file, json(results));  // a long run that ends early leaves something
    }
    print_summary(stdout, results);
    if (!pictures.empty()) draw(pictures, results);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "compare: %s\n", e.what());
    return 3;
  }
}
