#include "tests/oracle/judging.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "scene/read.hpp"
#include "tests/oracle/exact_map.hpp"
#include "visibility_map/write.hpp"
#include "winged_pair/check.hpp"

namespace sightline::oracle {
namespace {

using testing::Case;

/// The soup with some corners left out; polygons with less than three left are left out too, and so are vertices that
/// no polygon has then.
PolygonSoup without(const PolygonSoup& soup, std::uint32_t first, std::uint32_t last) {
  PolygonSoup out;
  out.source = soup.source;
  std::vector<std::uint32_t> place(soup.vertices.size(), none);
  for (std::size_t p = 0; p + 1 < soup.first.size(); ++p) {
    std::vector<std::uint32_t> corners;
    for (std::uint32_t k = soup.first[p]; k < soup.first[p + 1]; ++k) {
      if (k < first || k >= last) corners.push_back(soup.corners[k]);
    }
    if (corners.size() < 3) continue;
    for (const std::uint32_t v : corners) place[v] = 0;
    out.corners.insert(out.corners.end(), corners.begin(), corners.end());
    out.first.push_back(static_cast<std::uint32_t>(out.corners.size()));
  }
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] == none) continue;
    place[v] = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.push_back(soup.vertices[v]);
  }
  for (std::uint32_t& v : out.corners) v = place[v];
  return out;
}

std::string shortest(double x) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

}  // namespace

std::string judge(const Case& sample) {
  std::string all;
  const Scene scene = make_scene(sample.soup, sample.options);
  const auto add = [&all](const std::vector<std::string>& lines) {
    for (const std::string& line : lines) all += line + "\n";
  };
  try {
    const Complex complex = build(scene);
    add(check(complex, scene));
    VisibilityMap map;
    Tracer(scene, complex).trace(sample.camera, map);
    VisibilityMap other;
    const BspTree tree(scene);
    Tracer(tree).trace(sample.camera, other);
    if (map_json(map, scene) != map_json(other, scene)) all += "the engines differ\n";
    // Which side of a polygon that crosses itself is its front is not defined.
    if (scene.options().one_sided && scene.report().self_crossing > 0) return all;
    add(differences(oracle_map(scene, sample.camera), exact_map(scene, map)));
  } catch (const std::exception& error) {
    all += std::string("exception: ") + error.what() + "\n";
  }
  return all;
}

Case minimised(Case sample) {
  const auto still = [&sample](const PolygonSoup& soup) {
    if (soup.vertices.empty()) return false;
    Case smaller = sample;
    smaller.soup = soup;
    if (judge(smaller).empty()) return false;
    sample = smaller;
    return true;
  };
  for (std::size_t p = 0; p + 1 < sample.soup.first.size();) {
    if (!still(without(sample.soup, sample.soup.first[p], sample.soup.first[p + 1]))) ++p;
  }
  for (std::uint32_t k = 0; k < sample.soup.corners.size();) {
    if (!still(without(sample.soup, k, k + 1))) ++k;
  }
  return sample;
}

void write_case(const std::filesystem::path& file, const Case& sample, const std::string& comment) {
  std::string text;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  if (sample.options.one_sided) text += "# one-sided\n";
  text += "# camera";
  const Camera& camera = sample.camera;
  for (const glm::dvec3& v : {camera.eye, camera.forward, camera.right, camera.up}) {
    for (int k = 0; k < 3; ++k) text += " " + shortest(v[k]);
  }
  text += "\n";
  const PolygonSoup& soup = sample.soup;
  for (const glm::dvec3& v : soup.vertices)
    text += "v " + shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n";
  for (std::size_t p = 0; p + 1 < soup.first.size(); ++p) {
    text += "f";
    for (std::uint32_t k = soup.first[p]; k < soup.first[p + 1]; ++k) text += " " + std::to_string(soup.corners[k] + 1);
    text += "\n";
  }
  write_file(file, text);
}

std::vector<Case> read_cases(const std::filesystem::path& file) {
  Case sample{read_polygons(file), {}, {}};
  std::vector<Case> cases;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string hash, keyword;
    words >> hash >> keyword;
    if (hash != "#") continue;
    if (keyword == "one-sided") sample.options.one_sided = true;
    if (keyword != "camera") continue;
    for (glm::dvec3* v : {&sample.camera.eye, &sample.camera.forward, &sample.camera.right, &sample.camera.up}) {
      for (int k = 0; k < 3; ++k) {
        std::string number;
        words >> number;
        if (std::from_chars(number.data(), number.data() + number.size(), (*v)[k]).ec != std::errc{}) {
          throw std::runtime_error(file.string() + ": bad camera");
        }
      }
    }
    cases.push_back(sample);
  }
  return cases;
}

}  // namespace sightline::oracle
