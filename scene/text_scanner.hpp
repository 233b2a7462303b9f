// Text files token by token, with line numbers for the messages. For the readers of this folder.
#pragma once

#include "scene/errors.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sightline {

/// What a message is about: "vertex 12", or just "header" when index is npos.
struct Item {
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  const char* kind;
  std::size_t index = npos;
};

/// Throws InputError "FILE:LINE: item: what"; line 0 is left out.
[[noreturn]] void fail_input(const std::string& file, std::size_t line, const Item& item, const std::string& what);
/// A piece of a file as it may stand in a message: short, printable, in quotes.
std::string quoted(std::string_view token);

/// Walks over a text that it does not own. Tokens are separated by blanks; a line ends at \n (or \r\n).
class TextScanner {
 public:
  struct Style {
    bool comments = true;        // a token that begins with # starts a comment, up to the end of the line
    bool continuations = false;  // a backslash at the end of a line joins it with the next
  };
  TextScanner(std::string file, std::string_view text, Style style, std::size_t line = 1);

  /// Nothing is left on this line (blanks and comments are skipped).
  bool at_line_end();
  /// To the beginning of the next line; does nothing at the end of the text.
  void next_line();
  /// To the next token on this or a later line; false when there is none.
  bool find_token();
  bool at_end() const { return at_ == end_; }

  /// The next token of this line; empty when there is none.
  std::string_view token();
  /// The rest of this line without blanks at its ends, comments kept.
  std::string_view rest_of_line();
  /// The next token of this line as a finite double, correctly rounded; `what` names it where it is missing.
  double number(const Item& item, const char* what);
  /// As number(), and nothing else than a number may stand there, but any (a NaN too).
  void skip_number(const Item& item);
  /// The next token as an integer; stops at `stop` too (0: at blanks only), which is left to be read.
  std::int64_t integer(const Item& item, const char* what, char stop = 0);
  bool next_is(char c) const { return at_ != end_ && *at_ == c; }
  /// Takes the character c if it is next.
  bool take(char c);
  /// Is a blank, the end of the line or the end of the text next?
  bool at_token_end() const;

  [[noreturn]] void fail(const Item& item, const std::string& what) const;
  std::size_t line() const { return line_; }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  void skip_blanks();
  /// The beginning of the next line if a backslash that joins it with this one is next, else null.
  const char* continuation() const;
  [[noreturn]] void fail_token(const Item& item, const char* problem);

  std::string file_;
  Style style_;
  const char* begin_;
  const char* at_;
  const char* end_;
  std::size_t line_;
};

}  // namespace sightline
