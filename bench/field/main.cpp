// bench_field: figures 8 to 11 of Blais and Poulin and what they leave open, as tables, JSON and pictures.
#include "bench/cpu_seconds.hpp"
#include "bench/field/measure.hpp"
#include "bench/field/subjects.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::filesystem::path folder;
  std::string bunny, scene;
  std::size_t frames = 3;
  std::uint32_t pixels = 512;
  unsigned threads = 2;
  std::vector<std::string> subjects{"turtles", "cars", "bunny"};
  std::vector<std::string> further{"turtles"};  // those of them for which everything is measured, which takes longer
};

constexpr std::array<std::pair<const char*, FieldFilter>, 4> filters{
    {{"none", FieldFilter::nearest}, {"uv", FieldFilter::uv}, {"st", FieldFilter::st}, {"uv+st", FieldFilter::uvst}}};

/// A scene with what its tables and pictures need.
class Bench {
 public:
  Bench(const Options& options, Subject subject)
      : options_(options),
        name_(subject.name),
        samples_(subject.samples),
        cameras_(animation(subject.soup, options.frames)),
        scene_(make_scene(std::move(subject.soup))),
        stage_(scene_, made(cameras_), options.pixels),
        cells_(cells_near(scene_, subject.cells)),
        slabs_{slab_for(box_of(scene_), made(cameras_))} {
    json_ = {{"name", name_},
             {"polygons", scene_.polygon_count()},
             {"cells", cells_.count},
             {"samples", samples_},
             {"pixels", options.pixels},
             {"frames", options.frames},
             {"draw_all_seconds", stage_.draw_all()}};
    std::printf("\n%s: %u polygons, %u cells, drawing all of them %.1f ms a frame\n", name_.c_str(),
                scene_.polygon_count(), cells_.count, 1e3 * stage_.draw_all());
  }

  Json run() {
    heading();
    const bool everything = std::ranges::count(options_.further, name_) > 0;
    const std::vector<std::uint32_t> subsamples = everything ? std::vector{1u, 2u, 3u, 5u, 10u} : std::vector{2u};
    for (const std::uint32_t ids : everything ? std::vector{1u, 2u, 5u} : std::vector{1u}) {
      const Field field = built("cone of cells, ids " + std::to_string(ids), slabs_, cells_, ids, 3, false);
      for (const auto& [filter, kind] : filters) {
        for (const std::uint32_t subsample : subsamples) {
          FieldQueryOptions query{.pixels = options_.pixels, .subsample = subsample, .filter = kind};
          row({{"ids", ids}, {"filter", filter}, {"subsample", subsample}}, stage_.look_up(field, query), cells_);
        }
      }
    }
    const RayCaster caster(scene_);
    for (const std::uint32_t subsample : {1u, 2u, 3u, 5u, 10u}) {
      row({{"tracing", true}, {"subsample", subsample}}, stage_.trace(caster, cells_, subsample), cells_);
    }
    json_["tree_bytes"] = caster.bytes();
    std::printf("  Embree's tree: %zu bytes\n", caster.bytes());
    if (everything) further();
    json_["fields"] = fields_;
    json_["rows"] = rows_;
    return json_;
  }

 private:
  static std::vector<Camera> made(const std::vector<CameraLine>& lines) {
    std::vector<Camera> cameras;
    for (const CameraLine& c : lines) {
      cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    }
    return cameras;
  }

  Field built(const std::string& what, const std::vector<FieldSlab>& slabs, const FieldCells& cells, std::uint32_t ids,
              std::uint32_t rays, bool mipmap) {
    FieldStats stats;
    Field field = build_field(scene_, slabs, cells, {samples_, ids, rays, mipmap, options_.threads}, {}, &stats);
    const auto array = field_array_bytes(field), memory = field_memory_bytes(field);
    const std::size_t file = field_bytes(field).size();
    fields_.push_back({{"what", what},
                       {"seconds", stats.seconds},
                       {"rays", stats.rays},
                       {"lists", field.list_count()},
                       {"array_bytes", array},
                       {"memory_bytes", memory},
                       {"file_bytes", file},
                       {"compression", static_cast<double>(array) / static_cast<double>(file)}});
    std::printf("  field, %s: %llu bytes as an array, %llu in memory, %zu in the file (1 : %.1f)\n", what.c_str(),
                static_cast<unsigned long long>(array), static_cast<unsigned long long>(memory), file,
                static_cast<double>(array) / static_cast<double>(file));
    return field;
  }

  static void heading() {
    std::printf("%-44s %9s %7s %7s %9s %9s %8s %9s\n", "  marked by", "cells", "%", "tri. %", "look ms", "draw ms",
                "time %", "pixels %");
  }

  void row(Json what, const Frame& f, const FieldCells& cells) {
    std::string text;
    for (const auto& [key, value] : what.items()) text += (text.empty() ? "  " : ", ") + key + " " + value.dump();
    std::erase(text, '"');
    const double part = 100 * f.cells / cells.count, time = 100 * (f.look_up + f.draw) / stage_.draw_all();
    std::printf("%-44s %9.1f %7.1f %7.1f %9.2f %9.2f %8.1f %9.3f\n", text.c_str(), f.cells, part,
                100 * f.triangles / scene_.polygon_count(), 1e3 * f.look_up, 1e3 * f.draw, time, 100 * f.wrong);
    std::fflush(stdout);
    what.update({{"cells", f.cells},
                 {"cells_percent", part},
                 {"triangles_percent", 100 * f.triangles / scene_.polygon_count()},
                 {"look_up_seconds", f.look_up},
                 {"draw_seconds", f.draw},
                 {"time_percent", time},
                 {"wrong_pixels_percent", 100 * f.wrong}});
    rows_.push_back(what);
  }

  /// The three choices of what a sample holds, other cells, frames kept, planes not at infinity, and from far away.
  void further() {
    const FieldQueryOptions plain{.pixels = options_.pixels, .subsample = 2};
    const auto say = [&](const char* what, const Field& field, const FieldQueryOptions& query) {
      row({{"with", what}}, stage_.look_up(field, query), field.partition);
    };
    const FieldCells polygons = cells_of_polygons(scene_);
    say("polygons, 1 ray", built("polygons, 1 ray", slabs_, polygons, 1, 1, false), plain);
    say("polygons, all of 81 rays", built("polygons, all of 81 rays", slabs_, polygons, 81, 3, false), plain);
    say("cells, 1 ray", built("cells, 1 ray", slabs_, cells_, 1, 1, false), plain);
    const Field all = built("cone of cells, all of 81 rays", slabs_, cells_, 81, 3, false);
    say("cells, all of 81 rays", all, plain);
    const Field levels = built("with a mipmap", slabs_, cells_, 1, 3, true);
    FieldQueryOptions kept = plain;
    kept.keep = 3;
    say("1 id, 3 frames kept", levels, kept);
    const FieldCells octree = cells_of_octree(scene_, slabs_, samples_, 1);
    json_["octree_cells"] = octree.count;
    say("1 id, cells of an octree", built("cells of an octree", slabs_, octree, 1, 3, false), plain);
    const double along = std::cbrt(static_cast<double>(cells_.count)) * 2;
    const FieldCells grid = cells_of_scene(scene_, along);
    json_["scene_cells"] = grid.count;
    say("1 id, cells of the whole scene", built("cells of the whole scene", slabs_, grid, 1, 3, false), plain);
    std::printf("  cells of the octree: %u, of the grid over the scene: %u\n", octree.count, grid.count);
    if (name_ != "cars") {  // they would be two million samples
      const auto six = slabs_around(box_of(scene_), 1);
      say("1 id, six slabs, uv 1 size away", built("six slabs", six, cells_, 1, 3, false), plain);
    }
    std::vector<CameraLine> lines = cameras_;
    const FieldBox box = box_of(scene_);
    for (CameraLine& c : lines) c.eye = 0.5 * (box.low + box.high) + 12.0 * (c.eye - 0.5 * (box.low + box.high));
    Stage far(scene_, made(lines), options_.pixels);
    FieldQueryOptions mipmap = plain;
    mipmap.mipmap = true;
    row({{"with", "1 id, 12 times as far"}}, far.look_up(levels, plain), cells_);
    row({{"with", "the same, mipmap"}}, far.look_up(levels, mipmap), cells_);
  }

  const Options& options_;
  std::string name_;
  std::array<std::uint32_t, 4> samples_;
  std::vector<CameraLine> cameras_;
  Scene scene_;
  Stage stage_;
  FieldCells cells_;
  std::vector<FieldSlab> slabs_;
  Json json_, fields_ = Json::array(), rows_ = Json::array();
};

Subject subject_of(const std::string& name, const std::string& bunny_file) {
  return name == "turtles" ? turtles() : name == "cars" ? cars() : bunny(bunny_file);
}

/// For gnuplot: a block for each filter and number of ids, a line a subsample.
void draw(const Json& turtles, const std::filesystem::path& folder) {
  std::ofstream out(folder / "figure8.dat");
  for (const std::uint32_t ids : {1u, 2u, 5u}) {
    for (const auto& [filter, kind] : filters) {
      out << "\"" << filter << ", " << ids << (ids == 1 ? " id" : " ids") << "\"\n";
      for (const Json& r : turtles["rows"]) {
        if (!r.contains("ids") || r["ids"] != ids || r["filter"] != filter) continue;
        const double k = r["subsample"];
        out << k * k << ' ' << r["cells"] << ' ' << r["time_percent"] << ' ' << r["wrong_pixels_percent"] << '\n';
      }
      out << "\n\n";
    }
  }
  out << "\"tracing\"\n";
  for (const Json& r : turtles["rows"]) {
    if (!r.contains("tracing")) continue;
    const double k = r["subsample"];
    out << k * k << ' ' << r["cells"] << ' ' << r["time_percent"] << ' ' << r["wrong_pixels_percent"] << '\n';
  }
  out.close();
  const std::string command =
      "gnuplot -e \"folder='" + folder.string() + "'\" '" SIGHTLINE_FIELD_SCRIPTS "/figure8.gp'";
  if (std::system(command.c_str()) != 0) {
    std::fprintf(stderr, "field: no picture without gnuplot (Debian: gnuplot-nox); the command was: %s\n",
                 command.c_str());
  }
}

void write_scene(const Options& options) {
  const std::filesystem::path file = options.folder / (options.scene + ".obj");
  const Subject subject = subject_of(options.scene, options.bunny);
  write_obj(file, subject.soup);
  const auto cameras = animation(subject.soup, options.frames);
  write_cameras(std::filesystem::path(file).replace_extension(".cameras"), cameras);
}

int run(int argc, char** argv) {
  CLI::App app("Visibility fields: figures 8 to 11 of Blais and Poulin");
  Options options;
  app.add_option("-o,--output", options.folder, "Folder for figures.json and pictures")->required()->type_name("DIR");
  app.add_option("--subjects", options.subjects, "turtles, cars, bunny")
      ->delimiter(',')
      ->check(CLI::IsMember({"turtles", "cars", "bunny"}));
  app.add_option("--further", options.further, "Subjects with all subsamples and ids, and other kinds of samples")
      ->delimiter(',')
      ->check(CLI::IsMember({"turtles", "cars", "bunny"}))
      ->capture_default_str();
  app.add_option("--bunny", options.bunny, "Polygon file in place of the ball with dents")->type_name("FILE");
  app.add_option("--frames", options.frames, "Frames of the animation")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--pixels", options.pixels, "Pixels along the pictures' sides")
      ->check(CLI::Range(16, 4096))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "Threads that make fields")->check(CLI::Range(1, 1024));
  app.add_option("--scene", options.scene, "Only write this scene, DIR/NAME.obj and .cameras")
      ->check(CLI::IsMember({"turtles", "cars", "bunny"}));
  CLI11_PARSE(app, argc, argv);
  std::filesystem::create_directories(options.folder);
  if (!options.scene.empty()) {
    write_scene(options);
    return 0;
  }
  Json all = Json::array();
  for (const std::string& name : options.subjects) {
    all.push_back(Bench(options, subject_of(name, options.bunny)).run());
    write_file(options.folder / "figures.json", all.dump(1) + "\n");  // after each: the next may not come to its end
    if (name == "turtles") draw(all.back(), options.folder);
  }
  return 0;
}

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  try {
    return sightline::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_field: %s\n", error.what());
    return 1;
  }
}
