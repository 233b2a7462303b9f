// The files of `trace`.
#pragma once

#include "scene/growing_file.hpp"
#include "visibility_map/map.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sightline::app {

/// The names between the commas, each a format that there is. Throws UsageError.
std::set<std::string> checked_formats(const std::string& list);

/// Files of one camera after the other: DIR/0000.map.json, DIR/0000.svg, .., and one for all: DIR/visibility.csv.
/// Throws OutputError.
class MapWriter {
 public:
  MapWriter(const std::filesystem::path& folder, const std::set<std::string>& formats);

  /// The next so many cameras follow.
  void begin(std::size_t cameras) { rows_.assign(wants("csv") ? cameras : 0, {}); }
  /// From any thread, for different cameras at a time; `row` counts since begin().
  void write(std::size_t row, std::size_t camera, const VisibilityMap& map, const Scene& scene);
  /// All since begin() have been written.
  void end();
  /// After the last camera: what is one file for all gets its name.
  void finish();

 private:
  bool wants(const std::string& format) const { return formats_.contains(format); }

  std::filesystem::path folder_;
  std::set<std::string> formats_;
  std::filesystem::path csv_file_;
  std::optional<GrowingFile> csv_;
  std::vector<std::string> rows_;  // of each camera since begin()
};

}  // namespace sightline::app
