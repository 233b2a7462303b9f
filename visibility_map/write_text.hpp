// Appending to a text, independent of the locale. For this folder's own use.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>

namespace sightline::text {

/// `value` with at most `digits` significant digits, as "%.<digits>g" in the C locale; -0 becomes 0.
inline void append(std::string& out, double value, int digits = 17) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0, std::chars_format::general, digits).ptr;
  out.append(buffer, end);
}

template <class Int>
requires std::is_integral_v<Int>
void append(std::string& out, Int value) {
  char buffer[24];
  out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

/// `value`, or null where it is `none`.
inline void append_or_null(std::string& out, std::uint32_t value) {
  if (value == 0xffffffffu) {
    out += "null";
  } else {
    append(out, value);
  }
}

/// `value` with at most `decimals` digits after the point, without trailing zeros: short numbers for drawings.
inline void append_fixed(std::string& out, double value, int decimals) {
  char buffer[400];
  char* end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr;
  if (decimals > 0) {
    while (end[-1] == '0') --end;
    if (end[-1] == '.') --end;
  }
  const bool zero = end - buffer == 2 && buffer[0] == '-' && buffer[1] == '0';
  out.append(zero ? buffer + 1 : buffer, end);
}

/// Length of the valid UTF-8 sequence that begins at text[at]; 0 where there is none.
std::size_t utf8_length(const std::string& text, std::size_t at);
/// The text with bytes that are no UTF-8 replaced by U+FFFD.
std::string utf8(const std::string& value);
/// A JSON string in quotes; bytes that are no UTF-8 become U+FFFD.
void append_json_string(std::string& out, const std::string& value);
/// Text for XML content and attributes; bytes that are no UTF-8 and characters that XML forbids become U+FFFD.
void append_xml(std::string& out, const std::string& value);

}  // namespace sightline::text
