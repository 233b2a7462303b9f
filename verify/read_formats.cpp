// OFF and STL.
#include "verify/read_binary.hpp"

#include <cmath>

namespace sightline::verify {

namespace {

double finite(const std::string& file, double x) {
  if (!std::isfinite(x)) throw InputError(file + ": a coordinate is not finite");
  return x;
}

void add_corner(const std::string& file, Soup& soup, std::int64_t index) {
  if (index < 0 || index > UINT32_MAX) throw InputError(file + ": there is no vertex " + std::to_string(index));
  soup.corners.push_back(static_cast<std::uint32_t>(index));
}

void end_polygon(const std::string& file, Soup& soup) {
  if (soup.corners.size() - soup.first.back() < 3) {
    throw InputError(file + ": polygon " + std::to_string(soup.polygon_count()) + " has fewer than 3 corners");
  }
  soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
}

Soup read_binary_off(const std::string& file, std::string_view bytes) {
  Soup soup;
  Bytes in(file, bytes, true);
  const auto vertices = in.next<std::int32_t>(), faces = in.next<std::int32_t>();
  in.skip(4);
  for (std::int32_t i = 0; i < vertices; ++i) {
    std::array<double, 3> p{};
    for (double& x : p) x = finite(file, in.next<float>());
    soup.vertices.push_back(p);
  }
  for (std::int32_t i = 0; i < faces; ++i) {
    const auto corners = in.next<std::int32_t>();
    for (std::int32_t k = 0; k < corners; ++k) add_corner(file, soup, in.next<std::int32_t>());
    end_polygon(file, soup);
    const auto colours = in.next<std::int32_t>();
    if (colours < 0) throw InputError(file + ": a negative count");
    in.skip(4 * static_cast<std::size_t>(colours));
  }
  return soup;
}

std::string small_letters(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

}  // namespace

Soup read_off(const std::string& file, std::string_view bytes) {
  Soup soup;
  Text text(file, bytes);
  if (!text.more()) text.fail("holds nothing");
  std::string_view key = text.token();
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (key.starts_with(prefix)) key.remove_prefix(prefix.size());
  }
  if (key != "OFF") text.fail("does not begin with OFF");
  if (text.more_on_line() && std::isalpha(static_cast<unsigned char>(*text.position()))) {
    if (text.token() != "BINARY") text.fail("an unknown kind of OFF");
    text.next_line();
    return read_binary_off(file, {text.position(), static_cast<std::size_t>(text.end() - text.position())});
  }
  const auto need = [&](const char* what) {
    if (!text.more()) text.fail(std::string("ends before ") + what);
  };
  need("its counts");
  const std::int64_t vertices = text.integer("the number of vertices"), faces = text.integer("the number of faces");
  text.next_line();
  for (std::int64_t i = 0; i < vertices; ++i) {
    need("all vertices");
    std::array<double, 3> p{};
    for (double& x : p) x = text.number("a coordinate");
    soup.vertices.push_back(p);
    text.next_line();
  }
  for (std::int64_t i = 0; i < faces; ++i) {
    need("all faces");
    const std::int64_t corners = text.integer("the number of corners");
    for (std::int64_t k = 0; k < corners; ++k) add_corner(file, soup, text.integer("a corner"));
    end_polygon(file, soup);
    text.next_line();
  }
  return soup;
}

Soup read_stl(const std::string& file, std::string_view bytes) {
  Soup soup;
  const auto add = [&](const std::array<double, 3>& p) {
    soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
    soup.vertices.push_back(p);
  };
  if (bytes.size() >= 84) {
    Bytes in(file, bytes.substr(80), false);
    const std::size_t count = in.next<std::uint32_t>();
    const bool whole = bytes.size() == 84 + 50 * count;
    if (!whole && small_letters(bytes.substr(0, 5)) != "solid")
      throw InputError(file + ": its size does not fit its triangle count");
    if (whole) {
      for (std::size_t i = 0; i < count; ++i) {
        in.skip(12);
        for (int k = 0; k < 3; ++k) {
          std::array<double, 3> p{};
          for (double& x : p) x = finite(file, in.next<float>());
          add(p);
        }
        end_polygon(file, soup);
        in.skip(2);
      }
      return soup;
    }
  }
  Text text(file, bytes);
  if (!text.more() || small_letters(text.token()) != "solid") text.fail("does not begin with solid");
  bool ended = false;
  for (text.next_line(); text.more(); text.next_line()) {
    const std::string key = small_letters(text.token());
    if (key == "vertex") {
      std::array<double, 3> p{};
      for (double& x : p) x = text.number("a coordinate");
      add(p);
    } else if (key == "endloop") {
      end_polygon(file, soup);
    }
    ended = key == "endsolid";
  }
  if (!ended) text.fail("ends before endsolid");
  return soup;
}

}  // namespace sightline::verify
