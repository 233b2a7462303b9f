// The file of a field: numbers in as few bytes as they need, samples as runs of equal ones.
#include "sample/field_file.hpp"

#include "scene/read.hpp"

#include <algorithm>
#include <bit>

namespace sightline {
namespace {

class Writer {
 public:
  std::string take() {
    const std::uint64_t sum = field_checksum(out_);
    raw(sum);
    return std::move(out_);
  }

  void line(std::string_view text) { out_ += text; }
  void number(std::uint64_t n) {
    for (; n >= 0x80; n >>= 7) out_.push_back(static_cast<char>(0x80 | (n & 0x7f)));
    out_.push_back(static_cast<char>(n));
  }
  void text(const std::string& words) {
    number(words.size());
    out_ += words;
  }
  void real(double value) { raw(std::bit_cast<std::uint64_t>(value)); }
  void vector(const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) real(v[k]);
  }

 private:
  void raw(std::uint64_t n) {
    for (int k = 0; k < 8; ++k) out_.push_back(static_cast<char>(n >> (8 * k) & 0xff));
  }
  std::string out_;
};

void put(Writer& w, const FieldSlab& slab) {
  w.number(slab.infinite ? 1 : 0);
  for (const FieldPlane* p : {&slab.uv, &slab.st}) {
    w.vector(p->corner);
    w.vector(p->across);
    w.vector(p->upwards);
  }
  w.real(slab.begin);
  w.real(slab.end);
}

void put(Writer& w, const FieldCells& cells) {
  w.number(cells.of.size());
  w.number(cells.count);
  std::int64_t before = 0;  // neighbours in the file are mostly neighbours in the scene
  for (const std::uint32_t cell : cells.of) {
    const std::int64_t now = cell == none ? 0 : std::int64_t{cell} + 1, step = now - before;
    w.number(step < 0 ? static_cast<std::uint64_t>(-2 * step - 1) : static_cast<std::uint64_t>(2 * step));
    before = now;
  }
}

void put_lists(Writer& w, const Field& field) {
  w.number(field.list_count());
  for (std::uint32_t k = 0; k < field.list_count(); ++k) {
    w.number(field.list(k).size());
    std::uint32_t before = 0;
    for (const std::uint32_t member : field.list(k)) {
      w.number(member - before);
      before = member;
    }
  }
}

void put(Writer& w, const FieldLevel& level) {
  for (std::size_t k = 0, next; k < level.lists.size(); k = next) {
    next = k + 1;
    const std::size_t end = std::min(level.lists.size(), k + longest_field_run);
    while (next < end && level.lists[next] == level.lists[k]) ++next;
    w.number(level.lists[k]);
    w.number(next - k);
  }
}

}  // namespace

std::string field_bytes(const Field& field) {
  Writer w;
  w.line(field_file_line);
  w.text(field.source);
  w.text(field.cells);
  w.number(field.ids);
  w.number(field.rays);
  for (const std::uint32_t n : field.levels.front().size) w.number(n);
  w.number(field.slabs.size());
  for (const FieldSlab& slab : field.slabs) put(w, slab);
  put(w, field.partition);
  put_lists(w, field);
  w.number(field.levels.size());
  for (const FieldLevel& level : field.levels) put(w, level);
  return w.take();
}

void write_field(const std::filesystem::path& file, const Field& field) { write_file(file, field_bytes(field)); }

}  // namespace sightline
