// The header of a PLY file: which numbers follow, in which order, of which type.
#pragma once

#include "exact/types.hpp"
#include "scene/text_scanner.hpp"

#include <vector>

namespace sightline {

struct PlyType {
  enum Kind : std::uint8_t { integer, natural, real } kind;
  std::uint8_t size;  // bytes in a binary file
};

struct PlyProperty {
  enum Role : std::uint8_t { other, x, y, z, corners } role = other;
  bool is_list = false;
  PlyType count{};  // of a list
  PlyType value{};
};

struct PlyElement {
  enum Role : std::uint8_t { other, vertex, face } role = other;
  std::uint64_t count = 0;
  std::size_t line = 0;  // in the header
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum Format : std::uint8_t { ascii, little_endian, big_endian } format = ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;       // where the numbers begin, in bytes
  std::size_t body_line = 0;  // and in lines
  std::uint64_t vertices = 0;
};

/// Throws InputError. The vertices have x, y and z, the faces have the list vertex_indices (or vertex_index).
PlyHeader read_ply_header(const std::string& file, std::string_view bytes);

}  // namespace sightline
