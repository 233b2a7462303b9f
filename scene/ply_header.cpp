#include "scene/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace sightline {
namespace {

constexpr Item header{"header"};

struct NamedType {
  std::string_view name, other_name;
  PlyType type;
};
constexpr std::array<NamedType, 8> types{{{"char", "int8", {PlyType::integer, 1}},
                                          {"uchar", "uint8", {PlyType::natural, 1}},
                                          {"short", "int16", {PlyType::integer, 2}},
                                          {"ushort", "uint16", {PlyType::natural, 2}},
                                          {"int", "int32", {PlyType::integer, 4}},
                                          {"uint", "uint32", {PlyType::natural, 4}},
                                          {"float", "float32", {PlyType::real, 4}},
                                          {"double", "float64", {PlyType::real, 8}}}};

PlyType type_named(const TextScanner& in, std::string_view name) {
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.name == name || t.other_name == name; });
  if (found == types.end()) in.fail(header, quoted(name) + " is no type");
  return found->type;
}

PlyProperty::Role role_of(PlyElement::Role element, std::string_view name) {
  if (element == PlyElement::vertex) {
    if (name == "x") return PlyProperty::x;
    if (name == "y") return PlyProperty::y;
    if (name == "z") return PlyProperty::z;
  }
  if (element == PlyElement::face && (name == "vertex_indices" || name == "vertex_index")) return PlyProperty::corners;
  return PlyProperty::other;
}

bool has(const PlyElement& element, PlyProperty::Role role) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const PlyProperty& p) { return p.role == role; });
}

void read_format(TextScanner& in, PlyHeader& result) {
  const std::string_view name = in.token();
  if (name == "ascii") {
    result.format = PlyHeader::ascii;
  } else if (name == "binary_little_endian") {
    result.format = PlyHeader::little_endian;
  } else if (name == "binary_big_endian") {
    result.format = PlyHeader::big_endian;
  } else {
    in.fail(header, quoted(name) + " is no format of PLY files");
  }
  const std::string_view version = in.token();
  if (version != "1.0") in.fail(header, "version " + quoted(version) + " of PLY files is not known");
}

void read_element(TextScanner& in, PlyHeader& result) {
  const std::string_view name = in.token();
  PlyElement element;
  if (name == "vertex") element.role = PlyElement::vertex;
  if (name == "face") element.role = PlyElement::face;
  element.line = in.line();
  const std::int64_t count = in.integer(header, "number of elements");
  if (count < 0) in.fail(header, "a number of elements is negative");
  element.count = static_cast<std::uint64_t>(count);
  const auto same = [&](const PlyElement& e) { return e.role == element.role; };
  if (element.role != PlyElement::other && std::any_of(result.elements.begin(), result.elements.end(), same)) {
    in.fail(header, "element " + quoted(name) + " comes twice");
  }
  if (element.role == PlyElement::vertex) result.vertices = element.count;
  if (element.role != PlyElement::other && element.count >= none) in.fail(header, "says too many elements");
  result.elements.push_back(std::move(element));
}

void read_property(TextScanner& in, PlyHeader& result) {
  if (result.elements.empty()) in.fail(header, "a property stands before the first element");
  PlyElement& element = result.elements.back();
  PlyProperty property;
  std::string_view type = in.token();
  property.is_list = type == "list";
  if (property.is_list) {
    property.count = type_named(in, in.token());
    type = in.token();
  }
  property.value = type_named(in, type);
  const std::string_view name = in.token();
  if (name.empty()) in.fail(header, "a property has no name");
  property.role = role_of(element.role, name);
  if (property.role != PlyProperty::other) {
    if (has(element, property.role)) in.fail(header, "property " + quoted(name) + " comes twice");
    if (property.is_list != (property.role == PlyProperty::corners)) {
      in.fail(header, "property " + quoted(name) + (property.is_list ? " is a list" : " is no list"));
    }
  }
  element.properties.push_back(property);
}

void check(const std::string& file, const PlyHeader& result) {
  for (const PlyElement& e : result.elements) {
    if (e.role == PlyElement::vertex) {
      for (const auto& [role, name] : {std::pair{PlyProperty::x, "x"}, {PlyProperty::y, "y"}, {PlyProperty::z, "z"}}) {
        if (!has(e, role)) fail_input(file, e.line, header, std::string("vertices have no property ") + name);
      }
    }
    if (e.role == PlyElement::face && !has(e, PlyProperty::corners)) {
      fail_input(file, e.line, header, "faces have no list vertex_indices");
    }
  }
}

}  // namespace

PlyHeader read_ply_header(const std::string& file, std::string_view bytes) {
  TextScanner in(file, bytes, {.comments = false, .continuations = false});
  PlyHeader result;
  if (in.token() != "ply") in.fail(header, "the file does not begin with the word ply");
  bool has_format = false;
  for (;;) {
    if (!in.at_line_end() && in.line() > 1) in.fail(header, quoted(in.token()) + " is one word too many");
    in.next_line();
    if (!in.find_token()) in.fail(header, "the file ends before end_header");
    const std::string_view word = in.token();
    if (word == "end_header") break;
    if (word == "comment" || word == "obj_info") {
      in.rest_of_line();
    } else if (word == "format") {
      read_format(in, result);
      has_format = true;
    } else if (word == "element") {
      read_element(in, result);
    } else if (word == "property") {
      read_property(in, result);
    } else {
      in.fail(header, quoted(word) + " is no word of a PLY header");
    }
  }
  if (!has_format) in.fail(header, "says no format");
  result.body = in.offset();
  while (result.body < bytes.size() && (bytes[result.body] == ' ' || bytes[result.body] == '\r')) ++result.body;
  if (result.body < bytes.size() && bytes[result.body] != '\n') in.fail(header, "end_header does not end its line");
  result.body = std::min(result.body + 1, bytes.size());
  result.body_line = in.line() + 1;
  check(file, result);
  return result;
}

}  // namespace sightline
