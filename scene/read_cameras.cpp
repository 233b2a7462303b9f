#include "scene/read.hpp"
#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

#include <array>

namespace sightline {

std::vector<Camera> read_cameras(const std::filesystem::path& file) {
  static constexpr std::array<const char*, 11> names{"eye x", "eye y", "eye z", "forward x", "forward y", "forward z",
                                                     "up x",  "up y",  "up z",  "angle",     "aspect"};
  const std::string text = load_file(file.string());
  TextScanner in(file.string(), text, {.comments = true, .continuations = false});
  std::vector<Camera> cameras;
  for (; in.find_token(); in.next_line()) {
    const Item item{"camera", cameras.size()};
    std::array<double, names.size()> v{};
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = in.number(item, names[k]);
    if (!in.at_line_end()) in.fail(item, quoted(in.token()) + " is one number too many");
    try {
      cameras.push_back(make_camera({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9], v[10]));
    } catch (const std::invalid_argument& e) {
      in.fail(item, e.what());
    }
  }
  if (cameras.empty()) fail_input(file.string(), 0, {"file"}, "holds no camera");
  return cameras;
}

}  // namespace sightline
