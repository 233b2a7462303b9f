#include "bench/compare/subjects.hpp"

#include <algorithm>
#include <stdexcept>

#ifdef SIGHTLINE_COMPARE_ZLIB
#include <zlib.h>
#endif

#include "models/model.hpp"
#include "scene/read.hpp"

namespace sightline::peers {
namespace {

constexpr const char* models[] = {"maze", "city", "random", "building", "building:100000"};

std::string unzipped(const std::filesystem::path& file) {
#ifdef SIGHTLINE_COMPARE_ZLIB
  const gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr) throw std::runtime_error(file.string() + ": cannot be opened");
  std::string text;
  char buffer[1 << 16];
  int got = 0;
  while ((got = gzread(in, buffer, sizeof buffer)) > 0) text.append(buffer, static_cast<std::size_t>(got));
  gzclose(in);
  if (got < 0) throw std::runtime_error(file.string() + ": is damaged");
  return text;
#else
  throw std::runtime_error(file.string() + ": built without zlib (zlib1g-dev); unzip it first: gzip -dk " +
                           file.string());
#endif
}

Subject of_file(const std::filesystem::path& file) {
  Subject out;
  std::filesystem::path base = file;
  if (file.extension() == ".gz") {
    base.replace_extension();
    const auto plain = std::filesystem::temp_directory_path() / base.filename();
    write_file(plain, unzipped(file));
    out.soup = read_polygons(plain);
    std::filesystem::remove(plain);
  } else {
    out.soup = read_polygons(file);
  }
  base.replace_extension(".cameras");
  out.name = base.stem().string();
  out.cameras = read_cameras(base);
  return out;
}

}  // namespace

std::vector<std::string> default_subjects(const std::filesystem::path& folder) {
  std::vector<std::string> out(std::begin(models), std::end(models));
  for (const char* model : models) out.push_back(std::string(model) + "@17");
  std::vector<std::string> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().string();
      if (name.ends_with(".obj") || name.ends_with(".obj.gz")) files.push_back(name);
    }
  }
  std::ranges::sort(files);
  out.insert(out.end(), files.begin(), files.end());
  return out;
}

Subject make_subject(const std::string& name) {
  if (name.ends_with(".gz") || std::filesystem::exists(name)) return of_file(name);
  ModelOptions options;
  std::string model = name;
  if (const auto at = model.find('@'); at != std::string::npos) {
    options.rotate_degrees = std::stod(model.substr(at + 1));
    model.resize(at);
  }
  if (const auto at = model.find(':'); at != std::string::npos) {
    options.polygons = static_cast<std::uint32_t>(std::stoul(model.substr(at + 1)));
    model.resize(at);
  }
  Model made = make_model(model, options);
  Subject out{name, std::move(made.soup), {}};
  for (const CameraLine& c : made.cameras) {
    out.cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  return out;
}

}  // namespace sightline::peers
