// sightline clip SCENE --cameras C -o OUT.ply
#include "clip/clip.hpp"

#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/photos.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "clip/files.hpp"
#include "clip/picture.hpp"
#include "scene/read.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <optional>

namespace sightline::app {

namespace {

struct ClipCommand {
  CommonOptions common;
  ClipOptions clip;
  std::filesystem::path input, cameras, regions, output, csv, pictures, views;
  bool t_free = false;
  PhotoCommand photos;
};

/// DIR/0000.svg and DIR/0000.png, one pair a view.
void write_pictures(const ClipCommand& command, const Scene& scene, const std::vector<Camera>& cameras,
                    const std::vector<Camera>& views) {
  make_folder(command.pictures);
  const std::vector<CountPicture> pictures = count_pictures(scene, cameras, views, command.clip);
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    write_text(numbered(command.pictures, k, ".svg"), count_svg(pictures[k], scene));
    const std::filesystem::path png = numbered(command.pictures, k, ".png");
    write_safely(png, [&] { write_count_png(png, pictures[k], scene); });
  }
}

int clip_scene(ClipCommand& command) {
  check(command.common);
  if (command.output.extension() != ".ply") throw UsageError("-o " + command.output.string() + ": must end in .ply");
  if (!(command.clip.threshold >= 0) || !std::isfinite(command.clip.threshold))
    throw UsageError("--threshold: must be an area, 0 or more");
  if (!command.csv.empty() && !command.regions.empty())
    throw UsageError("--csv: tells what is seen in whole windows, so not with --regions");
  if (!command.views.empty() && command.pictures.empty()) throw UsageError("--views: only with --pictures");
  const Stopwatch watch;
  const std::vector<Camera> cameras = read_cameras(command.cameras);
  const std::vector<Camera> views = command.views.empty() ? cameras : read_cameras(command.views);
  if (!command.photos.folder.empty()) check_textured(command.output, command.input);
  std::vector<Image> images = read_photos(command.photos, cameras);
  if (!command.regions.empty()) command.clip.regions = read_regions(command.regions, cameras.size());
  const Input input = read_input(command.input, command.common);
  tell(describe(input.scene), command.common.quiet);
  command.clip.threads = command.common.threads;
  const ClipResult result = clip(input.scene, cameras, command.clip);
  std::optional<TFreePieces> joined;
  if (command.t_free) joined = t_free(input.scene, cameras, command.clip, result);
  write_text(command.output, clip_ply(input.scene, result, command.clip.threshold > 0, joined ? &*joined : nullptr));
  if (!command.csv.empty()) write_text(command.csv, clip_csv(input.scene, cameras, command.clip));
  if (!command.pictures.empty()) write_pictures(command, input.scene, cameras, views);

  ClipFigures figures{result.pieces.size(),        0,
                      result.stats.cuts,           result.stats.buffer_proofs,
                      result.stats.buffer_seconds, result.stats.clip_seconds};
  figures.seen = static_cast<std::size_t>(
      std::count_if(result.pieces.begin(), result.pieces.end(), [](const ClipPiece& p) { return p.camera_count > 0; }));
  std::optional<PhotoFigures> photos;
  if (!images.empty()) {
    photos =
        write_textured(command.photos, std::move(images), input.scene, cameras, command.clip, result, command.output);
  }
  Report report{"clip", input.scene, {}, {}, watch.seconds(), done, figures, photos};
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
  sub->add_flag("--sampling", command->clip.sampling,
                "Look polygons up in the buffer by samples, not by scan conversion; changes no result");
  sub->add_flag("--t-free", command->t_free, "Without T-junctions: pieces get the corners of others on their sides");
  sub->add_option("--csv", command->csv, "Also write what each camera sees of each polygon, as `trace` does")
      ->type_name("FILE");
  sub->add_option("--pictures", command->pictures,
                  "Folder for pictures: pieces coloured by the number of cameras that see them")
      ->type_name("DIR");
  sub->add_option("--views", command->views, "Cameras file: from where the pictures are (default: from the cameras)")
      ->type_name("V");
  add_photo_options(*sub, command->photos);
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return clip_scene(*command); }; });
}

}  // namespace sightline::app
