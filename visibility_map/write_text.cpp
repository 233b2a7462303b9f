#include "visibility_map/write_text.hpp"

namespace sightline::text {

namespace {

constexpr const char* replacement = "\xEF\xBF\xBD";  // U+FFFD

}  // namespace

std::size_t utf8_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : static_cast<unsigned char>(0);
  };
  const unsigned char lead = byte(at);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF5 ? 0 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(at + k) & 0xC0) != 0x80) return 0;
  }
  // Overlong forms, surrogates and code points above U+10FFFF.
  const unsigned char second = byte(at + 1);
  if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0)) return 0;
  if ((lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90)) return 0;
  return length;
}

std::string utf8(const std::string& value) {
  std::string out;
  for (std::size_t k = 0; k < value.size();) {
    const std::size_t length = utf8_length(value, k);
    length == 0 ? out += replacement : out.append(value, k, length);
    k += length == 0 ? 1 : length;
  }
  return out;
}

void append_json_string(std::string& out, const std::string& value) {
  out += '"';
  for (std::size_t k = 0; k < value.size();) {
    const std::size_t length = utf8_length(value, k);
    const char c = value[k];
    if (length == 0) {
      out += replacement;
    } else if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr char hex[] = "0123456789abcdef";
      out += "\\u00";
      out += hex[c >> 4];
      out += hex[c & 15];
    } else {
      out.append(value, k, length);
    }
    k += length == 0 ? 1 : length;
  }
  out += '"';
}

void append_xml(std::string& out, const std::string& value) {
  for (std::size_t k = 0; k < value.size();) {
    const std::size_t length = utf8_length(value, k);
    const char c = value[k];
    const bool control = length == 1 && static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n';
    const bool noncharacter = length == 3 && value.compare(k, 2, "\xEF\xBF") == 0 &&
                              static_cast<unsigned char>(value[k + 2]) >= 0xBE;  // U+FFFE, U+FFFF
    if (length == 0 || control || noncharacter) {
      out += replacement;
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out.append(value, k, length);
    }
    k += length == 0 ? 1 : length;
  }
}

}  // namespace sightline::text
