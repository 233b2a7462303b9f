// A map file: both readers refuse it in one line or by a fault, or take it. What the kernel's reader takes it writes so
// that it reads the same again; what the verifier finds right the kernel's reader takes.
#include "tests/fuzz/fuzz.hpp"
#include "verify/verify.hpp"
#include "visibility_map/read.hpp"

#include <optional>

using namespace sightline;

namespace {

/// The scene of the maps in the corpus.
constexpr const char* scene_text =
    "v 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\nv 1 1 1\nv 3 1 1\nv 3 1 3\nv 1 1 3\nv -1 -1 0\nv 1 3 0\nv 1 3 1\n"
    "f 1 2 3 4\nf 5 6 7 8\nf 9 10 11\n";

std::optional<MapFile> read_one(std::string_view text) {
  try {
    return parse_map(text, "input");
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
    return {};
  }
}

bool right(std::string_view text) {
  static verify::Verifier verifier(verify::read_obj("scene", scene_text));
  try {
    return verifier.check("input", text).ok();
  } catch (const verify::InputError& error) {
    fuzz::expect_one_line(error.what());
    return false;
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text(data, size);
  const std::optional<MapFile> read = read_one(text);
  if (read) {
    const std::string written = map_json(read->map, read->scene);
    const MapFile again = parse_map(written, "written");
    fuzz::expect(map_json(again.map, again.scene) == written, "what is written reads back otherwise");
  }
  if (right(text)) fuzz::expect(read.has_value(), "the kernel's reader refuses a map that is right");
  return 0;
}
