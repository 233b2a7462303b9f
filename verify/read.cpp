#include "verify/read.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace sightline::verify {

std::string load_file(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw InputError(file + ": is a folder");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file + ": cannot be read: " + std::strerror(errno));
  std::string content(std::istreambuf_iterator<char>(in), {});
  if (in.bad()) throw InputError(file + ": cannot be read");
  if (content.empty()) throw InputError(file + ": is empty");
  return content;
}

Soup read_scene(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto reader = extension == ".obj"   ? read_obj
                      : extension == ".off" ? read_off
                      : extension == ".ply" ? read_ply
                      : extension == ".stl" ? read_stl
                                            : nullptr;
  if (!reader) throw InputError(file + ": is no .obj, .ply, .off or .stl file");
  const std::string content = load_file(file);
  Soup soup = reader(file, content);
  check_soup(file, soup);
  return soup;
}

void check_soup(const std::string& file, const Soup& soup) {
  if (soup.polygon_count() == 0) throw InputError(file + ": holds no polygon");
  for (std::uint32_t k = 0; k < soup.polygon_count(); ++k) {
    for (std::uint32_t i = soup.first[k]; i < soup.first[k + 1]; ++i) {
      if (soup.corners[i] >= soup.vertices.size()) {
        throw InputError(file + ": polygon " + std::to_string(k) + ": there is no vertex " +
                         std::to_string(soup.corners[i]));
      }
    }
  }
}

void Text::fail(const std::string& what) const { throw InputError(file_ + ":" + std::to_string(line_) + ": " + what); }

bool Text::more_on_line() {
  while (at_ != end_) {
    if (*at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\f' || *at_ == '\v') {
      ++at_;
    } else if (*at_ == '\\' && end_ - at_ >= 2 && (at_[1] == '\n' || (at_[1] == '\r' && end_ - at_ >= 3))) {
      at_ += at_[1] == '\n' ? 2 : 3;
      ++line_;
    } else {
      return *at_ != '\n' && *at_ != '#';
    }
  }
  return false;
}

void Text::next_line() {
  while (at_ != end_ && *at_ != '\n') ++at_;
  if (at_ != end_) {
    ++at_;
    ++line_;
  }
}

bool Text::more() {
  while (!more_on_line()) {
    if (at_ == end_) return false;
    next_line();
  }
  return true;
}

std::string_view Text::token() {
  if (!more_on_line()) return {};
  const char* begin = at_;
  while (at_ != end_ && !std::isspace(static_cast<unsigned char>(*at_))) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

double Text::number(const char* what) {
  if (!more_on_line()) fail(std::string(what) + " is missing");
  const std::string_view text = token();
  const char *begin = text.data(), *end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range) {  // too large, or so small that it rounds to a subnormal or to 0
    value = std::strtod(std::string(text).c_str(), nullptr);
    error = std::errc();
  }
  if (error != std::errc() || stop != end) fail(std::string(what) + " is no number");
  if (!std::isfinite(value)) fail(std::string(what) + " is not finite");
  return value;
}

std::int64_t Text::integer(const char* what, bool stop_at_slash) {
  if (!more_on_line()) fail(std::string(what) + " is missing");
  const std::string_view text = token();
  const char *begin = text.data(), *end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || (stop != end && !(stop_at_slash && *stop == '/'))) {
    fail(std::string(what) + " is no integer");
  }
  return value;
}

Soup read_obj(const std::string& file, std::string_view bytes) {
  Soup soup;
  Text text(file, bytes);
  while (text.more()) {
    const std::string_view key = text.token();
    if (key == "v") {
      std::array<double, 3> p{};
      for (double& x : p) x = text.number("a coordinate");
      soup.vertices.push_back(p);
    } else if (key == "f") {
      while (text.more_on_line()) {
        const std::int64_t index = text.integer("a corner", true);
        const auto count = static_cast<std::int64_t>(soup.vertices.size());
        const std::int64_t vertex = index > 0 ? index - 1 : count + index;
        if (index == 0 || vertex < 0 || vertex > UINT32_MAX) text.fail("there is no vertex " + std::to_string(index));
        soup.corners.push_back(static_cast<std::uint32_t>(vertex));
      }
      if (soup.corners.size() - soup.first.back() < 3) text.fail("a face with fewer than 3 corners");
      soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
    text.next_line();
  }
  return soup;
}

}  // namespace sightline::verify
