#include "sample/bitfield_samples.hpp"

#include "beam/trace.hpp"
#include "bsp/tree.hpp"
#include "sample/bitfield_connect.hpp"
#include "sample/bitfield_patches.hpp"
#include "sample/bitfield_viewpoints.hpp"
#include "sample/id_buffer.hpp"
#include "sample/sub_scene.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <bit>
#include <optional>

namespace sightline {
namespace {

/// All that is not in the other list, which is ascending.
std::vector<PolygonId> all_but(std::uint32_t count, std::span<const PolygonId> without) {
  std::vector<PolygonId> out;
  std::size_t next = 0;
  for (PolygonId p = 0; p < count; ++p) {
    if (next < without.size() && without[next] == p) {
      ++next;
    } else {
      out.push_back(p);
    }
  }
  return out;
}

/// What all samples have in common: of the scene without its transparent polygons.
struct Setting {
  Setting(const Scene& whole, const BitfieldSampling& options)
      : opaque(sub_scene(whole, all_but(whole.polygon_count(), options.transparent))) {
    if (options.exact) tree.emplace(opaque.scene, TreeOptions{.lazy = false, .threads = options.threads});
    if (options.exact) tracer.emplace(*tree);
    if (options.fill_rounds > 0) neighbours.emplace(opaque.scene);
  }
  SubScene opaque;
  std::optional<BspTree> tree;
  std::optional<Tracer> tracer;
  std::optional<PolygonNeighbours> neighbours;
};

/// What one thread draws with.
class Sampler {
 public:
  Sampler(const Setting& setting, const BitfieldSampling& options) : setting_(setting), options_(options) {
    if (options.exact) {
      tracer_.emplace(*setting.tracer);
    } else {
      buffer_.emplace(setting.opaque.scene, options.pixels);
    }
  }

  /// Of the opaque scene's own polygons.
  IdBitfield sample(const Camera& camera) {
    const Scene& scene = setting_.opaque.scene;
    IdBitfield field(scene.polygon_count());
    if (tracer_) {
      tracer_->visible(camera, seen_);
      for (const PolygonId p : seen_) {
        if (p != none) field.set(p);
      }
    } else {
      for (const PolygonId p : buffer_->draw(camera)) {
        if (p != none) field.set(p);
      }
    }
    if (setting_.neighbours) fill_in(scene, *setting_.neighbours, camera.eye, options_.fill_rounds, field);
    return field;
  }
  std::size_t buffer_bytes() const { return buffer_ ? buffer_->bytes() : 0; }

 private:
  const Setting& setting_;
  const BitfieldSampling& options_;
  std::optional<Tracer> tracer_;
  std::optional<IdBuffer> buffer_;
  std::vector<PolygonId> seen_;
};

class Hash {
 public:
  void add(std::uint64_t word) {
    for (int k = 0; k < 8; ++k) {
      value_ = (value_ ^ (word & 0xff)) * 0x100000001b3U;
      word >>= 8;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace

bool same_camera(const Camera& a, const Camera& b) {
  return a.eye == b.eye && a.forward == b.forward && a.right == b.right && a.up == b.up;
}

bool samples_of(const BitfieldSamples& samples, const Scene& scene) {
  return samples.polygons == scene.polygon_count() && samples.scene_number == scene_number(scene);
}

bool BitfieldSamples::operator==(const BitfieldSamples& o) const {
  const bool equal = source == o.source && polygons == o.polygons && scene_number == o.scene_number &&
                     centre == o.centre && exact == o.exact && pixels == o.pixels && fill_rounds == o.fill_rounds &&
                     patch == o.patch && cameras.size() == o.cameras.size() && fields == o.fields;
  for (std::size_t k = 0; equal && k < cameras.size(); ++k) {
    if (!same_camera(cameras[k], o.cameras[k])) return false;
  }
  return equal;
}

std::uint64_t scene_number(const Scene& scene) {
  Hash hash;
  for (const glm::dvec3& v : scene.soup().vertices) {
    for (int k = 0; k < 3; ++k) hash.add(std::bit_cast<std::uint64_t>(v[k]));
  }
  for (const std::uint32_t first : scene.soup().first) hash.add(first);
  for (const std::uint32_t corner : scene.soup().corners) hash.add(corner);
  hash.add(scene.options().one_sided ? 1 : 0);
  for (const char c : scene.options().snap) hash.add(static_cast<unsigned char>(c));
  return hash.value();
}

BitfieldSamples sample_bitfields(const Scene& scene, std::span<const Camera> cameras, const BitfieldSampling& options) {
  BitfieldSamples out{scene.soup().source,
                      scene.polygon_count(),
                      scene_number(scene),
                      viewing_centre(scene),
                      options.exact,
                      options.exact ? 0 : options.pixels,
                      options.fill_rounds,
                      options.patch,
                      {cameras.begin(), cameras.end()},
                      std::vector<IdBitfield>(cameras.size())};
  const Setting setting(scene, options);
  std::optional<PolygonPatches> patches;
  if (options.patch > 0) patches.emplace(scene, options.patch);
  tbb::enumerable_thread_specific<Sampler> samplers([&] { return Sampler(setting, options); });
  const auto sample_one = [&](std::size_t k) {
    const IdBitfield seen = samplers.local().sample(cameras[k]);
    IdBitfield whole(scene.polygon_count());
    for (const PolygonId p : seen.list()) whole.set(setting.opaque.original[p]);
    for (const PolygonId p : options.transparent) whole.set(p);
    out.fields[k] = patches ? patches->patches(whole) : std::move(whole);
    options.step();
  };
  tbb::task_arena arena(static_cast<int>(options.threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, cameras.size(), sample_one, tbb::simple_partitioner()); });
  if (options.building_bytes != nullptr) {
    *options.building_bytes = setting.tree ? setting.tree->size().bytes : samplers.local().buffer_bytes();
  }
  return out;
}

}  // namespace sightline
