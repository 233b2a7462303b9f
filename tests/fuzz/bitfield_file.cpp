// A bitfield file: refused in one line, or in memory no larger than so many times the file, what is written of it reads
// back to the same bytes, and viewers are told the same by all forms, and more by more neighbours.
#include "sample/bitfield_file.hpp"
#include "sample/bitfield_viewer.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/sampled_scene.hpp"

#include <algorithm>
#include <optional>

using namespace sightline;

namespace {

/// A run of 1,024 bits is five characters.
constexpr std::size_t bits_a_byte = 256;

std::optional<BitfieldSamples> read_one(std::string_view text) {
  try {
    return parse_bitfield("input", text);
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
    return {};
  }
}

/// What viewers around are told; nothing where the samples cannot be asked.
using Lists = std::vector<std::vector<PolygonId>>;
std::optional<Lists> lists(const BitfieldSamples& samples, unsigned neighbours, BitfieldViewing::Form form) {
  static const Scene scene = fuzz::sampled_scene();
  std::optional<BitfieldViewer> viewer;
  try {
    viewer.emplace(samples, BitfieldViewing{neighbours, form, 1}, &scene);
  } catch (const std::invalid_argument& error) {
    fuzz::expect_one_line(error.what());
    return {};
  }
  Lists told;
  for (const glm::dvec3& eye : {glm::dvec3{9, 1, 2}, {-3, -7, 1}, {0, 0, -4}, {0.5, 0.5, 0.5}}) {
    const auto polygons = viewer->look(Camera{eye}).polygons;
    told.emplace_back(polygons.begin(), polygons.end());
  }
  const auto polygons = viewer->look(samples.cameras.front()).polygons;
  told.emplace_back(polygons.begin(), polygons.end());
  return told;
}

void ask(const BitfieldSamples& samples) {
  const std::optional<Lists> six = lists(samples, 6, BitfieldViewing::lists);
  if (!six) return;
  for (const auto form : {BitfieldViewing::plain, BitfieldViewing::hierarchical, BitfieldViewing::compressed}) {
    fuzz::expect(lists(samples, 6, form) == six, "forms tell different lists");
  }
  const std::optional<Lists> one = lists(samples, 1, BitfieldViewing::plain),
                             three = lists(samples, 3, BitfieldViewing::lists);
  for (std::size_t k = 0; k < six->size(); ++k) {
    fuzz::expect(std::ranges::is_sorted((*six)[k]), "a list does not ascend");
    fuzz::expect(std::ranges::includes((*three)[k], (*one)[k]), "three neighbours lose a polygon");
    fuzz::expect(std::ranges::includes((*six)[k], (*three)[k]), "six neighbours lose a polygon");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text(data, size);
  const std::optional<BitfieldSamples> samples = read_one(text);
  if (!samples) return 0;
  std::size_t bits = 0;
  for (const IdBitfield& field : samples->fields) bits += field.size();
  fuzz::expect(bits <= bits_a_byte * size, "far larger in memory than the file is");
  const std::string written = bitfield_text(*samples);
  fuzz::expect(bitfield_text(parse_bitfield("written", written)) == written, "what is written reads back otherwise");
  ask(*samples);
  return 0;
}
