// sightline clip SCENE --cameras C -o OUT.ply
#include "clip/clip.hpp"

#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "clip/files.hpp"
#include "scene/read.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

namespace sightline::app {

namespace {

struct ClipCommand {
  CommonOptions common;
  ClipOptions clip;
  std::filesystem::path input, cameras, regions, output;
};

int clip_scene(ClipCommand& command) {
  check(command.common);
  if (command.output.extension() != ".ply") throw UsageError("-o " + command.output.string() + ": must end in .ply");
  if (!(command.clip.threshold >= 0) || !std::isfinite(command.clip.threshold))
    throw UsageError("--threshold: must be an area, 0 or more");
  const Stopwatch watch;
  const std::vector<Camera> cameras = read_cameras(command.cameras);
  if (!command.regions.empty()) command.clip.regions = read_regions(command.regions, cameras.size());
  const Input input = read_input(command.input, command.common);
  tell(describe(input.scene), command.common.quiet);
  command.clip.threads = command.common.threads;
  const ClipResult result = clip(input.scene, cameras, command.clip);
  write_text(command.output, clip_ply(input.scene, result, command.clip.threshold > 0));

  ClipFigures figures{result.pieces.size(),        0,
                      result.stats.cuts,           result.stats.buffer_proofs,
                      result.stats.buffer_seconds, result.stats.clip_seconds};
  figures.seen = static_cast<std::size_t>(
      std::count_if(result.pieces.begin(), result.pieces.end(), [](const ClipPiece& p) { return p.camera_count > 0; }));
  Report report{"clip", input.scene, {}, {}, watch.seconds(), done, figures};
  publish(report, command.common);
  tell(command.output.string() + ": " + counted(figures.pieces, "piece") + ", " + std::to_string(figures.seen) +
           " of them seen by " + counted(cameras.size(), "camera"),
       command.common.quiet);
  return done;
}

}  // namespace

void add_clip_command(CLI::App& root, Run& run) {
  auto command = std::make_shared<ClipCommand>();
  CLI::App* sub =
      root.add_subcommand("clip", "Cut polygons so that every piece is wholly visible or hidden from each camera");
  sub->add_option("scene", command->input, "Polygon file, or .wp file of `sightline build`")
      ->required()
      ->type_name("SCENE|X.wp");
  sub->add_option("--cameras", command->cameras, "Cameras file")->required()->type_name("C");
  sub->add_option("-o,--output", command->output, "PLY file to write")->required()->type_name("OUT.ply");
  sub->add_option("--threshold", command->clip.threshold, "Do not cut what is smaller than this area, in scene units")
      ->type_name("A");
  sub->add_option("--regions", command->regions, "Regions of the photographs to use: CAMERA interior|exterior s t ..")
      ->type_name("FILE");
  sub->add_option("--buffer", command->clip.buffer, "Pixels a side of the buffer (default: chosen); changes no result")
      ->check(CLI::Range(1, 8192))
      ->type_name("N");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return clip_scene(*command); }; });
}

}  // namespace sightline::app
