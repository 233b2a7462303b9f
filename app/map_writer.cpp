#include "app/map_writer.hpp"

#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "visibility_map/write.hpp"

#include <sstream>

namespace sightline::app {

/// The names between the commas.
std::set<std::string> checked_formats(const std::string& list) {
  static const std::set<std::string> known{"map", "svg", "png", "pdf", "csv"};
  std::set<std::string> formats;
  std::istringstream names(list + ",");
  for (std::string name; std::getline(names, name, ',');) {
    if (!known.contains(name)) throw UsageError("--format " + list + ": formats are map, svg, png, pdf, csv");
    formats.insert(name);
  }
  return formats;
}

MapWriter::MapWriter(const std::filesystem::path& folder, const std::set<std::string>& formats)
    : folder_(folder), formats_(formats), csv_file_(folder / "visibility.csv") {
  if (!wants("csv")) return;
  write_safely(csv_file_, [&] {
    csv_.emplace(csv_file_);
    csv_->append(csv_header);
  });
}

void MapWriter::write(std::size_t row, std::size_t camera, const VisibilityMap& map, const Scene& scene) {
  const auto name = [&](const char* ending) { return numbered(folder_, camera, ending); };
  if (wants("map")) write_text(name(".map.json"), map_json(map, scene));
  if (wants("svg")) write_text(name(".svg"), map_svg(map, scene));
  if (wants("png")) {
    const auto file = name(".png");
    write_safely(file, [&] { write_map_png(file, map, scene); });
  }
  if (wants("pdf")) {
    const auto file = name(".pdf");
    write_safely(file, [&] { write_map_pdf(file, map, scene); });
  }
  if (wants("csv")) rows_[row] = map_csv(map, scene, camera);
}

void MapWriter::end() {
  if (!csv_) return;
  std::string text;
  for (const std::string& rows : rows_) text += rows;
  write_safely(csv_file_, [&] { csv_->append(text); });
}

void MapWriter::finish() {
  if (csv_) write_safely(csv_file_, [&] { csv_->finish(); });
}

}  // namespace sightline::app
