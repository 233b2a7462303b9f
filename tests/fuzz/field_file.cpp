// A field file, as it is and with a checksum that fits: refused in one line, or in memory no larger than so many times
// the file, what is written of it reads back to the same bytes, and it can be looked up, and traced in a scene with as
// many polygons.
#include "sample/field_file.hpp"
#include "sample/field_query.hpp"
#include "scene/errors.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/sampled_scene.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace sightline;

namespace {

/// A run of samples is a byte for the list's number and two for its length, and becomes 4 bytes for each.
constexpr std::uint64_t memory_a_byte = 4 * longest_field_run;

std::optional<Field> read_one(const std::string& bytes) {
  try {
    return read_field(fuzz::as_file(bytes, ".field"));
  } catch (const InputError& error) {
    fuzz::expect_one_line(error.what());
    return {};
  }
}

std::string with_checksum(std::string bytes) {
  bytes.resize(std::max(bytes.size(), field_file_line.size() + 8) - 8);
  const std::uint64_t sum = field_checksum(bytes);
  for (int k = 0; k < 8; ++k) bytes.push_back(static_cast<char>(sum >> (8 * k) & 0xff));
  return bytes;
}

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// One within the scene, and one that looks along each of the first slabs.
std::vector<Camera> cameras_for(const Field& field) {
  std::vector<Camera> cameras{{{0.5, -3, 0.5}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};
  for (std::size_t k = 0; k < field.slabs.size() && k < 3; ++k) {
    const FieldRay ray = ray_of(field.slabs[k], {0.5, 0.25, 0.5, 0.75});
    const Camera camera{ray.origin, ray.direction, field.slabs[k].st.across, field.slabs[k].st.upwards};
    if (finite(camera.eye) && finite(camera.forward)) cameras.push_back(camera);
  }
  return cameras;
}

void look_up(const Field& field) {
  for (const Camera& camera : cameras_for(field)) {
    std::vector<std::uint32_t> nearest;
    for (const FieldFilter filter : {FieldFilter::nearest, FieldFilter::uv, FieldFilter::st, FieldFilter::uvst}) {
      for (const bool mipmap : {false, true}) {
        FieldQuery query(field, {.pixels = 9, .subsample = 2, .filter = filter, .mipmap = mipmap, .keep = 1});
        const std::vector<std::uint32_t> cells = query.mark(camera).cells;
        fuzz::expect(std::ranges::is_sorted(cells), "marked cells do not ascend");
        for (const PolygonId p : polygons_of(field.partition, cells)) {
          fuzz::expect(p < field.partition.of.size(), "a polygon that there is not");
        }
        if (filter == FieldFilter::nearest && !mipmap) nearest = cells;
        if (!mipmap) fuzz::expect(std::ranges::includes(cells, nearest), "neighbours lose a cell");
      }
    }
  }
}

void trace(const Field& field) {
  static const Scene scene = fuzz::sampled_scene();
  static const RayCaster caster(scene);
  if (scene.polygon_count() != field.partition.of.size()) return;
  for (const Camera& camera : cameras_for(field)) trace_marks(caster, scene, field.partition, camera, 9, 2);
}

void check(const std::string& bytes) {
  const std::optional<Field> field = read_one(bytes);
  if (!field) return;
  fuzz::expect(field_memory_bytes(*field) <= memory_a_byte * bytes.size(), "far larger in memory than the file is");
  const std::string written = field_bytes(*field);
  fuzz::expect(field_bytes(read_field(fuzz::as_file(written, "-again.field"))) == written,
               "what is written reads back otherwise");
  look_up(*field);
  trace(*field);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(fuzz::text(data, size));
  check(bytes);
  check(with_checksum(bytes));
  return 0;
}
