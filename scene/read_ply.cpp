#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

namespace sightline {

PolygonSoup read_ply(const std::string& file, std::string_view) { fail_input(file, 0, {"file"}, "cannot be read yet"); }

}  // namespace sightline
