// A polygon file of the format FORMAT (obj, ply, off or stl): it is refused in one line, or it is a scene, the
// verifier's own reader reads the same from it, and what is written reads back the same.
#include "scene/errors.hpp"
#include "scene/read.hpp"
#include "scene/readers.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "verify/read.hpp"

#include <cstring>
#include <optional>

using namespace sightline;

#define JOIN(a, b) a##b
#define READER(format) JOIN(read_, format)

namespace {

std::optional<PolygonSoup> read_one(std::string_view text) {
  try {
    return READER(FORMAT)("input", text);
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
    return {};
  }
}

std::optional<verify::Soup> read_other(std::string_view text) {
  try {
    verify::Soup soup = verify::READER(FORMAT)("input", text);
    verify::check_soup("input", soup);
    return soup;
  } catch (const verify::InputError& error) {
    fuzz::expect_one_line(error.what());
    return {};
  }
}

bool same_vertices(const PolygonSoup& a, const verify::Soup& b) {
  return a.vertices.size() == b.vertices.size() &&
         (b.vertices.empty() ||
          std::memcmp(a.vertices.data(), b.vertices.data(), sizeof(glm::dvec3) * a.vertices.size()) == 0);
}

/// Not for files of huge coordinates beside tiny ones, which are right but slow.
bool quick(const PolygonSoup& soup) { return soup.vertices.size() < 100 && soup.corners.size() < 200; }

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text(data, size);
  const std::optional<PolygonSoup> soup = read_one(text);
  const std::optional<verify::Soup> other = read_other(text);
  if (soup && soup->first.size() > 1) {
    fuzz::expect(other.has_value(), "the verifier's reader refuses what is a scene");
    fuzz::expect(same_vertices(*soup, *other), "the verifier's reader reads other vertices");
    fuzz::expect(soup->first == other->first && soup->corners == other->corners,
                 "the verifier's reader reads other polygons");
  }
  if (!soup || soup->first.size() == 1 || !quick(*soup)) return 0;
  try {
    const Scene scene = make_scene(*soup);
    fuzz::expect(scene.polygon_count() + 1 == soup->first.size(), "polygons were lost");
  } catch (const SceneError& error) {
    fuzz::expect_one_line(error.what());
    return 0;
  }
  const std::filesystem::path written = fuzz::as_file("", ".obj");
  write_obj(written, *soup);
  const PolygonSoup again = read_polygons(written);
  fuzz::expect(again.first == soup->first && again.corners == soup->corners, "written polygons read back otherwise");
  fuzz::expect(
      again.vertices.size() == soup->vertices.size() &&
          std::memcmp(again.vertices.data(), soup->vertices.data(), sizeof(glm::dvec3) * again.vertices.size()) == 0,
      "written vertices read back otherwise");
  return 0;
}
