#include "scene/byte_order.hpp"
#include "scene/ply_header.hpp"
#include "scene/polygon_collector.hpp"
#include "scene/readers.hpp"

#include <bit>
#include <cmath>

namespace sightline {
namespace {

/// The numbers of an ASCII body, wherever its lines end.
class AsciiBody {
 public:
  AsciiBody(const std::string& file, std::string_view bytes, const PlyHeader& header)
      : in_(file, bytes.substr(header.body), {.comments = false, .continuations = false}, header.body_line) {}

  static std::size_t least_bytes(const PlyType&) { return 2; }  // a digit and a blank
  /// The last number of a file needs no blank behind it.
  std::size_t room() const { return in_.remaining() + 1; }
  double coordinate(const PlyType&, const Item& item) {
    find(item);
    return in_.number(item, "number");
  }
  std::int64_t integer(const PlyType& type, const Item& item) {
    find(item);
    if (type.kind != PlyType::real) return in_.integer(item, "number");
    const double value = in_.number(item, "number");
    if (value != std::floor(value) || std::abs(value) > 0x1p53) fail(item, "an index is not an integer");
    return static_cast<std::int64_t>(value);
  }
  void skip(const PlyType&, std::uint64_t count, const Item& item) {
    for (; count > 0; --count) {
      find(item);
      in_.skip_number(item);
    }
  }
  [[noreturn]] void fail(const Item& item, const std::string& what) const { in_.fail(item, what); }
  bool nothing_left() { return !in_.find_token(); }

 private:
  void find(const Item& item) {
    if (!in_.find_token()) in_.fail(item, "the file ends before it is complete");
  }
  TextScanner in_;
};

class BinaryBody {
 public:
  BinaryBody(const std::string& file, std::string_view bytes, const PlyHeader& header)
      : file_(file), left_(bytes.substr(header.body)), big_endian_(header.format == PlyHeader::big_endian) {}

  static std::size_t least_bytes(const PlyType& type) { return type.size; }
  std::size_t room() const { return left_.size(); }
  double coordinate(const PlyType& type, const Item& item) {
    const double value = number(type, item);
    if (!std::isfinite(value)) fail(item, "a coordinate is not a finite number");
    return value;
  }
  std::int64_t integer(const PlyType& type, const Item& item) {
    const double value = number(type, item);
    if (!(value == std::floor(value) && std::abs(value) <= 0x1p53)) fail(item, "an index is not an integer");
    return static_cast<std::int64_t>(value);
  }
  void skip(const PlyType& type, std::uint64_t count, const Item& item) {
    if (count > left_.size() / type.size) fail(item, "the file ends before it is complete");
    left_.remove_prefix(count * type.size);
  }
  [[noreturn]] void fail(const Item& item, const std::string& what) const { fail_input(file_, 0, item, what); }
  bool nothing_left() const { return left_.find_first_not_of(" \t\r\n") == std::string_view::npos; }

 private:
  /// Every type fits a double exactly.
  double number(const PlyType& type, const Item& item) {
    const char* const bytes = left_.data();
    skip(type, 1, item);
    const std::uint64_t word = load_bytes(bytes, type.size, big_endian_);
    if (type.kind == PlyType::natural) return static_cast<double>(word);
    if (type.kind == PlyType::real) {
      return type.size == 8 ? std::bit_cast<double>(word)
                            : double{std::bit_cast<float>(static_cast<std::uint32_t>(word))};
    }
    const int unused = 64 - 8 * type.size;
    return static_cast<double>(static_cast<std::int64_t>(word << unused) >> unused);
  }

  const std::string& file_;
  std::string_view left_;
  bool big_endian_;
};

template <class Body>
class PlyBodyReader {
 public:
  PlyBodyReader(const std::string& file, std::string_view bytes, const PlyHeader& header)
      : file_(file), header_(header), body_(file, bytes, header), collector_(header.vertices) {}

  PolygonSoup read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // its records take no bytes
      check_room(element);
      for (std::uint64_t k = 0; k < element.count; ++k) record(element, k);
    }
    if (!body_.nothing_left()) body_.fail({"file"}, "more numbers follow than the header counts");
    return std::move(collector_.soup);
  }

 private:
  void check_room(const PlyElement& element) {
    std::size_t bytes = 0;
    for (const PlyProperty& p : element.properties) bytes += Body::least_bytes(p.is_list ? p.count : p.value);
    if (element.count > body_.room() / bytes) {
      fail_input(file_, element.line, {"header"},
                 "says " + std::to_string(element.count) + " elements, which the file has no room for");
    }
    if (element.role == PlyElement::vertex) collector_.soup.vertices.reserve(element.count);
    if (element.role == PlyElement::face) collector_.soup.first.reserve(element.count + 1);
  }

  void record(const PlyElement& element, std::uint64_t index) {
    static constexpr const char* kinds[] = {"element", "vertex", "polygon"};
    const Item item{kinds[element.role], index};
    glm::dvec3 place{};
    for (const PlyProperty& p : element.properties) {
      if (p.role == PlyProperty::corners) {
        polygon(p, item);
      } else if (p.is_list) {
        body_.skip(p.value, length(p, item), item);
      } else if (p.role == PlyProperty::other) {
        body_.skip(p.value, 1, item);
      } else {
        place[p.role - PlyProperty::x] = body_.coordinate(p.value, item);
      }
    }
    if (element.role == PlyElement::vertex) collector_.soup.vertices.push_back(place);
  }

  std::uint64_t length(const PlyProperty& list, const Item& item) {
    const std::int64_t count = body_.integer(list.count, item);
    if (count < 0) body_.fail(item, "a list has a negative length");
    return static_cast<std::uint64_t>(count);
  }

  void polygon(const PlyProperty& list, const Item& item) {
    const auto check = [&](const std::string& problem) {
      if (!problem.empty()) body_.fail(item, problem);
    };
    for (std::uint64_t k = length(list, item); k > 0; --k)
      check(collector_.add_corner(body_.integer(list.value, item)));
    check(collector_.end_polygon());
  }

  const std::string& file_;
  const PlyHeader& header_;
  Body body_;
  PolygonCollector collector_;
};

}  // namespace

PolygonSoup read_ply(const std::string& file, std::string_view bytes) {
  const PlyHeader header = read_ply_header(file, bytes);
  return header.format == PlyHeader::ascii ? PlyBodyReader<AsciiBody>(file, bytes, header).read()
                                           : PlyBodyReader<BinaryBody>(file, bytes, header).read();
}

}  // namespace sightline
