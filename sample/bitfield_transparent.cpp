#include "sample/bitfield_transparent.hpp"

#include "scene/errors.hpp"
#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

#include <algorithm>

namespace sightline {
namespace {

void tidy_up(std::vector<PolygonId>& polygons) {
  std::ranges::sort(polygons);
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
}

bool is_obj(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return ending == ".obj";
}

/// Of each polygon the index in `names` of its material, or `none`.
std::vector<std::uint32_t> materials_of(const std::filesystem::path& file, std::span<const std::string> names) {
  const std::string text = load_file(file.string());
  TextScanner in(file.string(), text, {.comments = true, .continuations = true});
  std::vector<std::uint32_t> out;
  std::uint32_t material = none;
  for (; in.find_token(); in.next_line()) {
    const std::string_view key = in.token();
    if (key == "f") out.push_back(material);
    if (key != "usemtl") continue;
    const auto name = std::ranges::find(names, in.rest_of_line());
    material = name == names.end() ? none : static_cast<std::uint32_t>(name - names.begin());
  }
  return out;
}

}  // namespace

std::vector<PolygonId> polygons_named(const Scene& scene, const std::filesystem::path& file,
                                      std::span<const std::string> names) {
  const PolygonSoup& soup = scene.soup();
  std::vector<PolygonId> out;
  std::vector<bool> found(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (PolygonId p = 0; p < soup.object_of.size(); ++p) {
      if (soup.object_of[p] == none || soup.objects[soup.object_of[p]] != names[k]) continue;
      out.push_back(p);
      found[k] = true;
    }
  }
  if (is_obj(file)) {
    const std::vector<std::uint32_t> materials = materials_of(file, names);
    for (PolygonId p = 0; p < std::min<std::size_t>(materials.size(), scene.polygon_count()); ++p) {
      if (materials[p] == none) continue;
      out.push_back(p);
      found[materials[p]] = true;
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!found[k])
      throw InputError(file.string() + ": no polygon has an object or material " + sightline::quoted(names[k]));
  }
  tidy_up(out);
  return out;
}

std::vector<PolygonId> read_polygon_list(const std::filesystem::path& file, std::uint32_t polygons) {
  const std::string text = load_file(file.string());
  TextScanner in(file.string(), text, {.comments = true, .continuations = false});
  std::vector<PolygonId> out;
  while (in.find_token()) {
    const Item item{"polygon"};
    const std::int64_t value = in.integer(item, "index");
    if (value < 0 || value >= polygons) {
      in.fail(item, std::to_string(value) + " is out of range, the scene has " + std::to_string(polygons));
    }
    out.push_back(static_cast<PolygonId>(value));
  }
  tidy_up(out);
  return out;
}

}  // namespace sightline
