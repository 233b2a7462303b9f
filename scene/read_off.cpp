#include "scene/polygon_collector.hpp"
#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

namespace sightline {
namespace {

constexpr Item header{"header"};

/// The first word: OFF, with ST, C, N before it where vertices have texture places, colours, normals as well (they
/// stand behind the coordinates). Vertices of other than three coordinates, and binary files, are refused.
void read_keyword(TextScanner& in) {
  if (!in.find_token()) in.fail(header, "the file has no word OFF");
  const std::string_view word = in.token();
  std::string_view rest = word;
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (rest.starts_with(prefix)) rest.remove_prefix(prefix.size());
  }
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF") {
    in.fail(header, quoted(word) + ": only vertices with three coordinates are read");
  }
  if (rest != "OFF") in.fail(header, quoted(word) + " is not the word OFF");
  if (!in.at_line_end() && in.next_is('B')) in.fail(header, quoted(in.token()) + ": only OFF files in ASCII are read");
}

/// A number of records, which take at least `bytes` bytes each.
std::size_t read_count(TextScanner& in, const char* what, std::size_t bytes) {
  if (!in.find_token()) in.fail(header, std::string(what) + " is missing, the file ends");
  const std::int64_t count = in.integer(header, what);
  if (count < 0 || count >= none || static_cast<std::uint64_t>(count) > in.remaining() / bytes + 1) {
    in.fail(header, std::string(what) + " is " + std::to_string(count) + ", which the file has no room for");
  }
  return static_cast<std::size_t>(count);
}

/// To the first token of the next record.
void next_record(TextScanner& in, const Item& item) {
  if (!in.find_token()) in.fail(item, "is missing, the file ends");
}

}  // namespace

PolygonSoup read_off(const std::string& file, std::string_view text) {
  TextScanner in(file, text, {.comments = true, .continuations = false});
  read_keyword(in);
  const std::size_t vertices = read_count(in, "number of vertices", 6);  // "0 0 0\n"
  const std::size_t polygons = read_count(in, "number of polygons", 8);  // "3 0 0 0\n"
  if (!in.at_line_end()) in.integer(header, "number of edges");
  if (!in.at_line_end()) in.fail(header, quoted(in.token()) + " is one number too many");
  in.next_line();

  PolygonCollector collector(vertices);
  collector.soup.vertices.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v, in.next_line()) {
    const Item item{"vertex", v};
    next_record(in, item);
    glm::dvec3& p = collector.soup.vertices.emplace_back();
    p.x = in.number(item, "x");
    p.y = in.number(item, "y");
    p.z = in.number(item, "z");
    while (!in.at_line_end()) in.skip_number(item);
  }
  for (std::size_t k = 0; k < polygons; ++k, in.next_line()) {
    const Item item{"polygon", k};
    next_record(in, item);
    const auto check = [&](const std::string& problem) {
      if (!problem.empty()) in.fail(item, problem);
    };
    const std::int64_t corners = in.integer(item, "number of vertices");
    for (std::int64_t i = 0; i < corners; ++i) check(collector.add_corner(in.integer(item, "vertex")));
    check(collector.end_polygon());
    while (!in.at_line_end()) in.skip_number(item);  // a colour
  }
  if (in.find_token()) in.fail({"file"}, quoted(in.token()) + " stands behind the last polygon that the header counts");
  return std::move(collector.soup);
}

}  // namespace sightline
