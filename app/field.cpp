// sightline field build SCENE -o X.field; sightline field query X.field --cameras C -o OUT.csv
#include "sample/field.hpp"

#include "app/describe.hpp"
#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "app/messages.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "sample/field_query.hpp"
#include "scene/read.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <glm/common.hpp>
#include <map>

namespace sightline::app {

namespace {

struct FieldBuildCommand {
  CommonOptions common;
  FieldOptions field;
  std::filesystem::path input, output, slabs;
  std::string samples = "16x16x32x32", cells = "object:16", objects, before;
  std::vector<double> view;
  double distance = 0;
};

/// "UxVxSxT"
std::array<std::uint32_t, 4> parse_samples(const std::string& text) {
  std::array<std::uint32_t, 4> samples{};
  std::istringstream words(text + "x");
  bool fine = true;
  for (std::uint32_t& n : samples) {
    std::string word;
    fine = fine && std::getline(words, word, 'x') && CLI::detail::lexical_cast(word, n) && n >= 1 && n <= 4096;
  }
  if (!fine || words.peek() != std::istringstream::traits_type::eof()) {
    throw UsageError("--samples " + text + ": wants UxVxSxT, each from 1 to 4096");
  }
  return samples;
}

CellName named_cells(const std::string& text) {
  try {
    return parse_cells(text);
  } catch (const std::invalid_argument& wanted) {
    throw UsageError("--cells " + text + ": wants " + wanted.what());
  }
}

FieldBox view_of(const FieldBuildCommand& command) {
  const auto& v = command.view;
  const FieldBox box{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  if (!glm::all(glm::lessThan(box.low, box.high))) throw UsageError("--view: a box has x0 < x1, y0 < y1 and z0 < z1");
  return box;
}

std::vector<FieldSlab> chosen_slabs(const FieldBuildCommand& command, const FieldBox& box) {
  if (!command.slabs.empty()) return read_slabs(command.slabs, box);
  if (!command.view.empty()) return slabs_within(view_of(command));
  if (command.before.empty()) return slabs_around(box, command.distance);
  const std::map<std::string, std::pair<int, bool>> sides{{"left", {0, false}},   {"right", {0, true}},
                                                          {"front", {1, false}},  {"back", {1, true}},
                                                          {"bottom", {2, false}}, {"top", {2, true}}};
  const auto side = sides.at(command.before);
  return {slab_before(box, side.first, side.second, 1)};
}

FieldCells chosen_cells(const FieldBuildCommand& command, const CellName& name, const Scene& scene,
                        const std::vector<FieldSlab>& slabs) {
  switch (name.kind) {
    case CellName::polygon:
      return cells_of_polygons(scene);
    case CellName::scene:
      return cells_of_scene(scene, name.setting);
    case CellName::octree:
      return cells_of_octree(scene, slabs, command.field.samples, name.setting);
    case CellName::object:
      break;
  }
  const bool names = command.objects.empty() ? !scene.soup().objects.empty() : command.objects == "named";
  const auto kind = names ? FieldObjects::named : FieldObjects::connected;
  return cells_of_objects(scene, field_objects(scene, kind), name.setting);
}

FieldFigures figures_of(const Field& field, std::uint64_t file_bytes) {
  return {field.slabs.size(),
          field.levels.front().lists.size(),
          field.ids,
          field.partition.count,
          field.list_count() - 1,
          field.levels.size() - 1,
          field_array_bytes(field),
          field_memory_bytes(field),
          file_bytes,
          0,
          0};
}

int build_field_file(FieldBuildCommand& command) {
  check(command.common);
  if (command.output.extension() != ".field") {
    throw UsageError("-o " + command.output.string() + ": must end in .field");
  }
  if (command.field.rays % 2 == 0) throw UsageError("--rays: an odd number, so that a ray runs through the middle");
  const int ways = (command.slabs.empty() ? 0 : 1) + (command.view.empty() ? 0 : 1) + (command.before.empty() ? 0 : 1) +
                   (command.distance > 0 ? 1 : 0);
  if (ways > 1) throw UsageError("--slabs, --view, --before and --distance: one of them at most");
  if (!command.view.empty()) view_of(command);  // or there is no need to read anything
  command.field.samples = parse_samples(command.samples);
  command.field.threads = command.common.threads;
  const CellName name = named_cells(command.cells);
  const Stopwatch watch;
  const Scene scene = read_input(command.input, command.common).scene;
  tell(describe(scene), command.common.quiet);
  const std::vector<FieldSlab> slabs = chosen_slabs(command, box_of(scene));
  const FieldCells cells = chosen_cells(command, name, scene, slabs);
  Field field;
  FieldStats stats;
  {
    Progress progress("sampling", field_steps(slabs, command.field), command.common.quiet);
    field = build_field(
        scene, slabs, cells, command.field, [&] { progress.step(); }, &stats);
  }
  field.cells = command.cells;
  const std::string bytes = field_bytes(field);
  write_text(command.output, bytes);
  FieldFigures figures = figures_of(field, bytes.size());
  figures.rays = stats.rays;
  figures.seconds = stats.seconds;
  Report report{"field build", scene, {}, {}, watch.seconds(), done};
  report.field = figures;
  publish(report, command.common);
  tell(command.output.string() + ": " + counted(figures.slabs, "slab") + ", " + counted(figures.samples, "sample") +
           ", " + counted(figures.cells, "cell") + ", " + counted(figures.lists, "different list") + "; " +
           counted(figures.file_bytes, "byte") + ", as an array " + std::to_string(figures.array_bytes),
       command.common.quiet);
  return done;
}

struct FieldQueryCommand {
  CommonOptions common;
  FieldQueryOptions query;
  std::filesystem::path input, cameras, output, scene;
  std::string filter = "none";
};

/// A view's marks and what they took.
struct View {
  FieldMarks marks;
  double seconds = 0;
};

std::vector<View> looked_up(const FieldQueryCommand& command, const Field& field, const std::vector<Camera>& cameras,
                            Progress& progress) {
  std::vector<View> views(cameras.size());
  tbb::enumerable_thread_specific<FieldQuery> queries([&] { return FieldQuery(field, command.query); });
  const auto view = [&](std::size_t k, FieldQuery& query) {
    const Stopwatch watch;
    views[k].marks = query.mark(cameras[k]);
    views[k].seconds = watch.seconds();
    progress.step();
  };
  if (command.query.keep > 0) {  // each view needs those before it
    for (std::size_t k = 0; k < cameras.size(); ++k) view(k, queries.local());
    return views;
  }
  tbb::task_arena arena(static_cast<int>(command.common.threads));
  arena.execute(
      [&] { tbb::parallel_for(std::size_t{0}, cameras.size(), [&](std::size_t k) { view(k, queries.local()); }); });
  return views;
}

std::vector<View> traced(const FieldQueryCommand& command, const Field& field, const Scene& scene,
                         const std::vector<Camera>& cameras, Progress& progress) {
  const RayCaster caster(scene);
  std::vector<View> views(cameras.size());
  tbb::task_arena arena(static_cast<int>(command.common.threads));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, cameras.size(), [&](std::size_t k) {
      const Stopwatch watch;
      views[k].marks =
          trace_marks(caster, scene, field.partition, cameras[k], command.query.pixels, command.query.subsample);
      views[k].seconds = watch.seconds();
      progress.step();
    });
  });
  return views;
}

int query_field(FieldQueryCommand& command) {
  check(command.common);
  const std::map<std::string, FieldFilter> filters{
      {"none", FieldFilter::nearest}, {"uv", FieldFilter::uv}, {"st", FieldFilter::st}, {"uv+st", FieldFilter::uvst}};
  command.query.filter = filters.at(command.filter);
  if (command.query.subsample > command.query.pixels) throw UsageError("--subsample: at most as many as --pixels");
  if (command.scene.empty() && (!command.common.snap.empty() || command.common.one_sided)) {
    throw UsageError("--snap and --one-sided belong to `sightline field build`, here only to the scene of --trace");
  }
  const Stopwatch watch;
  const std::vector<Camera> cameras = read_cameras(command.cameras);
  const Field field = read_field(command.input);
  Report report{"field query", {}, {}, {}, 0, done};
  report.field = figures_of(field, std::filesystem::file_size(command.input));
  std::vector<View> views;
  {
    Progress progress("looking up", cameras.size(), command.common.quiet);
    if (command.scene.empty()) {
      views = looked_up(command, field, cameras, progress);
    } else {
      const Scene scene = read_input(command.scene, command.common).scene;
      if (scene.polygon_count() != field.partition.of.size()) {
        throw InputError(command.input.string() + ": is of a scene of " +
                         counted(field.partition.of.size(), "polygon") + ", not of " + command.scene.string());
      }
      views = traced(command, field, scene, cameras, progress);
    }
  }
  std::string csv = "camera,cell,polygon\n";
  for (std::size_t k = 0; k < views.size(); ++k) {
    const FieldMarks& marks = views[k].marks;
    const std::vector<PolygonId> polygons = polygons_of(field.partition, marks.cells);
    for (const PolygonId p : polygons) {
      csv += std::to_string(k) + "," + std::to_string(field.partition.of[p]) + "," + std::to_string(p) + "\n";
    }
    report.field_views.push_back({views[k].seconds, marks.cells.size(), polygons.size(), marks.looked_up,
                                  static_cast<double>(marks.covered) / static_cast<double>(marks.pixels)});
  }
  write_text(command.output, csv);
  report.seconds = watch.seconds();
  publish(report, command.common);
  tell(command.output.string() + ": " + counted(views.size(), "camera"), command.common.quiet);
  return done;
}

void add_build(CLI::App& field, Run& run) {
  auto command = std::make_shared<FieldBuildCommand>();
  CLI::App* sub = field.add_subcommand("build", "Sample a scene's visibility along the lines of two planes");
  sub->add_option("scene", command->input, "Polygon file, or .wp file of `sightline build`")
      ->required()
      ->type_name("SCENE|X.wp");
  sub->add_option("-o,--output", command->output, "Field file to write")->required()->type_name("X.field");
  sub->add_option("--samples", command->samples, "Samples along u, v, s and t in each slab")
      ->type_name("UxVxSxT")
      ->capture_default_str();
  sub->add_option("--ids", command->field.ids, "Cells that a sample holds at most")
      ->check(CLI::Range(1, 65535))
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--rays", command->field.rays, "Rays of a sample along each axis: 3 for 81 in all, 1 for its middle")
      ->check(CLI::Range(1, 9))
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--cells", command->cells,
                  "polygon, object:N, scene:N (cells along a side) or octree:N (samples a cell)")
      ->type_name("KIND")
      ->capture_default_str();
  sub->add_option("--objects", command->objects, "named or connected (default: named where the file has names)")
      ->check(CLI::IsMember({"named", "connected"}))
      ->type_name("KIND");
  sub->add_option("--slabs", command->slabs, "Slabs from a file (default: six around the scene, uv at infinity)")
      ->type_name("FILE");
  sub->add_option("--view", command->view, "Six slabs for viewers in this box: x0 y0 z0 x1 y1 z1")
      ->expected(6)
      ->type_name("X");
  sub->add_option("--before", command->before,
                  "One slab for viewers on this side: left, right, front, back, bottom, top")
      ->check(CLI::IsMember({"left", "right", "front", "back", "bottom", "top"}))
      ->type_name("SIDE");
  sub->add_option("--distance", command->distance,
                  "Six slabs around the scene with uv so many of its longest sides away, not at infinity")
      ->check(CLI::Range(0.01, 1e6))
      ->type_name("D");
  sub->add_flag("--mipmap", command->field.mipmap, "Also levels of fewer samples, for viewers far away");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return build_field_file(*command); }; });
}

void add_query(CLI::App& field, Run& run) {
  auto command = std::make_shared<FieldQueryCommand>();
  CLI::App* sub = field.add_subcommand("query", "Look up which cells cameras see");
  sub->add_option("field", command->input, "Field file of `sightline field build`")->required()->type_name("X.field");
  sub->add_option("--cameras", command->cameras, "Cameras file")->required()->type_name("C");
  sub->add_option("-o,--output", command->output, "CSV file to write: camera,cell,polygon")
      ->required()
      ->type_name("OUT.csv");
  sub->add_option("--pixels", command->query.pixels, "Pixels along both sides of the window")
      ->check(CLI::Range(1, 16384))
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--subsample", command->query.subsample, "Look up every so-manieth pixel of every so-manieth row")
      ->check(CLI::Range(1, 16384))
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--filter", command->filter, "Neighbouring samples looked up as well: none, uv, st or uv+st")
      ->check(CLI::IsMember({"none", "uv", "st", "uv+st"}))
      ->type_name("NAME")
      ->capture_default_str();
  sub->add_flag("--mipmap", command->query.mipmap,
                "Look up coarser samples where pixels are farther apart than samples");
  sub->add_option("--keep", command->query.keep, "Cells of so many cameras before stay marked")
      ->check(CLI::Range(0, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--trace", command->scene, "Trace rays through this scene, the field's own, in place of looking up")
      ->type_name("SCENE");
  add_common_options(*sub, command->common);
  sub->callback([command, &run] { run = [command] { return query_field(*command); }; });
}

}  // namespace

void add_field_command(CLI::App& root, Run& run) {
  CLI::App* field = root.add_subcommand("field", "Visibility fields: sampled, approximate visibility");
  field->require_subcommand(1);
  add_build(*field, run);
  add_query(*field, run);
}

}  // namespace sightline::app
