// A photograph: refused in one line, or written and read again it is the same.
#include "photos/image.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace sightline;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A few bytes can say 32767 x 32767 pixels, which is a right picture of 3 GiB.
  if (size > 24 && (data[16] | data[17] | data[20] | data[21]) != 0) return 0;
  try {
    const Image image = parse_png(fuzz::text(data, size), "input");
    fuzz::expect(parse_png(png(image), "written") == image, "what is written reads back otherwise");
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
  }
  return 0;
}
