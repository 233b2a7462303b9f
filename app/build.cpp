// sightline build SCENE -o X.wp
#include "bsp/build.hpp"

#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "winged_pair/file.hpp"

#include <CLI/CLI.hpp>

namespace sightline::app {

namespace {

struct BuildCommand {
  CommonOptions common;
  std::filesystem::path scene, output;
};

int build_scene(BuildCommand& command) {
  check(command.common);
  if (command.output.extension() != ".wp") throw UsageError("-o " + command.output.string() + ": must end in .wp");
  if (command.scene.extension() == ".wp") throw UsageError(command.scene.string() + ": is already built");
  const Stopwatch watch;
  Report report{"build", {}, {}, {}, 0, done};
  const Scene scene = read_input(command.scene, command.common).scene;
  tell(describe(scene), command.common.quiet);
  BuildStats stats;
  const Complex complex = build(scene, {}, &stats);
  report.complex = figures_of(complex);
  report.complex->seconds = stats.seconds;
  tell(describe(*report.complex), command.common.quiet);
  write_safely(command.output, [&] { write_wp(command.output, scene, complex); });
  report.scene = scene;
  report.seconds = watch.seconds();
  publish(report, command.common);
  return done;
}

}  // namespace

void add_build_command(CLI::App& root, Run& run) {
  auto command = std::make_shared<BuildCommand>();
  CLI::App* sub = root.add_subcommand("build", "Cut a scene into convex cells");
  sub->add_option("scene", command->scene, "Polygon file: .obj, .ply, .off or .stl")->required()->type_name("SCENE");
  sub->add_option("-o,--output", command->output, "Winged-pair file to write")->required()->type_name("X.wp");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return build_scene(*command); }; });
}

}  // namespace sightline::app
