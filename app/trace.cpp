// sightline trace SCENE|X.wp --cameras C -o DIR
#include "beam/trace.hpp"

#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "bsp/build.hpp"
#include "clip/hybrid.hpp"
#include "scene/read.hpp"
#include "visibility_map/write.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <optional>
#include <set>
#include <sstream>

namespace sightline::app {

namespace {

struct TraceCommand {
  CommonOptions common;
  std::filesystem::path input, cameras, folder;
  std::string formats = "map";
  TraceOptions options;
  std::vector<double> window;  // low s, low t, high s, high t
};

/// The names between the commas.
std::set<std::string> checked_formats(const std::string& list) {
  static const std::set<std::string> known{"map", "svg", "png", "pdf", "csv"};
  std::set<std::string> formats;
  std::istringstream names(list + ",");
  for (std::string name; std::getline(names, name, ',');) {
    if (!known.contains(name)) throw UsageError("--format " + list + ": formats are map, svg, png, pdf, csv");
    formats.insert(name);
  }
  return formats;
}

/// Files of one camera after the other: DIR/0000.map.json, DIR/0000.svg, ..
class MapWriter {
 public:
  MapWriter(const std::filesystem::path& folder, const std::set<std::string>& formats, std::size_t cameras)
      : folder_(folder), formats_(formats), csv_(cameras) {}

  /// From any thread, for different cameras at a time.
  void write(std::size_t camera, const VisibilityMap& map, const Scene& scene) {
    if (wants("map")) write_text(name(camera, ".map.json"), map_json(map, scene));
    if (wants("svg")) write_text(name(camera, ".svg"), map_svg(map, scene));
    if (wants("png")) {
      const auto file = name(camera, ".png");
      write_safely(file, [&] { write_map_png(file, map, scene); });
    }
    if (wants("pdf")) {
      const auto file = name(camera, ".pdf");
      write_safely(file, [&] { write_map_pdf(file, map, scene); });
    }
    if (wants("csv")) csv_[camera] = map_csv(map, scene, camera);
  }
  /// After the last camera: what is one file for all.
  void finish() {
    if (!wants("csv")) return;
    std::string text = csv_header;
    for (const std::string& rows : csv_) text += rows;
    write_text(folder_ / "visibility.csv", text);
  }

 private:
  bool wants(const std::string& format) const { return formats_.contains(format); }
  std::filesystem::path name(std::size_t camera, const char* ending) const { return numbered(folder_, camera, ending); }

  std::filesystem::path folder_;
  std::set<std::string> formats_;
  std::vector<std::string> csv_;
};

/// What makes a camera's map, and its figures; for one thread.
using TraceOne = std::function<CameraFigures(const Camera&, VisibilityMap&)>;

TraceOne one_of(const Tracer& prepared) {
  return [tracer = std::make_shared<Tracer>(prepared)](const Camera& camera, VisibilityMap& map) -> CameraFigures {
    TraceStats s;
    tracer->trace(camera, map, &s);
    return {s.seconds, s.beams, s.cells, s.faces, s.edges, s.vertices, s.left_out, {}};
  };
}

TraceOne one_of(const HybridTracer& prepared) {
  return
      [tracer = std::make_shared<HybridTracer>(prepared)](const Camera& camera, VisibilityMap& map) -> CameraFigures {
        HybridStats s;
        tracer->trace(camera, map, &s);
        return {s.seconds, s.pieces, s.surfaces, s.faces, s.edges, s.vertices, 0, {}};
      };
}

/// Traces all cameras and writes their maps; a camera that fails leaves its reason in its figures.
std::vector<CameraFigures> trace_all(const std::function<TraceOne()>& make_tracer, const Scene& scene,
                                     const std::vector<Camera>& cameras, MapWriter& writer,
                                     const CommonOptions& options) {
  struct Worker {
    TraceOne trace;
    VisibilityMap map;
  };
  std::vector<CameraFigures> figures(cameras.size());
  Progress progress("tracing", cameras.size(), options.quiet);
  tbb::enumerable_thread_specific<Worker> workers;
  const auto trace_one = [&](std::size_t k) {
    Worker& worker = workers.local();
    try {
      if (!worker.trace) worker.trace = make_tracer();
      figures[k] = worker.trace(cameras[k], worker.map);
      writer.write(k, worker.map, scene);
    } catch (const OutputError&) {
      throw;  // no fault of the camera's: the next would not be written either
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      figures[k].error = error.what();
      worker.trace = {};  // its buffers may be in any state
    }
    progress.step();
  };
  tbb::task_arena arena(static_cast<int>(options.threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, cameras.size(), trace_one, tbb::simple_partitioner()); });
  return figures;
}

constexpr std::size_t few_cameras = 16;  // below this many a tree is divided only where they look

/// The complex of a .wp file, or one built now; with its figures.
ComplexFigures complex_of(Input& input) {
  if (input.complex) {
    ComplexFigures figures = figures_of(*input.complex);
    figures.from_file = true;
    return figures;
  }
  BuildStats stats;
  input.complex = build(input.scene, {}, &stats);
  ComplexFigures figures = figures_of(*input.complex);
  figures.seconds = stats.seconds;
  return figures;
}

int trace_cameras(TraceCommand& command) {
  check(command.common);
  const std::set<std::string> formats = checked_formats(command.formats);
  if (!(command.options.min_angle >= 0 && command.options.min_angle <= 0.01)) {
    throw UsageError("--min-angle: radians from 0 to 0.01");
  }
  if (!(command.options.max_distance > 0)) throw UsageError("--max-distance: a positive number");
  const std::string engine = command.common.engine;
  if (command.options.min_angle != 0 && engine != "front-to-back") {
    throw UsageError("--min-angle: not with --engine " + engine + ", which leaves nothing narrow out");
  }
  if (std::isfinite(command.options.max_distance) && engine == "hybrid") {
    throw UsageError("--max-distance: not with --engine hybrid");
  }
  const Stopwatch watch;
  std::vector<Camera> cameras = read_cameras(command.cameras);
  if (cameras.empty()) throw InputError(command.cameras.string() + ": no camera in it");
  if (!command.window.empty()) {
    const auto& w = command.window;
    try {
      for (Camera& camera : cameras) camera = crop(camera, {w[0], w[1]}, {w[2], w[3]});
    } catch (const std::invalid_argument& error) {
      throw UsageError(std::string("--window: ") + error.what());
    }
  }
  Input input = read_input(command.input, command.common);
  make_folder(command.folder);
  tell(describe(input.scene), command.common.quiet);

  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, command.common.threads);
  Report report{"trace", input.scene, {}, {}, 0, done};
  std::optional<BspTree> tree;
  // Threads that have no camera of their own share one.
  const auto count = static_cast<unsigned>(cameras.size());
  command.options.threads = std::max(1u, command.common.threads / std::max(1u, count));
  std::function<TraceOne()> make_tracer;
  if (engine == "cells") {
    report.complex = complex_of(input);
    make_tracer = [tracer = Tracer(input.scene, *input.complex, command.options)] { return one_of(tracer); };
  } else if (engine == "hybrid") {
    const Stopwatch boxing;
    HybridTracer tracer(input.scene);
    report.complex.emplace();
    report.complex->seconds = boxing.seconds();
    report.complex->bytes = tracer.bytes();
    make_tracer = [tracer = std::move(tracer)] { return one_of(tracer); };
  } else {
    const Stopwatch growing;
    const bool lazy = cameras.size() < few_cameras;
    tree.emplace(input.scene, TreeOptions{lazy, command.common.threads});
    report.complex = figures_of(*tree);
    report.complex->seconds = growing.seconds();
    report.complex->lazy = lazy;
    make_tracer = [tracer = Tracer(*tree, command.options)] { return one_of(tracer); };
  }
  if (report.complex->cells > 0) tell(describe(*report.complex), command.common.quiet);

  MapWriter writer(command.folder, formats, cameras.size());
  report.cameras = trace_all(make_tracer, input.scene, cameras, writer, command.common);
  writer.finish();
  std::size_t failed = 0;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (report.cameras[k].error.empty()) continue;
    complain("camera " + std::to_string(k) + " failed: " + report.cameras[k].error);
    ++failed;
  }
  report.exit_code = failed == 0 ? done : some_failed;
  report.seconds = watch.seconds();
  publish(report, command.common);
  tell(counted(cameras.size() - failed, "camera") + " traced to " + command.folder.string(), command.common.quiet);
  return report.exit_code;
}

}  // namespace

void add_trace_command(CLI::App& root, Run& run) {
  auto command = std::make_shared<TraceCommand>();
  CLI::App* sub = root.add_subcommand("trace", "Make the visibility map of every camera");
  sub->add_option("scene", command->input, "Polygon file, or .wp file of `sightline build`")
      ->required()
      ->type_name("SCENE|X.wp");
  sub->add_option("--cameras", command->cameras, "Cameras file")->required()->type_name("C");
  sub->add_option("-o,--output", command->folder, "Folder for the maps; made if missing")->required()->type_name("DIR");
  sub->add_option("--format", command->formats, "What to write: map, svg, png, pdf, csv")
      ->type_name("LIST")
      ->capture_default_str();
  sub->add_option("--window", command->window,
                  "Only this part of every camera's window, in multiples of 2^-20: low s, low t, high s, high t")
      ->expected(4)
      ->delimiter(',')
      ->type_name("S0,T0,S1,T1");
  sub->add_option("--min-angle", command->options.min_angle,
                  "Radians: what is narrower is not followed; the report bounds what that leaves out. 0: exact")
      ->type_name("A")
      ->capture_default_str();
  sub->add_option("--max-distance", command->options.max_distance,
                  "In the scene's units: polygons whose bounding box is farther from the eye are left out")
      ->type_name("D");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return trace_cameras(*command); }; });
}

}  // namespace sightline::app
