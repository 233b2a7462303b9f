// Polygons as a reader comes upon them.
#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace sightline {

/// Fills a soup whose number of vertices is known before its polygons. Each function answers with what is wrong, or "".
class PolygonCollector {
 public:
  /// `vertices`: how many the file has. Nothing is allocated for them yet.
  explicit PolygonCollector(std::uint64_t vertices) : vertices_(vertices) {}

  std::string add_corner(std::int64_t index) {
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices_) {
      return "vertex " + std::to_string(index) + " is out of range, the file has " + std::to_string(vertices_);
    }
    soup.corners.push_back(static_cast<std::uint32_t>(index));
    return {};
  }
  std::string end_polygon() {
    if (soup.corners.size() >= none) return "is one too many";
    if (soup.corners.size() < soup.first.back() + std::size_t{3}) return "has fewer than 3 vertices";
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    return {};
  }
  std::size_t polygons() const { return soup.first.size() - 1; }

  PolygonSoup soup;

 private:
  std::uint64_t vertices_;
};

}  // namespace sightline
