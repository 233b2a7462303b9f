// The visibility field: which cells of a scene are seen along lines, sampled once and then looked up for any camera.
// (Blais and Poulin, Sampling visibility in three-space.)
#pragma once

#include "sample/field_cells.hpp"
#include "sample/field_slab.hpp"

#include <functional>
#include <span>

namespace sightline {

struct FieldOptions {
  std::array<std::uint32_t, 4> samples{16, 16, 32, 32};  // along u, v, s and t, in each slab: 1 to 4096
  /// The most cells that a sample holds, 1 to 65535; those that most of its rays meet.
  std::uint32_t ids = 1;
  /// Rays of a sample along each of u, v, s and t, odd, 1 to 9: 3 for the 81 rays of the paper's filter, 1 for the ray
  /// through the middle alone. They lie in the middles of so many equal parts.
  std::uint32_t rays = 3;
  /// Levels above the samples: a sample of each stands for 2 x 2 x 2 x 2 below it and holds all of their cells.
  bool mipmap = false;
  unsigned threads = 1;
};

/// Samples of one level, of all slabs, one slab after the other; s runs fastest, then t, v, u. Each is a list's number.
struct FieldLevel {
  std::array<std::uint32_t, 4> size{};
  std::vector<std::uint32_t> lists;
  std::size_t samples_of_slab() const { return std::size_t{size[0]} * size[1] * size[2] * size[3]; }
  std::size_t place(std::size_t slab, const std::array<std::uint32_t, 4>& uvst) const {
    const auto [u, v, s, t] = uvst;
    return (((slab * size[0] + u) * size[1] + v) * size[3] + t) * size[2] + s;
  }
  bool operator==(const FieldLevel&) const = default;
};

/// Adjacent samples are alike: every list of cells is held once, and a sample is its number. List 0 is empty; the
/// others are numbered by first appearance.
struct Field {
  std::string source;  // the scene's name
  std::string cells;   // how it was divided: "object:16"
  std::uint32_t ids = 1, rays = 3;
  std::vector<FieldSlab> slabs;
  FieldCells partition;
  std::vector<std::uint32_t> first{0};  // list k: members[first[k] .. first[k+1]), ascending
  std::vector<std::uint32_t> members;
  std::vector<FieldLevel> levels;  // the samples, then mipmaps until one sample a slab is left

  std::size_t list_count() const { return first.size() - 1; }
  std::span<const std::uint32_t> list(std::uint32_t k) const {
    return std::span(members).subspan(first[k], first[k + 1] - first[k]);
  }
};

struct FieldStats {
  double seconds = 0;
  std::uint64_t rays = 0;      // cast, those that went on behind a hit included
  std::size_t tree_bytes = 0;  // of Embree's tree, which sampling alone needs
};

/// Samples a scene. `step` is called field_steps() times, from any thread. Throws std::length_error where there are
/// more than 2^32 - 2 samples in all or cells in their lists, std::invalid_argument where an option is out of range.
///
/// Laws. 1: the same field at any number of threads. 2: with more ids a sample holds what it held, and more. 3: with
/// all ids, with three times the samples along an axis and a third of the rays (3 and 1), the samples that take a
/// sample's place hold together what it held; and with three times the samples along all axes and the same rays the
/// whole field holds what it held. 4: a sample of a mipmap holds what the samples below it hold, and no more.
Field build_field(const Scene& scene, const std::vector<FieldSlab>& slabs, const FieldCells& partition,
                  const FieldOptions& options, const std::function<void()>& step = {}, FieldStats* stats = nullptr);
std::size_t field_steps(const std::vector<FieldSlab>& slabs, const FieldOptions& options);

/// Bytes: as the paper's array, with `ids` numbers of 4 bytes a sample (mipmaps not counted); as held here; of the
/// file.
std::uint64_t field_array_bytes(const Field& field);
std::uint64_t field_memory_bytes(const Field& field);

/// The file's bytes: see docs/field.md.
std::string field_bytes(const Field& field);
/// Writes X.field under a temporary name, then renames it. Throws std::system_error.
void write_field(const std::filesystem::path& file, const Field& field);
/// Reads back what was written. Throws InputError for a file that is none, is cut short, or says what cannot be.
Field read_field(const std::filesystem::path& file);

}  // namespace sightline
