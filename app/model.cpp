// sightline model NAME -o X.obj
#include "models/model.hpp"

#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "scene/read.hpp"

#include <CLI/CLI.hpp>

namespace sightline::app {

namespace {

struct ModelCommand {
  CommonOptions common;
  ModelOptions model;
  std::string name;
  std::filesystem::path output;
};

Model made_model(const ModelCommand& command) {
  try {
    return make_model(command.name, command.model);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

int write_model(ModelCommand& command) {
  check(command.common);
  if (command.output.extension() != ".obj") throw UsageError("-o " + command.output.string() + ": must end in .obj");
  const Stopwatch watch;
  Model model = made_model(command);
  model.soup.source = command.output.filename().string();
  const std::filesystem::path cameras = std::filesystem::path(command.output).replace_extension(".cameras");
  write_safely(command.output, [&] { write_obj(command.output, model.soup); });
  write_safely(cameras, [&] { write_cameras(cameras, model.cameras); });
  tell(command.output.string() + ": " + counted(model.soup.first.size() - 1, "polygon") + "; " + cameras.string() +
           ": " + counted(model.cameras.size(), "camera"),
       command.common.quiet);
  if (command.common.json || !command.common.report.empty()) {
    Report report{"model", make_scene(std::move(model.soup)), {}, {}, watch.seconds(), done};
    publish(report, command.common);
  }
  return done;
}

std::string names() {
  std::string text;
  for (const std::string& name : model_names()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

void add_model_command(CLI::App& root, Run& run) {
  auto command = std::make_shared<ModelCommand>();
  CLI::App* sub = root.add_subcommand("model", "Make a test model, X.obj, and its cameras, X.cameras");
  sub->add_option("name", command->name, "Model: " + names())->required()->type_name("NAME");
  sub->add_option("--polygons", command->model.polygons, "Wanted number of polygons (default: as in the papers)")
      ->check(CLI::Range(1u, 100'000'000u))
      ->type_name("N");
  sub->add_option("--seed", command->model.seed, "Seed of what is random in it")->type_name("S")->capture_default_str();
  sub->add_option("--rotate", command->model.rotate_degrees, "Rotate by so many degrees, in rounded doubles")
      ->type_name("DEG");
  sub->add_option("-o,--output", command->output, "OBJ file to write")->required()->type_name("X.obj");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return write_model(*command); }; });
}

}  // namespace sightline::app
