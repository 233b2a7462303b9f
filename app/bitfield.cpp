// sightline bitfield build|query
#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "sample/bitfield_connect.hpp"
#include "sample/bitfield_file.hpp"
#include "sample/bitfield_transparent.hpp"
#include "sample/bitfield_viewer.hpp"
#include "sample/bitfield_viewpoints.hpp"
#include "scene/read.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <sstream>

namespace sightline::app {

namespace {

struct BitfieldBuildCommand {
  CommonOptions common;
  BitfieldSampling sampling;
  std::filesystem::path input, output, cameras, viewpoints, transparent_list;
  std::string transparent, fill = "0";
  unsigned samples = 25;
  double angle = 45;
};

struct BitfieldQueryCommand {
  CommonOptions common;
  BitfieldViewing viewing;
  std::filesystem::path input, cameras, output, scene;
  std::string form = "lists";
};

const std::map<std::string, BitfieldViewing::Form> forms{{"lists", BitfieldViewing::lists},
                                                         {"plain", BitfieldViewing::plain},
                                                         {"hierarchical", BitfieldViewing::hierarchical},
                                                         {"compressed", BitfieldViewing::compressed}};

std::vector<PolygonId> transparent_polygons(const BitfieldBuildCommand& command, const Scene& scene) {
  std::vector<std::string> names;
  std::istringstream list(command.transparent);
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  std::vector<PolygonId> named, listed, all;
  if (!names.empty()) named = polygons_named(scene, command.input, names);
  if (!command.transparent_list.empty()) listed = read_polygon_list(command.transparent_list, scene.polygon_count());
  std::ranges::set_union(named, listed, std::back_inserter(all));
  return all;
}

/// The user's cameras, or those of a sphere, which are written where the user wants to see them.
std::vector<Camera> viewpoints(const BitfieldBuildCommand& command, const Scene& scene) {
  if (!command.cameras.empty()) return read_cameras(command.cameras);
  std::vector<CameraLine> lines;
  try {
    lines = sphere_cameras(scene, command.samples, command.angle);
  } catch (const std::invalid_argument& error) {
    throw InputError(command.input.string() + ": " + error.what());
  }
  std::vector<Camera> cameras;
  for (const CameraLine& c : lines) {
    cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  if (!command.viewpoints.empty()) {
    write_safely(command.viewpoints, [&] { write_cameras(command.viewpoints, lines); });
  }
  return cameras;
}

unsigned fill_rounds(const std::string& text) {
  if (text == "all") return all_rounds;
  unsigned rounds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rounds);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw UsageError("--fill " + text + ": a number of rounds, or all");
  }
  return rounds;
}

/// Room that the fields take in their forms.
BitfieldFigures figures_of(const BitfieldSamples& samples, std::size_t file_bytes) {
  BitfieldFigures f;
  f.samples = samples.cameras.size();
  f.exact = samples.exact;
  f.pixels = samples.pixels;
  f.file_bytes = file_bytes;
  for (const IdBitfield& field : samples.fields) {
    f.plain_bytes += field.bytes();
    f.hierarchical_bytes += HierarchicalBitfield(field).bytes();
    f.compressed_bytes += CompressedBitfield(field).bytes();
    f.bits = field.size();
  }
  return f;
}

int build_bitfield(BitfieldBuildCommand& command) {
  check(command.common);
  command.sampling.fill_rounds = fill_rounds(command.fill);
  const Stopwatch watch;
  const Input input = read_input(command.input, command.common);
  tell(describe(input.scene), command.common.quiet);
  command.sampling.transparent = transparent_polygons(command, input.scene);
  const std::vector<Camera> cameras = viewpoints(command, input.scene);
  if (cameras.size() > most_viewpoints) {
    throw InputError(command.cameras.string() + ": more than " + std::to_string(most_viewpoints) + " cameras");
  }
  try {  // before any work
    std::vector<ViewDirection> directions;
    for (const Camera& c : cameras) directions.push_back(view_direction(c.eye - viewing_centre(input.scene)));
    const ViewHull hull(std::move(directions));
  } catch (const std::invalid_argument& error) {
    throw InputError((command.cameras.empty() ? command.input : command.cameras).string() + ": " + error.what());
  }
  command.sampling.threads = command.common.threads;
  const Stopwatch sampling;
  BitfieldSamples samples;
  {
    Progress progress("sampling", cameras.size(), command.common.quiet);
    command.sampling.step = [&] { progress.step(); };
    samples = sample_bitfields(input.scene, cameras, command.sampling);
  }
  const double seconds = sampling.seconds();
  const std::string text = bitfield_text(samples);
  write_text(command.output, text);

  BitfieldFigures figures = figures_of(samples, text.size());
  figures.seconds = seconds;
  figures.transparent = command.sampling.transparent.size();
  const BitfieldViewer viewer(std::move(samples), {6, BitfieldViewing::lists, command.common.threads}, &input.scene);
  figures.faces = viewer.hull().faces().size();
  figures.mean_list = viewer.mean_list();
  figures.list_bytes = viewer.bytes();
  Report report{"bitfield build", input.scene, {}, {}, watch.seconds(), done};
  report.bitfield = figures;
  publish(report, command.common);
  tell(command.output.string() + ": " + counted(figures.samples, "sample") + ", lists of " +
           std::to_string(static_cast<std::size_t>(figures.mean_list)) + " polygons on the average",
       command.common.quiet);
  return done;
}

int query_bitfield(BitfieldQueryCommand& command) {
  check(command.common);
  command.viewing.form = forms.at(command.form);
  command.viewing.threads = command.common.threads;
  if (command.viewing.neighbours == 1 && command.viewing.form == BitfieldViewing::lists) {
    throw UsageError(
        "--neighbours 1: which is the nearest sample is not known beforehand, so only without --form lists");
  }
  const Stopwatch watch;
  const std::vector<Camera> cameras = read_cameras(command.cameras);
  BitfieldSamples samples = read_bitfield(command.input);
  std::optional<Scene> scene;
  if (!command.scene.empty()) scene = read_input(command.scene, command.common).scene;
  if (!scene && samples.patch > 0) throw UsageError("--scene: needed, for the polygons of the patches in the file");
  if (scene && !samples_of(samples, *scene)) {
    throw InputError(command.input.string() + ": samples of another scene than " + command.scene.string() +
                     ", or of other options");
  }
  BitfieldFigures figures = figures_of(samples, std::filesystem::file_size(command.input));
  const Stopwatch preparing;
  std::optional<BitfieldViewer> viewer;
  try {
    viewer.emplace(std::move(samples), command.viewing, scene ? &*scene : nullptr);
  } catch (const std::invalid_argument& error) {
    throw InputError(command.input.string() + ": " + error.what());
  }
  figures.seconds = preparing.seconds();
  figures.faces = viewer->hull().faces().size();
  if (command.viewing.form == BitfieldViewing::lists) {
    figures.mean_list = viewer->mean_list();
    figures.list_bytes = viewer->bytes();
  }

  Report report{"bitfield query", scene, {}, {}, 0, done};
  std::string csv = "camera,polygon\n";
  {
    Progress progress("asking", cameras.size(), command.common.quiet);
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      const Stopwatch asking;
      const BitfieldViewer::View& view = viewer->look(cameras[k]);
      report.bitfield_views.push_back({asking.seconds(), view.face, view.samples, view.polygons.size()});
      const std::string camera = std::to_string(k) + ',';
      for (const PolygonId p : view.polygons) csv.append(camera).append(std::to_string(p)) += '\n';
      progress.step();
    }
  }
  write_text(command.output, csv);
  report.bitfield = figures;
  report.seconds = watch.seconds();
  publish(report, command.common);
  tell(command.output.string() + ": " + counted(cameras.size(), "camera"), command.common.quiet);
  return done;
}

void add_bitfield_build(CLI::App& bitfield, Run& run) {
  auto command = std::make_shared<BitfieldBuildCommand>();
  CLI::App* sub = bitfield.add_subcommand("build", "Sample which polygons are seen from around a scene");
  sub->add_option("scene", command->input, "Polygon file, or .wp file of `sightline build`")
      ->required()
      ->type_name("SCENE|X.wp");
  sub->add_option("-o,--output", command->output, "Bitfield file to write")->required()->type_name("X.bitfield");
  CLI::Option* samples = sub->add_option("--samples", command->samples, "Samples on a sphere around the scene")
                             ->check(CLI::Range(least_viewpoints, most_viewpoints))
                             ->type_name("N")
                             ->capture_default_str();
  CLI::Option* cameras =
      sub->add_option("--cameras", command->cameras, "Samples from these cameras, which surround the scene's middle")
          ->type_name("C")
          ->excludes(samples);
  sub->add_option("--angle", command->angle, "How high the windows of samples on the sphere are, in degrees")
      ->check(CLI::Range(1.0, 150.0))
      ->type_name("A")
      ->capture_default_str()
      ->excludes(cameras);
  sub->add_option("--viewpoints", command->viewpoints, "Also write the cameras on the sphere")
      ->type_name("OUT.cameras")
      ->excludes(cameras);
  CLI::Option* exact = sub->add_flag("--exact", command->sampling.exact, "By exact maps, which miss no polygon");
  sub->add_option("--pixels", command->sampling.pixels, "Pixels along both sides of the ID buffers")
      ->check(CLI::Range(1, 16384))
      ->type_name("N")
      ->capture_default_str()
      ->excludes(exact);
  sub->add_option("--fill", command->fill,
                  "Rounds in which neighbours of seen polygons that face the viewpoint count as seen, too; or all")
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--transparent", command->transparent,
                  "Names of objects (o, g) and OBJ materials, with commas between them: they hide nothing and are "
                  "always shown")
      ->type_name("NAMES");
  sub->add_option("--transparent-list", command->transparent_list, "The same by indices of polygons, from a file")
      ->type_name("FILE");
  sub->add_option("--patch", command->sampling.patch, "One bit for at most so many polygons that lie together")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return build_bitfield(*command); }; });
}

void add_bitfield_query(CLI::App& bitfield, Run& run) {
  auto command = std::make_shared<BitfieldQueryCommand>();
  CLI::App* sub = bitfield.add_subcommand("query", "Which polygons to render for cameras");
  sub->add_option("bitfield", command->input, "Bitfield file of `sightline bitfield build`")
      ->required()
      ->type_name("X.bitfield");
  sub->add_option("--cameras", command->cameras, "Cameras file")->required()->type_name("C");
  sub->add_option("-o,--output", command->output, "CSV file to write: camera,polygon")
      ->required()
      ->type_name("OUT.csv");
  sub->add_option("--scene", command->scene, "The scene that was sampled: it must be; needed for patches")
      ->type_name("SCENE");
  sub->add_option("--neighbours", command->viewing.neighbours, "Samples around a viewer that are joined: 1, 3 or 6")
      ->check(CLI::IsMember({1, 3, 6}))
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--form", command->form,
                  "lists (made beforehand), or fields joined for every camera: plain, hierarchical or compressed")
      ->check(CLI::IsMember(forms))
      ->type_name("FORM")
      ->capture_default_str();
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return query_bitfield(*command); }; });
}

}  // namespace

void add_bitfield_command(CLI::App& root, Run& run) {
  CLI::App* bitfield = root.add_subcommand("bitfield", "ID bitfields: polygons seen from around a scene, approximated");
  bitfield->require_subcommand(1);
  add_bitfield_build(*bitfield, run);
  add_bitfield_query(*bitfield, run);
}

}  // namespace sightline::app
