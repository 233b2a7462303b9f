// Meruvia and Strothotte's figures 5 to 7: what is culled, what that gains, which pixels are missed.
#include "bench/bitfield/bodies.hpp"
#include "bench/cpu_seconds.hpp"
#include "sample/bitfield_viewer.hpp"
#include "sample/bitfield_viewpoints.hpp"
#include "sample/id_buffer.hpp"
#include "sample/sub_scene.hpp"
#include "scene/read.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>

namespace sightline {
namespace {

constexpr unsigned shown_pixels = 255;  // as in the paper's figure 7

struct Settings {
  std::vector<std::string> bodies;
  std::vector<unsigned> samples{6, 14, 25, 55};
  unsigned views = 6, timed_pixels = 512, passes = 3, threads = 1;
  bool variants = false;
  std::filesystem::path csv, pictures, write;
};

/// A way of taking samples and joining them.
struct Variant {
  std::string name;
  BitfieldSampling sampling;
  unsigned neighbours = 6;
};

struct Row {
  std::string body, variant;
  std::size_t polygons = 0, samples = 0, faces = 0;
  double culled = 0, speed_up = 0;      // speed-up: median over the views
  double missed = 0, worst_missed = 0;  // pixels a view
  std::array<double, 10> histogram{};   // missed pixels by the difference of their grey, a view
  double plain = 0, hierarchical = 0, compressed = 0, lists = 0;  // bytes
  double build_seconds = 0, list_seconds = 0;
};

/// Viewers that are no viewpoints: on a spiral turned away from that of the samples, from near to far.
std::vector<Camera> test_views(const Scene& scene, unsigned count) {
  const glm::dvec3 centre = viewing_centre(scene);
  const CameraLine sphere = sphere_cameras(scene, 4).front();
  const double far = glm::distance(sphere.eye, centre);
  std::vector<Camera> out;
  for (unsigned k = 0; k < count; ++k) {
    const double z = 0.93 - 1.86 * (k + 0.5) / count, r = std::sqrt(1 - z * z), turn = 1.234 + 2.1 * k;
    const glm::dvec3 d(r * std::cos(turn), r * std::sin(turn), z);
    out.push_back(make_camera(centre + far * (0.8 + 0.1 * (k % 5)) * d, -d, {0, 0, 1}, 45, 1));
  }
  return out;
}

/// Grey by the angle between a polygon and the line of sight, 0 to 1; nothing is black.
double grey(const Scene& scene, PolygonId p, const Camera& camera) {
  if (p == none) return 0;
  const auto c = scene.corners(p);
  const auto& v = scene.soup().vertices;
  const glm::dvec3 n = glm::cross(v[c[1]] - v[c[0]], v[c[2]] - v[c[0]]);
  const double length = glm::length(n);
  return length > 0 ? std::abs(glm::dot(n / length, glm::normalize(camera.eye - v[c[0]]))) : 0;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

double drawing_seconds(IdBuffer& buffer, const Camera& camera, unsigned passes) {
  buffer.draw(camera);  // warms it
  std::vector<double> seconds;
  for (unsigned k = 0; k < passes; ++k) {
    const double start = cpu_seconds();
    buffer.draw(camera);
    seconds.push_back(cpu_seconds() - start);
  }
  return median(seconds);
}

Row measure(const Scene& scene, const std::string& body, const Variant& variant, unsigned count, const Settings& s) {
  Row row;
  row.body = body;
  row.variant = variant.name;
  row.polygons = scene.polygon_count();
  row.samples = count;
  std::vector<Camera> cameras;
  for (const CameraLine& c : sphere_cameras(scene, count)) {
    cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  double start = cpu_seconds();
  BitfieldSamples samples = sample_bitfields(scene, cameras, variant.sampling);
  row.build_seconds = cpu_seconds() - start;
  for (const IdBitfield& f : samples.fields) {
    row.plain += static_cast<double>(f.bytes());
    row.hierarchical += static_cast<double>(HierarchicalBitfield(f).bytes());
    row.compressed += static_cast<double>(CompressedBitfield(f).bytes());
  }
  start = cpu_seconds();
  BitfieldViewer viewer(std::move(samples), {variant.neighbours, BitfieldViewing::lists, 1}, &scene);
  row.list_seconds = cpu_seconds() - start;
  row.faces = viewer.hull().faces().size();
  row.lists = static_cast<double>(viewer.bytes());
  row.culled = 1 - viewer.mean_list() / scene.polygon_count();

  IdBuffer whole(scene, shown_pixels), whole_timed(scene, s.timed_pixels);
  std::vector<double> gains;
  for (const Camera& view : test_views(scene, s.views)) {
    const SubScene part = sub_scene(scene, viewer.look(view).polygons);
    IdBuffer some(part.scene, shown_pixels), some_timed(part.scene, s.timed_pixels);
    const auto right = whole.draw(view), shown = some.draw(view);
    double missed = 0;
    for (std::size_t k = 0; k < right.size(); ++k) {
      const PolygonId p = shown[k] == none ? none : part.original[shown[k]];
      if (p == right[k]) continue;
      ++missed;
      const double difference = std::abs(grey(scene, p, view) - grey(scene, right[k], view));
      row.histogram[std::min<std::size_t>(9, static_cast<std::size_t>(10 * difference))] += 1.0 / s.views;
    }
    row.missed += missed / s.views;
    row.worst_missed = std::max(row.worst_missed, missed);
    gains.push_back(drawing_seconds(whole_timed, view, s.passes) / drawing_seconds(some_timed, view, s.passes));
  }
  row.speed_up = median(gains);
  return row;
}

std::string csv_line(const Row& r) {
  char text[512];
  std::snprintf(text, sizeof text, "%s,%s,%zu,%zu,%zu,%.4f,%.3f,%.2f,%.0f,%.0f,%.0f,%.0f,%.0f,%.3f,%.3f",
                r.body.c_str(), r.variant.c_str(), r.polygons, r.samples, r.faces, r.culled, r.speed_up, r.missed,
                r.worst_missed, r.plain, r.hierarchical, r.compressed, r.lists, r.build_seconds, r.list_seconds);
  std::string line = text;
  for (const double h : r.histogram) {
    std::snprintf(text, sizeof text, ",%.3f", h);
    line += text;
  }
  return line + "\n";
}

void print(const Row& r) {
  std::printf("| %s | %zu | %s | %zu | %.1f %% | %.2f | %.1f | %.0f | %.0f | %.0f | %.0f | %.0f |\n", r.body.c_str(),
              r.polygons, r.variant.c_str(), r.samples, 100 * r.culled, r.speed_up, r.missed, r.worst_missed,
              r.plain / 1e3, r.hierarchical / 1e3, r.compressed / 1e3, r.lists / 1e3);
  std::fflush(stdout);
}

bool is_file(const std::string& body) { return body.ends_with(".obj"); }
std::string name_of(const std::string& body) {
  return is_file(body) ? std::filesystem::path(body).stem().string() : body;
}

/// One block a body for gnuplot: samples, culled percentage, speed-up, missed; then their histograms at the last
/// number.
void draw(const Settings& s, const std::vector<Row>& rows) {
  std::filesystem::create_directories(s.pictures);
  std::string curves, bars;
  for (const std::string& body : s.bodies) {
    const char* gap = curves.empty() ? "" : "\n\n";  // between gnuplot's blocks
    curves += gap + ("\"" + name_of(body)) + "\"\n";
    const Row* last = nullptr;
    for (const Row& r : rows) {
      if (r.body != name_of(body) || r.variant != "six") continue;
      char line[128];
      std::snprintf(line, sizeof line, "%zu %.3f %.3f %.3f\n", r.samples, 100 * r.culled, r.speed_up, r.missed);
      curves += line;
      if (last == nullptr || r.samples == 25) last = &r;
    }
    bars += gap + ("\"" + name_of(body)) + "\"\n";
    for (std::size_t k = 0; last != nullptr && k < last->histogram.size(); ++k) {
      char line[64];
      std::snprintf(line, sizeof line, "%.2f %.3f\n", 0.1 * static_cast<double>(k) + 0.05, last->histogram[k]);
      bars += line;
    }
  }
  write_file(s.pictures / "curves.dat", curves);
  write_file(s.pictures / "histograms.dat", bars);
  const std::string command = "gnuplot -e \"folder='" + s.pictures.string() + "'\" " SIGHTLINE_BITFIELD_SCRIPT;
  if (std::system(command.c_str()) != 0) std::fprintf(stderr, "bench_bitfield: no pictures without gnuplot\n");
}

std::vector<Variant> variants_of(const Settings& s) {
  Variant usual{"six", {}, 6};
  usual.sampling.threads = s.threads;
  std::vector<Variant> out{usual};
  if (!s.variants) return out;
  for (const char* name : {"three", "300 pixels", "300 pixels, filled in", "filled in", "patches of 16", "exact"}) {
    Variant v = usual;
    v.name = name;
    if (v.name == "three") v.neighbours = 3;
    if (v.name.starts_with("300")) v.sampling.pixels = 300;
    if (v.name.ends_with("filled in")) v.sampling.fill_rounds = 1;
    if (v.name == "patches of 16") v.sampling.patch = 16;
    if (v.name == "exact") v.sampling.exact = true;
    out.push_back(v);
  }
  return out;
}

int run(const Settings& s) {
  std::vector<Row> rows;
  std::string csv =
      "body,variant,polygons,samples,faces,culled,speed_up,missed,worst_missed,plain_bytes,hierarchical_bytes,"
      "compressed_bytes,list_bytes,build_seconds,list_seconds,h0,h1,h2,h3,h4,h5,h6,h7,h8,h9\n";
  std::printf(
      "| body | polygons | samples are | samples | culled | speed-up | missed pixels | most | plain kB | hierarchical "
      "kB | compressed kB | lists kB |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& body : s.bodies) {
    const Scene scene = make_scene(is_file(body) ? read_polygons(body) : make_body(body));
    const std::string name = name_of(body);
    if (!s.write.empty()) {
      std::filesystem::create_directories(s.write);
      write_obj(s.write / (name + ".obj"), scene.soup());
    }
    for (const Variant& variant : variants_of(s)) {
      for (const unsigned count : s.samples) {
        if (variant.name != "six" && count != 25) continue;
        rows.push_back(measure(scene, name, variant, count, s));
        print(rows.back());
        csv += csv_line(rows.back());
        if (!s.csv.empty()) write_file(s.csv, csv);
      }
    }
  }
  if (!s.pictures.empty()) draw(s, rows);
  return 0;
}

}  // namespace
}  // namespace sightline

int main(int argc, char** argv) {
  sightline::Settings s;
  s.bodies = sightline::body_names();
  CLI::App app("What ID bitfields cull, gain and miss");
  app.add_option("bodies", s.bodies, "bunny, gears, brain, or OBJ files")->capture_default_str();
  app.add_option("--samples", s.samples, "Numbers of samples")->delimiter(',')->capture_default_str();
  app.add_option("--views", s.views, "Viewers")->check(CLI::Range(1, 1000))->capture_default_str();
  app.add_option("--pixels", s.timed_pixels, "Pixels a side of what is timed")
      ->check(CLI::Range(1, 8192))
      ->capture_default_str();
  app.add_option("--passes", s.passes, "Times that each is drawn; medians count")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--threads", s.threads, "For taking samples")->check(CLI::Range(1, 256))->capture_default_str();
  app.add_flag("--variants", s.variants, "With 25 samples also other ways of taking and joining them");
  app.add_option("--csv", s.csv, "Everything, and histograms of missed pixels by their difference in grey");
  app.add_option("--pictures", s.pictures, "Folder for pictures by gnuplot");
  app.add_option("--write", s.write, "Folder for the bodies as OBJ files");
  CLI11_PARSE(app, argc, argv);
  return sightline::run(s);
}
