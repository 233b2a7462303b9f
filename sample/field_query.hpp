// What a camera sees, looked up in a field; and the same by rays at run time. (Blais and Poulin, Sampling visibility in
// three-space, sections 4 and 6.)
#pragma once

#include "sample/field.hpp"
#include "sample/ray_caster.hpp"

namespace sightline {

/// Which of the 16 samples around a line are looked up with the nearest: those that differ in (u,v), in (s,t), in both.
enum class FieldFilter : std::uint8_t { nearest, uv, st, uvst };

struct FieldQueryOptions {
  std::uint32_t pixels = 256;   // along both sides of the window, 1 to 16384
  std::uint32_t subsample = 1;  // every so-manieth of them along both sides is looked up, the first always
  FieldFilter filter = FieldFilter::nearest;
  /// Where pixels that are looked up are more than a sample apart, the level of the mipmap is taken in which they are
  /// not. Does nothing in a field without mipmaps.
  bool mipmap = false;
  std::uint32_t keep = 0;  // cells of so many views before stay marked
};

/// Of one view.
struct FieldMarks {
  std::vector<std::uint32_t> cells;  // ascending
  std::size_t looked_up = 0;         // pixels, in each slab that they lie in
  std::size_t pixels = 0;            // that were to be looked up
  std::size_t covered = 0;           // of them, those that lie in some slab
};

/// Made for one field, which must outlive it; asked view after view, on one thread.
///
/// Laws. Nothing that was marked is lost 1: by any filter beside `nearest`, and by uvst beside any; 2: by a finer
/// subsample that divides the coarser; 3: by more ids a sample; 4: by the mipmap, with `nearest`; 5: by keeping the
/// cells of more views. 6: what looks along a ray through the middle of a sample has the cells of that sample.
class FieldQuery {
 public:
  /// Throws std::invalid_argument where an option is out of range.
  FieldQuery(const Field& field, const FieldQueryOptions& options);
  FieldMarks mark(const Camera& camera);

 private:
  void look(std::size_t slab, const Camera& camera, FieldMarks& marks);
  std::size_t level_at(const SlabView& view, double x, double y) const;
  void add(std::size_t slab, std::size_t level, const std::array<double, 4>& uvst);
  void add(std::uint32_t list);

  const Field& field_;
  FieldQueryOptions options_;
  std::uint32_t now_ = 0;               // the view's number, from 1
  std::vector<std::uint32_t> list_at_;  // of each list, the last view that found it; 0: none yet
  std::vector<std::uint32_t> cell_at_;  // of each cell
  std::vector<char> covered_;           // of each pixel that is looked up
};

/// Visibility tracing: a ray through the middle of each pixel that would be looked up.
FieldMarks trace_marks(const RayCaster& caster, const Scene& scene, const FieldCells& partition, const Camera& camera,
                       std::uint32_t pixels, std::uint32_t subsample);
/// The polygons of the cells, ascending.
std::vector<PolygonId> polygons_of(const FieldCells& partition, std::span<const std::uint32_t> cells);

}  // namespace sightline
