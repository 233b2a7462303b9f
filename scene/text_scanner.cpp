#include "scene/text_scanner.hpp"

#include <charconv>
#include <cmath>
#include <utility>

namespace sightline {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Of a well-formed decimal that from_chars calls out of range: is it too large (else it is too near to zero)? A number
/// out of range is beyond 1e308 or below 1e-307, so the decimal exponent of its first digit tells by its sign.
bool too_large(const char* at, const char* end) {
  std::int64_t exponent = 0;  // of the first digit other than 0
  bool found = false, fraction = false;
  if (at != end && *at == '-') ++at;
  for (; at != end && (is_digit(*at) || *at == '.'); ++at) {
    if (*at == '.') {
      fraction = true;
      continue;
    }
    if (*at != '0') found = true;
    if (fraction ? !found : found) exponent += fraction ? -1 : 1;
  }
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    if (at != end && *at == '+') ++at;
    std::int64_t written = 0;
    const bool negative = at != end && *at == '-';
    if (std::from_chars(at, end, written).ec == std::errc::result_out_of_range) return !negative;
    exponent = std::abs(written) > INT64_MAX / 2 ? written : exponent + written;
  }
  return exponent > 0;
}

}  // namespace

void fail_input(const std::string& file, std::size_t line, const Item& item, const std::string& what) {
  std::string message = file + ":";
  if (line != 0) message += std::to_string(line) + ":";
  message.append(" ").append(item.kind);
  if (item.index != Item::npos) message.append(" ").append(std::to_string(item.index));
  throw InputError(message.append(": ").append(what));
}

std::string quoted(std::string_view token) {
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for (char c : token.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > longest ? "...'" : "'");
}

TextScanner::TextScanner(std::string file, std::string_view text, Style style, std::size_t line)
    : file_(std::move(file)),
      style_(style),
      begin_(text.data()),
      at_(text.data()),
      end_(text.data() + text.size()),
      line_(line) {}

const char* TextScanner::continuation() const {
  if (!style_.continuations || *at_ != '\\') return nullptr;
  const char* next = at_ + 1;
  while (next != end_ && is_blank(*next)) ++next;
  return next != end_ && *next == '\n' ? next + 1 : nullptr;
}

void TextScanner::skip_blanks() {
  while (at_ != end_) {
    if (is_blank(*at_)) {
      ++at_;
      continue;
    }
    if (const char* next = continuation()) {
      at_ = next;
      ++line_;
      continue;
    }
    if (*at_ == '#' && style_.comments) {
      while (at_ != end_ && *at_ != '\n') ++at_;
    }
    return;
  }
}

bool TextScanner::at_line_end() {
  skip_blanks();
  return at_ == end_ || *at_ == '\n';
}

void TextScanner::next_line() {
  while (!at_line_end()) token();
  if (at_ == end_) return;
  ++at_;
  ++line_;
}

bool TextScanner::find_token() {
  while (at_line_end()) {
    if (at_ == end_) return false;
    next_line();
  }
  return true;
}

bool TextScanner::at_token_end() const {
  return at_ == end_ || *at_ == '\n' || is_blank(*at_) || continuation() != nullptr;
}

std::string_view TextScanner::token() {
  skip_blanks();
  const char* first = at_;
  while (!at_token_end()) ++at_;
  return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view TextScanner::rest_of_line() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  const char* first = at_;
  while (at_ != end_ && *at_ != '\n') ++at_;
  const char* last = at_;
  while (last != first && is_blank(last[-1])) --last;
  return {first, static_cast<std::size_t>(last - first)};
}

bool TextScanner::take(char c) {
  if (!next_is(c)) return false;
  ++at_;
  return true;
}

double TextScanner::number(const Item& item, const char* what) {
  if (at_line_end()) fail(item, std::string(what) + " is missing");
  const char* first = at_;
  if (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-') ++at_;
  double value = 0;
  const auto [stop, error] = std::from_chars(at_, end_, value);
  const char* digits = std::exchange(at_, stop);
  if (error == std::errc::invalid_argument || !at_token_end()) {
    at_ = first;
    fail_token(item, "is not a number");
  }
  if (error == std::errc::result_out_of_range) {
    if (too_large(digits, stop)) {
      at_ = first;
      fail_token(item, "is too large for a double");
    }
    return *digits == '-' ? -0.0 : 0.0;
  }
  if (!std::isfinite(value)) {
    at_ = first;
    fail_token(item, "is not a finite number");
  }
  return value;
}

void TextScanner::skip_number(const Item& item) {
  const char* first = at_;
  at_ += at_ != end_ && *at_ == '+' && at_ + 1 != end_ && at_[1] != '-';
  double value = 0;
  const auto [stop, error] = std::from_chars(at_, end_, value);
  at_ = stop;
  if (error == std::errc::invalid_argument || !at_token_end()) {
    at_ = first;
    fail_token(item, "is not a number");
  }
}

std::int64_t TextScanner::integer(const Item& item, const char* what, char stop) {
  if (at_line_end()) fail(item, std::string(what) + " is missing");
  const char* first = at_;
  if (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-') ++at_;
  std::int64_t value = 0;
  const auto [last, error] = std::from_chars(at_, end_, value);
  at_ = last;
  if (error == std::errc{} && (at_token_end() || (stop != 0 && *at_ == stop))) return value;
  at_ = first;
  fail_token(item, error == std::errc::result_out_of_range ? "is out of range" : "is not an integer");
}

void TextScanner::fail(const Item& item, const std::string& what) const { fail_input(file_, line_, item, what); }

void TextScanner::fail_token(const Item& item, const char* problem) { fail(item, quoted(token()) + " " + problem); }

}  // namespace sightline
