// sightline trace SCENE|X.wp --cameras C -o DIR
#include "beam/trace.hpp"

#include "app/camera_source.hpp"
#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/map_writer.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "bsp/build.hpp"
#include "clip/hybrid.hpp"
#include "scene/errors.hpp"

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

namespace sightline::app {

namespace {

struct TraceCommand {
  CommonOptions common;
  std::filesystem::path input, cameras, folder;
  std::string formats = "map";
  TraceOptions options;
  std::vector<double> window;  // low s, low t, high s, high t
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

/// Traces all cameras, those of the source's first batch at first, and writes their maps. Gives how many were traced; a
/// camera that fails is complained of. `figures` of all of them, where there are any to be told.
struct Traced {
  std::size_t cameras = 0, failed = 0;
};
Traced trace_all(const std::function<TraceOne()>& make_tracer, const Scene& scene, CameraSource& source,
                 MapWriter& writer, const CommonOptions& options, std::vector<CameraFigures>* figures) {
  struct Worker {
    TraceOne trace;
    VisibilityMap map;
  };
  Traced traced;
  std::vector<CameraFigures> batch;
  Progress progress("tracing", source.total().value_or(0), options.quiet);
  tbb::enumerable_thread_specific<Worker> workers;
  const auto trace_one = [&](std::size_t k) {
    Worker& worker = workers.local();
    try {
      if (!worker.trace) worker.trace = make_tracer();
      batch[k] = worker.trace(source.cameras()[k], worker.map);
      writer.write(k, traced.cameras + k, worker.map, scene);
    } catch (const OutputError& error) {
      if (!error.of_this_file()) throw;  // the next would not be written either
      batch[k].error = error.what();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      batch[k].error = error.what();
      worker.trace = {};  // its buffers may be in any state
    }
    progress.step();
  };
  tbb::task_arena arena(static_cast<int>(options.threads));
  for (;;) {
    const std::size_t count = source.cameras().size();
    batch.assign(count, {});
    writer.begin(count);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, trace_one, tbb::simple_partitioner()); });
    writer.end();
    for (std::size_t k = 0; k < count; ++k) {
      if (batch[k].error.empty()) continue;
      complain("camera " + std::to_string(traced.cameras + k) + " failed: " + batch[k].error);
      ++traced.failed;
    }
    traced.cameras += count;
    if (figures) figures->insert(figures->end(), batch.begin(), batch.end());
    if (source.ended()) break;
    try {
      source.next();
    } catch (const InputError&) {
      writer.finish();  // what came before the fault is right
      throw;
    }
  }
  writer.finish();
  return traced;
}

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
  CameraSource cameras(command.cameras, command.window);
  cameras.next();
  Input input = read_input(command.input, command.common);
  make_folder(command.folder);
  tell(describe(input.scene), command.common.quiet);

  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, command.common.threads);
  Report report{"trace", input.scene, {}, {}, 0, done};
  std::optional<BspTree> tree;
  // Threads that have no camera of their own share one.
  const auto count = static_cast<unsigned>(cameras.cameras().size());
  command.options.threads = cameras.ended() ? std::max(1u, command.common.threads / std::max(1u, count)) : 1;
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
    const bool lazy = cameras.ended() && count < few_cameras;
    tree.emplace(input.scene, TreeOptions{lazy, command.common.threads});
    report.complex = figures_of(*tree);
    report.complex->seconds = growing.seconds();
    report.complex->lazy = lazy;
    make_tracer = [tracer = Tracer(*tree, command.options)] { return one_of(tracer); };
  }
  if (report.complex->cells > 0) tell(describe(*report.complex), command.common.quiet);

  MapWriter writer(command.folder, formats);
  const bool tells = command.common.json || !command.common.report.empty();
  const Traced traced =
      trace_all(make_tracer, input.scene, cameras, writer, command.common, tells ? &report.cameras : nullptr);
  report.exit_code = traced.failed == 0 ? done : some_failed;
  report.seconds = watch.seconds();
  publish(report, command.common);
  tell(counted(traced.cameras - traced.failed, "camera") + " traced to " + command.folder.string(),
       command.common.quiet);
  return report.exit_code;
}

}  // namespace

void add_trace_command(CLI::App& root, Run& run) {
  auto command = std::make_shared<TraceCommand>();
  CLI::App* sub = root.add_subcommand("trace", "Make the visibility map of every camera");
  sub->add_option("scene", command->input, "Polygon file, or .wp file of `sightline build`")
      ->required()
      ->type_name("SCENE|X.wp");
  sub->add_option("--cameras", command->cameras, "Cameras file; /dev/stdin: as they come, in constant memory")
      ->required()
      ->type_name("C");
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
