// What stands behind --methods and --snap: the first byte says which.
#include "compare/method.hpp"
#include "scene/errors.hpp"
#include "scene/scene.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "verify/exact.hpp"

#include <stdexcept>

using namespace sightline;

namespace {

void read_methods(const std::string& list) {
  try {
    fuzz::expect(!comparison::parse_methods(list).empty(), "no method and no error");
  } catch (const std::invalid_argument& error) {
    fuzz::expect(*error.what() != '\0', "an empty message");
  }
}

/// The snapped place of a vertex, or nothing where the unit is refused.
void read_unit(const std::string& unit) {
  PolygonSoup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.3}};
  soup.corners = {0, 1, 2};
  soup.first = {0, 3};
  bool taken = false;
  try {
    make_scene(std::move(soup), {unit, false});
    taken = true;
  } catch (const SceneError& error) {
    fuzz::expect_one_line(error.what());
    taken = true;  // the unit is one, but too small for these places
  } catch (const std::invalid_argument& error) {
    // It repeats the word, which the command prints on one line whatever it holds.
    fuzz::expect(*error.what() != '\0', "an empty message");
  }
  bool other = false;
  try {
    other = verify::parse_decimal(unit) > 0;
  } catch (const std::invalid_argument&) {
  }
  if (taken && !unit.empty()) fuzz::expect(other, "the verifier refuses the unit");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0 || size > 200) return 0;
  const std::string word(fuzz::text(data + 1, size - 1));
  if (word.find('\0') != std::string::npos) return 0;  // no argument of a command holds one
  if (data[0] % 2 == 0) {
    read_methods(word);
  } else {
    read_unit(word);
  }
  return 0;
}
