// A cameras file: refused in one line, or as many cameras as the verifier's own reader finds lines, each of which the
// verifier takes for the camera of its line.
#include "scene/read.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "verify/map_file.hpp"
#include "verify/verify.hpp"

#include <optional>

using namespace sightline;

namespace {

std::array<double, 3> of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path file = fuzz::as_file(fuzz::text(data, size), ".cameras");
  std::vector<Camera> cameras;
  try {
    cameras = read_cameras(file);
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
    return 0;
  }
  const std::vector<verify::CameraLine> lines = verify::read_cameras(file.string());
  fuzz::expect(lines.size() == cameras.size(), "the verifier's reader reads another number of cameras");
  for (std::size_t k = 0; k < cameras.size() && k < 8; ++k) {
    verify::MapFile map;
    map.eye = of(cameras[k].eye);
    map.forward = of(cameras[k].forward);
    map.right = of(cameras[k].right);
    map.up = of(cameras[k].up);
    verify::Report report;
    verify::check_camera(map, lines[k], report);
    if (!report.ok()) fuzz::fault("camera " + std::to_string(k) + ": " + report.checks().begin()->second.first[0].what);
  }
  return 0;
}
