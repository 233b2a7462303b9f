// A winged-pair file: refused in one line, or written again it has the same content, and a camera can be traced in it.
#include "beam/trace.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "winged_pair/file.hpp"

#include <optional>

using namespace sightline;

namespace {

std::optional<SceneAndComplex> read_one(const std::filesystem::path& file) {
  try {
    return read_wp(file);
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
    return {};
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::optional<SceneAndComplex> both = read_one(fuzz::as_file(fuzz::text(data, size), ".wp"));
  if (!both) return 0;
  const std::filesystem::path again = fuzz::as_file("", "-again.wp");
  write_wp(again, both->scene, both->complex);
  const SceneAndComplex reread = read_wp(again);
  fuzz::expect(reread.complex.cells.size() == both->complex.cells.size(), "written again it has other cells");
  VisibilityMap map;
  Tracer tracer(both->scene, both->complex);
  try {
    tracer.trace(Camera{{-3, -7, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, map);
  } catch (const std::exception& error) {
    fuzz::expect_one_line(error.what());
  }
  return 0;
}
