#include "sample/field_lists.hpp"
#include "sample/field_sampler.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>

namespace sightline {
namespace {

void check(const std::vector<FieldSlab>& slabs, const FieldOptions& options) {
  if (slabs.empty()) throw std::invalid_argument("a field has a slab at least");
  double samples = static_cast<double>(slabs.size());
  for (const std::uint32_t n : options.samples) {
    if (n < 1 || n > 4096) throw std::invalid_argument("samples: 1 to 4096 along each axis");
    samples *= n;
  }
  if (samples >= std::numeric_limits<std::uint32_t>::max()) throw std::length_error("the field's number of samples");
  if (options.ids < 1 || options.ids > 65535) throw std::invalid_argument("ids: 1 to 65535 a sample");
  if (options.rays % 2 == 0 || options.rays > 9) throw std::invalid_argument("rays along an axis: odd, 1 to 9");
}

/// Samples come row by row, in order.
class Gatherer {
 public:
  explicit Gatherer(Field& field) : field_(field), lists_(field) {}

  void add(const FieldRow& row) {
    std::span<const std::uint32_t> before;
    std::uint32_t number = 0;  // of the empty list
    for (std::size_t k = 0; k + 1 < row.first.size(); ++k) {
      const auto members = std::span(row.members).subspan(row.first[k], row.first[k + 1] - row.first[k]);
      if (!std::ranges::equal(members, before)) number = lists_.number(members);
      before = members;
      field_.levels.front().lists.push_back(number);
    }
  }

 private:
  Field& field_;
  FieldLists lists_;
};

}  // namespace

std::size_t field_steps(const std::vector<FieldSlab>& slabs, const FieldOptions& options) {
  return slabs.size() * options.samples[0] * options.samples[1];
}

Field build_field(const Scene& scene, const std::vector<FieldSlab>& slabs, const FieldCells& partition,
                  const FieldOptions& options, const std::function<void()>& step, FieldStats* stats) {
  check(slabs, options);
  const auto start = std::chrono::steady_clock::now();
  const RayCaster caster(scene);
  Field field;
  field.source = scene.soup().source;
  field.ids = options.ids;
  field.rays = options.rays;
  field.slabs = slabs;
  field.partition = partition;
  field.levels.push_back({options.samples, {}});
  field.levels.front().lists.reserve(slabs.size() * field.levels.front().samples_of_slab());
  Gatherer gatherer(field);
  std::atomic<std::uint64_t> rays = 0;
  tbb::task_arena arena(static_cast<int>(std::max(1u, options.threads)));
  // Some rows at a time, so that rows that wait for their turn take little room.
  const std::size_t rows = field_steps(slabs, options), most = 16 * std::max(1u, options.threads);
  const std::uint32_t along_v = options.samples[1], of_slab = options.samples[0] * along_v;
  std::vector<FieldRow> some;
  for (std::size_t from = 0; from < rows; from += most) {
    some.assign(std::min(most, rows - from), {});
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, some.size(), [&](std::size_t k) {
        const auto row = static_cast<std::uint32_t>((from + k) % of_slab);
        FieldSampler sampler(scene, caster, partition, options, slabs[(from + k) / of_slab]);
        some[k] = sampler.sample(row / along_v, row % along_v);
        rays += sampler.rays();
        if (step) step();
      });
    });
    for (const FieldRow& row : some) gatherer.add(row);
  }
  if (options.mipmap) add_mipmaps(field);
  if (stats != nullptr) {
    stats->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    stats->rays = rays;
    stats->tree_bytes = caster.bytes();
  }
  return field;
}

std::uint64_t field_array_bytes(const Field& field) {
  return std::uint64_t{4} * field.ids * field.levels.front().lists.size();
}

std::uint64_t field_memory_bytes(const Field& field) {
  std::uint64_t numbers = field.first.size() + field.members.size() + field.partition.of.size();
  for (const FieldLevel& level : field.levels) numbers += level.lists.size();
  return 4 * numbers;
}

}  // namespace sightline
