#include "verify/read_binary.hpp"

#include <cmath>
#include <functional>
#include <map>

namespace sightline::verify {

namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  bool list = false;
  Type count{}, type{};
  std::string name;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

Type parse_type(const Text& text, std::string_view name) {
  static const std::map<std::string_view, Type> types{
      {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
      {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
      {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
      {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};
  const auto found = types.find(name);
  if (found == types.end()) text.fail("an unknown type of property");
  return found->second;
}

double read_value(Bytes& in, Type type) {
  switch (type) {
    case Type::int8:
      return in.next<std::int8_t>();
    case Type::uint8:
      return in.next<std::uint8_t>();
    case Type::int16:
      return in.next<std::int16_t>();
    case Type::uint16:
      return in.next<std::uint16_t>();
    case Type::int32:
      return in.next<std::int32_t>();
    case Type::uint32:
      return in.next<std::uint32_t>();
    case Type::float32:
      return in.next<float>();
    case Type::float64:
      return in.next<double>();
  }
  return 0;
}

std::vector<Element> read_header(Text& text, std::string& format) {
  std::vector<Element> elements;
  if (text.token() != "ply") text.fail("does not begin with ply");
  for (text.next_line();; text.next_line()) {
    if (!text.more()) text.fail("the header does not end");
    const std::string_view key = text.token();
    if (key == "end_header") break;
    if (key == "format") {
      format = text.token();
    } else if (key == "element") {
      Element element;
      element.name = text.token();
      element.count = text.integer("the number of elements");
      elements.push_back(element);
    } else if (key == "property") {
      if (elements.empty()) text.fail("a property of no element");
      Property property;
      std::string_view type = text.token();
      if (type == "list") {
        property.list = true;
        property.count = parse_type(text, text.token());
        type = text.token();
      }
      property.type = parse_type(text, type);
      property.name = text.token();
      elements.back().properties.push_back(property);
    } else if (key != "comment" && key != "obj_info") {
      text.fail("an unknown line in the header");
    }
  }
  text.next_line();
  return elements;
}

/// Reads all elements; `value` gives the next number (of a type), `end` is called after each element.
void read_elements(const std::string& file, const std::vector<Element>& elements, Soup& soup,
                   const std::function<double(Type)>& value, const std::function<void()>& begin,
                   const std::function<void()>& end) {
  const auto fail = [&](const std::string& what) { throw InputError(file + ": " + what); };
  for (const Element& element : elements) {
    if (element.properties.empty()) fail("element " + element.name + " has no property");
    for (std::int64_t i = 0; i < element.count; ++i) {
      begin();
      std::array<double, 3> p{};
      for (const Property& property : element.properties) {
        const double count = property.list ? value(property.count) : 1;
        if (!(count >= 0) || count != std::floor(count) || count > UINT32_MAX) fail("a count is no natural number");
        const bool corners = element.name == "face" && property.list &&
                             (property.name == "vertex_indices" || property.name == "vertex_index");
        for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(count); ++k) {
          const double x = value(property.type);
          if (corners) {
            if (!(x >= 0) || x > UINT32_MAX || x != std::floor(x)) fail("a face with no such vertex");
            soup.corners.push_back(static_cast<std::uint32_t>(x));
          } else if (element.name == "vertex" && !property.list && property.name.size() == 1) {
            const auto axis = static_cast<std::size_t>(property.name[0] - 'x');
            if (axis < 3) p[axis] = x;
          }
        }
      }
      if (element.name == "vertex") {
        for (const double x : p) {
          if (!std::isfinite(x)) fail("vertex " + std::to_string(i) + ": a coordinate is not finite");
        }
        soup.vertices.push_back(p);
      } else if (element.name == "face") {
        if (soup.corners.size() - soup.first.back() < 3) {
          fail("polygon " + std::to_string(i) + " has fewer than 3 corners");
        }
        soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
      }
      end();
    }
  }
}

}  // namespace

Soup read_ply(const std::string& file, std::string_view bytes) {
  Soup soup;
  Text text(file, bytes);
  std::string format;
  const std::vector<Element> elements = read_header(text, format);
  if (format == "ascii") {
    read_elements(
        file, elements, soup, [&](Type) { return text.number("a value"); },
        [&] {
          if (!text.more()) text.fail("ends too early");
        },
        [&] { text.next_line(); });
  } else if (format == "binary_little_endian" || format == "binary_big_endian") {
    Bytes in(file, {text.position(), static_cast<std::size_t>(text.end() - text.position())},
             format == "binary_big_endian");
    read_elements(
        file, elements, soup, [&](Type type) { return read_value(in, type); }, [] {}, [] {});
  } else {
    text.fail("an unknown format of PLY");
  }
  return soup;
}

}  // namespace sightline::verify
