// Collects a model's polygons on an integer grid and welds their vertices.
#pragma once

#include "scene/scene.hpp"

#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace sightline::models {

using Point = glm::ivec3;  // in units of 1/16
inline constexpr int units_per_metre = 16;

/// The sides of a box, to be joined with |.
enum Sides : unsigned {
  left = 1,   // x = lo.x
  right = 2,  // x = hi.x
  front = 4,  // y = lo.y
  back = 8,   // y = hi.y
  bottom = 16,
  top = 32,
  around = left | right | front | back,
  standing = around | top,  // a box on the ground: its underside is never seen
  all = standing | bottom
};

/// Coordinates stay below 2^20 units. Polygons run counter-clockwise seen from their open side.
class Mesh {
 public:
  /// The polygons that follow belong to the object of this name, a new or an earlier one.
  void object(const std::string& name);
  void polygon(std::span<const Point> corners);
  void polygon(std::initializer_list<Point> corners) { polygon(std::span(corners.begin(), corners.size())); }
  /// A solid box, seen from outside.
  void box(const Point& lo, const Point& hi, unsigned sides = all);
  /// A room, or a doorway in a wall: a box seen from inside.
  void hollow(const Point& lo, const Point& hi, unsigned sides = all);

  std::uint32_t size() const { return static_cast<std::uint32_t>(soup_.first.size() - 1); }
  /// The polygons with coordinates in metres; the mesh is empty afterwards.
  PolygonSoup take(const std::string& source);

 private:
  std::uint32_t vertex(const Point& p);
  void box_sides(const Point& lo, const Point& hi, unsigned sides, bool inside);
  void grow();

  PolygonSoup soup_;
  std::vector<std::uint64_t> keys_;   // per vertex, its three coordinates packed
  std::vector<std::uint32_t> slots_;  // open addressing: vertex indices
  std::unordered_map<std::string, std::uint32_t> objects_;
  std::uint32_t object_ = none;
};

}  // namespace sightline::models
