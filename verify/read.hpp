// Polygon files as they are: OBJ, PLY, OFF and STL.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::verify {

/// Input that cannot be used: what() is one line.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Corners of polygon k: corners[first[k] .. first[k+1]).
struct Soup {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> corners;
  std::uint32_t polygon_count() const { return static_cast<std::uint32_t>(first.size() - 1); }
};

/// A whole file; throws InputError where it cannot be read.
std::string load_file(const std::string& file);
/// Reads a scene, its format told by the extension. Throws InputError: "FILE:LINE: what is wrong". Every index is in
/// range, every coordinate finite and every polygon has at least 3 corners.
Soup read_scene(const std::string& file);

/// The readers behind it.
Soup read_obj(const std::string& file, std::string_view text);
Soup read_off(const std::string& file, std::string_view bytes);
Soup read_ply(const std::string& file, std::string_view bytes);
Soup read_stl(const std::string& file, std::string_view bytes);

/// Walks over a text by tokens, counting lines.
class Text {
 public:
  Text(const std::string& file, std::string_view text) : file_(file), at_(text.data()), end_(at_ + text.size()) {}
  [[noreturn]] void fail(const std::string& what) const;

  /// Skips blanks on the line; a comment (#) and the line's end are not a token. A backslash at the end of a line
  /// joins it with the next.
  bool more_on_line();
  void next_line();
  /// Skips blanks, comments and empty lines; false at the end of the text.
  bool more();
  /// The next token of the line; empty where there is none.
  std::string_view token();
  double number(const char* what);
  std::int64_t integer(const char* what, bool stop_at_slash = false);
  const char* position() const { return at_; }
  const char* end() const { return end_; }

 private:
  std::string file_;
  const char* at_;
  const char* end_;
  std::size_t line_ = 1;
};

/// Throws InputError where an index is out of range, or where there is no polygon at all.
void check_soup(const std::string& file, const Soup& soup);

}  // namespace sightline::verify
