// Reading fields back; nothing that a file says is believed.
#include "sample/field_file.hpp"
#include "scene/byte_order.hpp"
#include "scene/errors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace sightline {
namespace {

class Reader {
 public:
  Reader(std::string file, std::string_view bytes) : file_(std::move(file)), bytes_(bytes) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ": byte " + std::to_string(at_) + ": " + what);
  }
  void must(bool fine, const char* what) const {
    if (!fine) fail(what);
  }

  /// A number of at most `most`, called `what` if it is not.
  std::uint64_t number(std::uint64_t most, const char* what) {
    std::uint64_t n = 0;
    for (int shift = 0;; shift += 7) {
      must(at_ < bytes_.size(), "the file is cut short");
      const auto byte = static_cast<unsigned char>(bytes_[at_]);
      must(shift < 63, "a number has too many digits");
      n |= std::uint64_t{byte & 0x7fU} << shift;
      ++at_;
      if (byte < 0x80) break;
    }
    if (n > most) fail(std::string(what) + ": " + std::to_string(n) + ", at most " + std::to_string(most));
    return n;
  }
  std::uint32_t small(std::uint64_t least, std::uint64_t most, const char* what) {
    const std::uint64_t n = number(most, what);
    if (n < least) fail(std::string(what) + ": " + std::to_string(n) + ", at least " + std::to_string(least));
    return static_cast<std::uint32_t>(n);
  }
  /// A number of things that take a byte each at least: there cannot be more of them than bytes.
  std::uint32_t count(const char* what) {
    return small(0, std::min<std::uint64_t>(bytes_.size() - at_, std::numeric_limits<std::uint32_t>::max() - 1), what);
  }
  std::string text(const char* what) {
    const std::uint32_t size = count(what);
    must(size <= bytes_.size() - at_, "the file is cut short");
    at_ += size;
    return std::string(bytes_.substr(at_ - size, size));
  }
  double real() {
    must(bytes_.size() - at_ >= 8, "the file is cut short");
    const auto value = std::bit_cast<double>(load_bytes(bytes_.data() + at_, 8, false));
    must(std::isfinite(value), "a coordinate is not finite");
    at_ += 8;
    return value;
  }
  glm::dvec3 vector() {
    const double x = real(), y = real();
    return {x, y, real()};
  }
  bool done() const { return at_ == bytes_.size(); }

 private:
  std::string file_;
  std::string_view bytes_;
  std::size_t at_ = field_file_line.size();
};

FieldSlab read_slab(Reader& r) {
  FieldSlab slab;
  slab.infinite = r.number(1, "kind of a slab") == 1;
  for (FieldPlane* p : {&slab.uv, &slab.st}) {
    p->corner = r.vector();
    p->across = r.vector();
    p->upwards = r.vector();
  }
  slab.begin = r.real();
  slab.end = r.real();
  r.must(slab.begin <= slab.end, "a slab ends before it begins");
  return slab;
}

FieldCells read_cells(Reader& r) {
  FieldCells cells;
  cells.of.resize(r.count("number of polygons"));
  cells.count = r.small(0, cells.of.size(), "number of cells");
  std::vector<char> used(cells.count);
  std::int64_t now = 0;
  for (std::uint32_t& cell : cells.of) {
    const std::uint64_t n = r.number(std::uint64_t{1} << 34, "a step from cell to cell");
    now += n % 2 == 0 ? static_cast<std::int64_t>(n / 2) : -static_cast<std::int64_t>(n / 2) - 1;
    r.must(now >= 0 && now <= std::int64_t{cells.count}, "a polygon lies in a cell that there is not");
    cell = now == 0 ? none : static_cast<std::uint32_t>(now - 1);
    if (cell != none) used[cell] = 1;
  }
  for (const char u : used) r.must(u != 0, "a cell holds no polygon");
  return cells;
}

void read_lists(Reader& r, Field& field) {
  const std::uint32_t lists = r.count("number of lists");
  r.must(lists > 0, "there is no list");
  for (std::uint32_t k = 0; k < lists; ++k) {
    const std::uint32_t size = r.count("length of a list");
    r.must(k > 0 || size == 0, "the first list is not empty");
    std::uint64_t member = 0;
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint64_t step = r.number(std::numeric_limits<std::uint32_t>::max(), "a step in a list");
      r.must(i == 0 || step > 0, "a list does not ascend");
      member += step;
      r.must(member < field.partition.count, "a list names a cell that there is not");
      field.members.push_back(static_cast<std::uint32_t>(member));
    }
    field.first.push_back(static_cast<std::uint32_t>(field.members.size()));
  }
}

void read_levels(Reader& r, Field& field, const std::array<std::uint32_t, 4>& samples) {
  FieldLevel level{samples, {}};
  const std::uint32_t levels = r.small(1, 13, "number of levels");
  for (std::uint32_t k = 0; k < levels; ++k) {
    const std::size_t size = field.slabs.size() * level.samples_of_slab();
    level.lists.clear();
    while (level.lists.size() < size) {
      const std::uint32_t list = r.small(0, field.list_count() - 1, "a sample's list");
      r.must(k > 0 || field.list(list).size() <= field.ids, "a sample holds too many cells");
      const std::uint32_t length =
          r.small(1, std::min(longest_field_run, size - level.lists.size()), "length of a run");
      level.lists.insert(level.lists.end(), length, list);
    }
    field.levels.push_back(level);
    r.must(k + 1 == levels || level.samples_of_slab() > 1, "there are too many levels");
    for (std::uint32_t& n : level.size) n = (n + 1) / 2;
  }
  r.must(levels == 1 || field.levels.back().samples_of_slab() == 1, "there are too few levels");
}

}  // namespace

Field read_field(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  if (in) content << in.rdbuf();
  if (!in || content.bad()) throw InputError(file.string() + ": cannot be read");
  const std::string all = std::move(content).str();
  if (all.compare(0, field_file_line.size(), field_file_line) != 0) {
    throw InputError(file.string() + ":1: is no field file: it does not begin with `sightline-field 1`");
  }
  if (all.size() < field_file_line.size() + 8) throw InputError(file.string() + ": the file is cut short");
  const std::string_view body(all.data(), all.size() - 8);
  if (load_bytes(all.data() + body.size(), 8, false) != field_checksum(body)) {
    throw InputError(file.string() + ": the file is damaged or cut short: its checksum does not fit");
  }
  Reader r(file.string(), body);
  Field field;
  field.source = r.text("length of the scene's name");
  field.cells = r.text("length of the cells' name");
  field.ids = r.small(1, 65535, "cells a sample");
  field.rays = r.small(1, 9, "rays along an axis");
  std::array<std::uint32_t, 4> samples{};
  double all_samples = 1;
  for (std::uint32_t& n : samples) {
    n = r.small(1, 4096, "samples along an axis");
    all_samples *= n;
  }
  const std::uint32_t slabs = r.count("number of slabs");
  r.must(slabs > 0, "there is no slab");
  r.must(all_samples * slabs < std::numeric_limits<std::uint32_t>::max(), "there are too many samples");
  for (std::uint32_t k = 0; k < slabs; ++k) field.slabs.push_back(read_slab(r));
  field.partition = read_cells(r);
  read_lists(r, field);
  read_levels(r, field, samples);
  r.must(r.done(), "something stands after the field's end");
  return field;
}

}  // namespace sightline
