// The verifier: is a visibility map right for its scene?
#pragma once

#include "verify/read.hpp"
#include "verify/report.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string_view>

namespace sightline::verify {

class Scene;
struct MapFile;

struct Options {
  std::optional<std::string> snap;  // the map must have been made with it; else the map's own is taken
  bool one_sided = false;
  unsigned threads = 1;
  std::size_t limit = 10;  // faults of each check that are kept
};

/// A line of a cameras file.
struct CameraLine {
  std::array<double, 3> eye{}, forward{}, up{};
  double fov_degrees = 0, aspect = 0;
};
std::vector<CameraLine> read_cameras(const std::string& file);
/// "camera": is the map's camera the one of the line? The eye must be the same; the three vectors must have at most
/// 26 significant bits below their largest component and be, but for a common factor, within their rounding of it.
void check_camera(const MapFile& map, const CameraLine& line, Report& report);

/// Checks maps of one scene. Safe to use from one thread.
class Verifier {
 public:
  explicit Verifier(Soup soup, Options options = {});
  ~Verifier();

  /// Checks a map file's text. Throws InputError where it is no JSON; `camera`: the line it was asked for, if known.
  Report check(const std::string& file, std::string_view text, const CameraLine* camera = nullptr);

 private:
  Soup soup_;
  Options options_;
  std::vector<std::pair<std::string, std::unique_ptr<Scene>>> scenes_;  // by snap
};

}  // namespace sightline::verify
