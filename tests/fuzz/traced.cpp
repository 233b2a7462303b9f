// Build and trace: the complex of a small scene is sound, the three engines make the same map to the byte, it reads
// back, and the verifier proves it right.
#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "clip/hybrid.hpp"
#include "scene/read.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/small_scene.hpp"
#include "verify/verify.hpp"
#include "visibility_map/read.hpp"
#include "winged_pair/check.hpp"

using namespace sightline;

namespace {

verify::Soup for_verifier(const PolygonSoup& soup) {
  verify::Soup result;
  for (const glm::dvec3& v : soup.vertices) result.vertices.push_back({v.x, v.y, v.z});
  result.first = soup.first;
  result.corners = soup.corners;
  return result;
}

void expect_right(const fuzz::SmallScene& small, const std::string& json) {
  verify::Options options;
  options.one_sided = small.options.one_sided;
  if (!small.options.snap.empty()) options.snap = small.options.snap;
  const verify::Report report = verify::Verifier(for_verifier(small.soup), options).check("map", json);
  if (report.ok()) return;
  const auto& [check, entry] = *report.checks().begin();
  fuzz::fault("the verifier finds a fault: " + check + ": " + entry.first[0].item + ": " + entry.first[0].what);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::SmallScene small = fuzz::small_scene(data, size, 1);
  const Scene scene = make_scene(small.soup, small.options);
  const Complex complex = build(scene);
  if (const auto faults = check(complex, scene, 1); !faults.empty()) fuzz::fault("the complex: " + faults[0]);

  VisibilityMap map;
  const BspTree tree(scene, {(size & 1u) != 0, 1});
  Tracer(tree).trace(small.cameras[0], map);
  const std::string json = map_json(map, scene);
  Tracer(scene, complex).trace(small.cameras[0], map);
  fuzz::expect(map_json(map, scene) == json, "the engine `cells` makes another map");
  HybridTracer(scene).trace(small.cameras[0], map);
  fuzz::expect(map_json(map, scene) == json, "the engine `hybrid` makes another map");

  const MapFile read = parse_map(json, "map");
  fuzz::expect(map_json(read.map, read.scene) == json, "the map reads back otherwise");
  expect_right(small, json);
  return 0;
}
