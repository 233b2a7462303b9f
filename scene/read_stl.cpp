#include "scene/byte_order.hpp"
#include "scene/polygon_collector.hpp"
#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

#include <bit>
#include <cmath>

namespace sightline {
namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;  // 80 bytes of anything and the count; 12 floats, 2 bytes

std::uint64_t facet_count(std::string_view bytes) { return load_bytes(bytes.data() + 80, 4, false); }

/// Each facet has three vertices of its own.
void end_facet(PolygonSoup& soup) {
  while (soup.corners.size() < soup.vertices.size()) {
    soup.corners.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
}

PolygonSoup read_binary(const std::string& file, std::string_view bytes) {
  if (bytes.size() < header_bytes) fail_input(file, 0, {"header"}, "the file ends within it");
  const std::uint64_t facets = facet_count(bytes), room = (bytes.size() - header_bytes) / facet_bytes;
  if (facets * facet_bytes + header_bytes != bytes.size()) {
    fail_input(file, 0, {"header"},
               "says " + std::to_string(facets) + " facets, the file has room for " + std::to_string(room));
  }
  if (3 * facets >= none) fail_input(file, 0, {"header"}, "says too many facets");
  PolygonSoup soup;
  soup.vertices.reserve(3 * facets);
  soup.corners.reserve(3 * facets);
  soup.first.reserve(facets + 1);
  const char* at = bytes.data() + header_bytes;
  for (std::size_t facet = 0; facet < facets; ++facet, at += facet_bytes) {
    for (std::size_t k = 0; k < 3; ++k) {
      glm::dvec3& p = soup.vertices.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto word = static_cast<std::uint32_t>(load_bytes(at + 12 + 12 * k + 4 * axis, 4, false));
        const float value = std::bit_cast<float>(word);
        if (!std::isfinite(value)) fail_input(file, 0, {"polygon", facet}, "a coordinate is not a finite number");
        p[static_cast<int>(axis)] = value;
      }
    }
    end_facet(soup);
  }
  return soup;
}

bool same_word(std::string_view a, std::string_view lower) {
  if (a.size() != lower.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const char c = a[k] >= 'A' && a[k] <= 'Z' ? static_cast<char>(a[k] - 'A' + 'a') : a[k];
    if (c != lower[k]) return false;
  }
  return true;
}

class AsciiStl {
 public:
  AsciiStl(const std::string& file, std::string_view text)
      : in_(file, text, {.comments = false, .continuations = false}) {}

  PolygonSoup read() {
    while (in_.find_token()) {
      expect("solid", {"file"});
      in_.rest_of_line();  // its name
      while (facet()) {
      }
      in_.rest_of_line();
    }
    return std::move(soup_);
  }

 private:
  std::string_view word(const Item& item) {
    if (!in_.find_token()) in_.fail(item, "the file ends before endsolid");
    return in_.token();
  }

  void expect(std::string_view wanted, const Item& item) {
    const std::string_view found = word(item);
    if (!same_word(found, wanted)) in_.fail(item, quoted(found) + " stands where " + quoted(wanted) + " belongs");
  }

  /// One facet; false at the end of the solid.
  bool facet() {
    const Item item{"polygon", soup_.first.size() - 1};
    const std::string_view first = word(item);
    if (same_word(first, "endsolid")) return false;
    if (!same_word(first, "facet")) {
      in_.fail(item, quoted(first) + " stands where 'facet' or 'endsolid' belongs");
    }
    expect("normal", item);
    for (int k = 0; k < 3; ++k) word(item);  // not needed, and often not even a number
    expect("outer", item);
    expect("loop", item);
    for (int k = 0; k < 3; ++k) {
      const std::string_view next = word(item);
      if (same_word(next, "endloop")) in_.fail(item, "has fewer than 3 vertices");
      if (!same_word(next, "vertex")) in_.fail(item, quoted(next) + " stands where 'vertex' belongs");
      glm::dvec3& p = soup_.vertices.emplace_back();
      p.x = in_.number(item, "x");
      p.y = in_.number(item, "y");
      p.z = in_.number(item, "z");
    }
    expect("endloop", item);
    expect("endfacet", item);
    if (soup_.vertices.size() >= none) in_.fail(item, "is one too many");
    end_facet(soup_);
    return true;
  }

  TextScanner in_;
  PolygonSoup soup_;
};

}  // namespace

/// Binary files may begin with "solid" too: what is exactly as long as its count says is binary.
PolygonSoup read_stl(const std::string& file, std::string_view bytes) {
  const bool exact = bytes.size() >= header_bytes && bytes.size() == header_bytes + facet_bytes * facet_count(bytes);
  if (!exact && same_word(bytes.substr(0, 5), "solid")) return AsciiStl(file, bytes).read();
  return read_binary(file, bytes);
}

}  // namespace sightline
