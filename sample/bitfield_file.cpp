#include "sample/bitfield_file.hpp"

#include "sample/bitfield_hull.hpp"
#include "sample/bitfield_viewpoints.hpp"
#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sightline {
namespace {

constexpr unsigned most_pixels = 16384;
constexpr std::uint64_t most_bits = std::uint64_t{1} << 34;  // in all fields: 2 GiB
/// The longest run of equal bits. Of a longer one the rest stands behind a run of no other bits, " 1024 0 7", so that
/// no file is much smaller than what it becomes in memory, and its size bounds what reading it takes.
constexpr std::uint32_t longest_run = 1024;

template <class Number>
void append(std::string& text, Number value, int base = 10) {
  char digits[40];
  std::to_chars_result end{};
  if constexpr (std::is_floating_point_v<Number>) {
    end = std::to_chars(digits, digits + sizeof digits, value);
  } else {
    end = std::to_chars(digits, digits + sizeof digits, value, base);
  }
  text.append(digits, end.ptr);
}

void append(std::string& text, const glm::dvec3& v) {
  for (int k = 0; k < 3; ++k) append(text += ' ', v[k]);
}

/// Lengths of runs of equal bits, zeros first.
std::string runs_of(const IdBitfield& field) {
  std::string text;
  bool set = false;  // what the next run is of
  for (std::uint32_t at = 0, end = 0; at < field.size(); at = end, set = !set) {
    while (end < field.size() && end - at < longest_run && field.test(end) == set) ++end;
    append(text += ' ', end - at);
  }
  return text;
}

std::string words_of(const IdBitfield& field) {
  std::string text;
  for (const std::uint64_t w : field.words()) append(text += ' ', w, 16);
  return text;
}

class BitfieldReader {
 public:
  BitfieldReader(const std::string& file, std::string_view text)
      : file_(file), in_(file, text, {.comments = false, .continuations = false}) {}

  BitfieldSamples read() {
    read_header();
    const std::uint32_t count = read_settings();
    for (std::uint32_t k = 0; k < count; ++k) read_sample({"sample", k}, bits_);
    if (in_.find_token()) in_.fail({"end"}, "more than the samples that were announced");
    check_directions();
    return std::move(out_);
  }

 private:
  void read_header() {
    const Item item{"header"};
    if (in_.token() != "sightline-bitfield") in_.fail(item, "not a bitfield file");
    if (in_.integer(item, "version") != 1) in_.fail(item, "not version 1");
    end_line(item);
  }

  std::uint32_t read_settings() {
    word({"source"}, "source");
    out_.source = in_.rest_of_line();
    in_.next_line();
    out_.polygons = setting("polygons", 0, none);
    word({"scene"}, "scene");
    out_.scene_number = hexadecimal({"scene"});
    end_line({"scene"});
    word({"centre"}, "centre");
    out_.centre = vector({"centre"});
    end_line({"centre"});
    word({"taken"}, "taken");
    const std::string_view how = in_.token();
    if (how != "exact" && how != "pixels") in_.fail({"taken"}, "neither exact nor pixels");
    out_.exact = how == "exact";
    if (!out_.exact) out_.pixels = number({"taken"}, "pixels", 1, most_pixels);
    end_line({"taken"});
    out_.fill_rounds = setting("fill", 0, std::numeric_limits<unsigned>::max());
    word({"patch"}, "patch");
    out_.patch = number({"patch"}, "patch", 0, none);
    bits_ = number({"patch"}, "bits", 0, out_.polygons);
    if (out_.patch == 0 && bits_ != out_.polygons) in_.fail({"patch"}, "without patches there is a bit a polygon");
    end_line({"patch"});
    const std::uint32_t count = setting("samples", least_viewpoints, most_viewpoints);
    if (std::uint64_t{count} * bits_ > most_bits) fail_input(file_, in_.line() - 1, {"samples"}, "too many bits");
    return count;
  }

  void read_sample(const Item& item, std::uint32_t bits) {
    word(item, "camera");
    Camera camera;
    for (glm::dvec3* v : {&camera.eye, &camera.forward, &camera.right, &camera.up}) *v = vector(item);
    end_line(item);
    out_.cameras.push_back(camera);
    const std::string_view form = in_.token();
    if (form != "runs" && form != "words") in_.fail(item, "neither runs nor words");
    out_.fields.push_back(form == "runs" ? runs(item, bits) : words(item, bits));
    end_line(item);
  }

  /// An empty field, if what is left of the file can hold that many bits: `most` of them a character.
  IdBitfield field_of(const Item& item, std::uint32_t bits, std::uint64_t most) {
    if (bits > most * in_.remaining()) in_.fail(item, "the file ends within it");
    return IdBitfield(bits);
  }

  IdBitfield runs(const Item& item, std::uint32_t bits) {
    IdBitfield field = field_of(item, bits, longest_run / 4);  // " 1024" at least
    std::uint32_t at = 0;
    for (bool set = false; !in_.at_line_end(); set = !set) {
      const std::uint32_t length = number(item, "run", 0, std::min(bits - at, longest_run));
      for (std::uint32_t k = 0; set && k < length; ++k) field.set(at + k);
      at += length;
    }
    if (at != bits) in_.fail(item, "runs of " + std::to_string(at) + " bits, not " + std::to_string(bits));
    return field;
  }

  IdBitfield words(const Item& item, std::uint32_t bits) {
    IdBitfield field = field_of(item, bits, 64);  // " 0" at least
    for (std::uint32_t k = 0; k < field.words().size(); ++k) {
      const std::uint64_t w = hexadecimal(item);
      if (64 * std::uint64_t{k} + 64 - static_cast<unsigned>(std::countl_zero(w)) > bits && w != 0) {
        in_.fail(item, "a bit beyond the last");
      }
      field.join_word(k, w);
    }
    return field;
  }

  void check_directions() {
    try {
      std::vector<ViewDirection> directions;
      for (const Camera& c : out_.cameras) directions.push_back(view_direction(c.eye - out_.centre));
      const ViewHull hull(std::move(directions));
    } catch (const std::invalid_argument& error) {
      fail_input(file_, 0, {"samples"}, error.what());
    }
  }

  std::uint32_t setting(const char* name, std::uint32_t least, std::uint32_t most) {
    word({name}, name);
    const std::uint32_t value = number({name}, name, least, most);
    end_line({name});
    return value;
  }

  std::uint32_t number(const Item& item, const char* what, std::uint32_t least, std::uint32_t most) {
    const std::int64_t value = in_.integer(item, what);
    if (value < least || value > most)
      in_.fail(item, std::string(what) + " " + std::to_string(value) + " out of range");
    return static_cast<std::uint32_t>(value);
  }

  std::uint64_t hexadecimal(const Item& item) {
    const std::string_view digits = in_.token();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (error != std::errc() || end != digits.data() + digits.size()) {
      in_.fail(item, digits.empty() ? "a number is missing" : quoted(digits) + " is no hexadecimal number");
    }
    return value;
  }

  glm::dvec3 vector(const Item& item) {
    glm::dvec3 v;
    for (int k = 0; k < 3; ++k) v[k] = in_.number(item, "coordinate");
    return v;
  }

  void word(const Item& item, std::string_view expected) {
    const std::string_view token = in_.token();
    if (token == expected) return;
    if (token.empty()) in_.fail(item, in_.at_end() ? "the file ends before it" : "missing");
    in_.fail(item, quoted(token) + " where '" + std::string(expected) + "' should stand");
  }

  void end_line(const Item& item) {
    if (!in_.at_line_end()) in_.fail(item, quoted(in_.token()) + " is too much");
    if (in_.at_end()) in_.fail(item, "the file ends within it");
    in_.next_line();
  }

  const std::string& file_;
  TextScanner in_;
  BitfieldSamples out_;
  std::uint32_t bits_ = 0;  // of each field
};

}  // namespace

std::string bitfield_text(const BitfieldSamples& samples) {
  std::string source = samples.source;
  for (char& c : source) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '_';
  }
  if (source.starts_with(' ')) source.front() = '_';  // blanks at the ends would not be read back
  if (source.ends_with(' ')) source.back() = '_';
  std::string text = "sightline-bitfield 1\nsource " + source + "\npolygons ";
  append(text, samples.polygons);
  append(text += "\nscene ", samples.scene_number, 16);
  append(text += "\ncentre", samples.centre);
  text += samples.exact ? "\ntaken exact" : "\ntaken pixels ";
  if (!samples.exact) append(text, samples.pixels);
  append(text += "\nfill ", samples.fill_rounds);
  append(text += "\npatch ", samples.patch);
  append(text += ' ', samples.fields.empty() ? 0 : samples.fields.front().size());
  append(text += "\nsamples ", samples.cameras.size());
  text += '\n';
  for (std::size_t k = 0; k < samples.cameras.size(); ++k) {
    const Camera& c = samples.cameras[k];
    text += "camera";
    for (const glm::dvec3* v : {&c.eye, &c.forward, &c.right, &c.up}) append(text, *v);
    const std::string runs = runs_of(samples.fields[k]), words = words_of(samples.fields[k]);
    text += runs.size() <= words.size() ? "\nruns" + runs : "\nwords" + words;
    text += '\n';
  }
  return text;
}

BitfieldSamples parse_bitfield(const std::string& file, std::string_view text) {
  return BitfieldReader(file, text).read();
}

BitfieldSamples read_bitfield(const std::filesystem::path& file) {
  return parse_bitfield(file.string(), load_file(file.string()));
}

}  // namespace sightline
