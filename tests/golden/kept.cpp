#include "tests/golden/kept.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace sightline::golden {
namespace {

constexpr std::string_view angle_key = "\"solid_angle\": ";
constexpr std::string_view columns = "# camera faces edges vertices lines fingerprint solid_angle\n";

/// A line of a map file without the value of its solid angle, and that value; NaN where it has none.
struct Parts {
  std::string_view before, after;
  double angle = std::nan("");
};
Parts split(std::string_view line) {
  const std::size_t key = line.find(angle_key);
  if (key == line.npos) return {line, {}};
  const std::size_t value = key + angle_key.size();
  const std::size_t end = std::min(line.find_first_of(",}", value), line.size());
  double angle = std::nan("");
  const auto read = std::from_chars(line.data() + value, line.data() + end, angle);
  if (read.ec != std::errc() || read.ptr != line.data() + end) return {line, {}};
  return {line.substr(0, value), line.substr(end), angle};
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  return line;
}

/// FNV-1a.
std::uint64_t fingerprint(std::string_view json) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::string_view bytes) {
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  };
  while (!json.empty()) {
    const Parts parts = split(take_line(json));
    add(parts.before);
    add(parts.after);
    add("\n");
  }
  return hash;
}

bool alike(std::string_view kept, std::string_view now) {
  const Parts a = split(kept), b = split(now);
  if (a.before != b.before || a.after != b.after) return false;
  // A line without an angle has NaN on both sides: its bytes were all of it.
  return std::isnan(a.angle) == std::isnan(b.angle) && !(std::abs(a.angle - b.angle) > angle_tolerance);
}

}  // namespace

Row row_of(std::size_t camera, const VisibilityMap& map, const std::string& json) {
  double sum = 0;
  for (const MapFace& face : map.faces) sum += face.solid_angle;
  return {camera, map.faces.size(), map.edges.size(), map.vertices.size(), map.lines.size(), fingerprint(json), sum};
}

std::string difference(const Row& kept, const Row& now) {
  std::ostringstream out;
  const auto compare = [&](const char* what, std::size_t a, std::size_t b) {
    if (a != b && out.str().empty()) out << "kept are " << a << ' ' << what << ", now there are " << b;
  };
  compare("faces", kept.faces, now.faces);
  compare("edges", kept.edges, now.edges);
  compare("vertices", kept.vertices, now.vertices);
  compare("lines", kept.lines, now.lines);
  if (out.str().empty() && kept.fingerprint != now.fingerprint) {
    out << "as many faces, edges, vertices and lines, but other bytes: fingerprint kept " << std::hex
        << kept.fingerprint << ", now " << now.fingerprint;
  }
  if (out.str().empty() && !(std::abs(kept.solid_angle - now.solid_angle) <= angle_tolerance)) {
    out.precision(17);
    out << "the solid angles add up to " << now.solid_angle << ", kept is " << kept.solid_angle;
  }
  return out.str();
}

std::string text_of(const std::string& model, const std::vector<Row>& rows) {
  std::ostringstream out;
  out << "# " << model << ", every camera\n" << columns;
  out.precision(17);
  for (const Row& r : rows) {
    out << r.camera << ' ' << r.faces << ' ' << r.edges << ' ' << r.vertices << ' ' << r.lines << ' ' << std::hex
        << r.fingerprint << std::dec << ' ' << r.solid_angle << '\n';
  }
  return out.str();
}

std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::istringstream in(read_text(file));
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    Row r;
    fields >> r.camera >> r.faces >> r.edges >> r.vertices >> r.lines >> std::hex >> r.fingerprint >> std::dec >>
        r.solid_angle;
    if (!fields) throw std::runtime_error(file.string() + ": not understood: " + line);
    rows.push_back(r);
  }
  return rows;
}

std::string difference(std::string_view kept, std::string_view now) {
  for (std::size_t number = 1; !kept.empty() || !now.empty(); ++number) {
    if (kept.empty() || now.empty()) return "line " + std::to_string(number) + ": one of the two has no more lines";
    const std::string_view a = take_line(kept), b = take_line(now);
    if (alike(a, b)) continue;
    return "line " + std::to_string(number) + "\n  kept: " + std::string(a) + "\n  now:  " + std::string(b);
  }
  return {};
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  if (!(out << text).flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace sightline::golden
