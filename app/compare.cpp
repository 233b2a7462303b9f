// sightline compare SCENE --cameras C --methods LIST -o DIR
#include "compare/compare.hpp"

#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "compare/report.hpp"
#include "scene/read.hpp"

#include <CLI/CLI.hpp>

namespace sightline::app {

namespace {

struct CompareCommand {
  CommonOptions common;
  std::filesystem::path input, cameras, folder;
  std::string methods;
};

std::vector<comparison::MethodName> named(const std::string& list) {
  try {
    return comparison::parse_methods(list);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--methods: ") + error.what());
  }
}

int compare_methods(CompareCommand& command) {
  check(command.common);
  const std::vector<comparison::MethodName> methods = named(command.methods);
  const Stopwatch watch;
  const std::vector<Camera> cameras = read_cameras(command.cameras);
  const Input input = read_input(command.input, command.common);
  make_folder(command.folder);
  tell(describe(input.scene), command.common.quiet);

  std::vector<comparison::MethodResult> results;
  {
    Progress progress("comparing", cameras.size(), command.common.quiet);
    results = comparison::compare_methods(input.scene, cameras, methods, [&] { progress.step(); });
  }
  write_text(command.folder / "compare.json", comparison::json(results, cameras.size()));
  write_text(command.folder / "compare.csv", comparison::csv(results));
  const std::filesystem::path picture = command.folder / "compare";
  const std::string title = command.input.filename().string() + ": " + counted(input.scene.polygon_count(), "polygon") +
                            ", " + counted(cameras.size(), "camera");
  write_safely(picture, [&] { comparison::write_picture(picture, results, title); });
  if (!command.common.quiet && !command.common.json) print_result(comparison::table(results));
  Report report{"compare", input.scene, {}, {}, watch.seconds(), done};
  publish(report, command.common);
  return done;
}

}  // namespace

void add_compare_command(CLI::App& root, Run& run) {
  auto command = std::make_shared<CompareCommand>();
  CLI::App* sub = root.add_subcommand("compare", "Run time against error: methods beside the exact map");
  sub->add_option("scene", command->input, "Polygon file, or .wp file of `sightline build`")
      ->required()
      ->type_name("SCENE|X.wp");
  sub->add_option("--cameras", command->cameras, "Cameras file")->required()->type_name("C");
  sub->add_option("--methods", command->methods, "Names with commas between them: " + comparison::known_methods())
      ->required()
      ->type_name("LIST");
  sub->add_option("-o,--output", command->folder, "Folder for compare.json, .csv, .svg and .png; made if missing")
      ->required()
      ->type_name("DIR");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return compare_methods(*command); }; });
}

}  // namespace sightline::app
