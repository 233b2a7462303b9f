#include "sample/bitfield_viewer.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>

namespace sightline {
namespace {

ViewHull hull_of(const BitfieldSamples& samples) {
  std::vector<ViewDirection> directions;
  for (const Camera& c : samples.cameras) directions.push_back(view_direction(c.eye - samples.centre));
  return ViewHull(std::move(directions));
}

/// For comparing angles with d: of the directions, which are equally long but for rounding.
__int128 nearness(const ViewDirection& a, const ViewDirection& d) {
  return static_cast<__int128>(a[0]) * d[0] + static_cast<__int128>(a[1]) * d[1] + static_cast<__int128>(a[2]) * d[2];
}

}  // namespace

BitfieldViewer::BitfieldViewer(BitfieldSamples samples, const BitfieldViewing& options, const Scene* scene)
    : samples_(std::move(samples)), options_(options), hull_(hull_of(samples_)), at_corner_(samples_.cameras.size()) {
  const bool lists = options_.form == BitfieldViewing::lists;
  const unsigned n = options_.neighbours;
  if (n != 3 && n != 6 && (n != 1 || lists)) throw std::invalid_argument("3 or 6 neighbours, or 1 without lists");
  if (samples_.patch > 0) {
    if (scene == nullptr || !samples_of(samples_, *scene)) throw std::invalid_argument("patches without their scene");
    patches_.emplace(*scene, samples_.patch);
    if (patches_->size() != samples_.fields.front().size()) throw std::invalid_argument("a wrong number of patches");
  }
  const std::vector<std::uint32_t> nearest = hull_.nearest_corners();
  for (std::uint32_t k = 0; k < nearest.size(); ++k) at_corner_[nearest[k]].push_back(k);
  if (options_.form == BitfieldViewing::hierarchical) {
    for (const IdBitfield& f : samples_.fields) hierarchical_.emplace_back(f);
  }
  if (options_.form == BitfieldViewing::compressed) {
    for (const IdBitfield& f : samples_.fields) compressed_.emplace_back(f);
  }
  if (lists) make_lists();
}

void BitfieldViewer::make_lists() {
  lists_.resize(hull_.faces().size());
  const auto make = [&](std::size_t f) {
    const auto face = static_cast<std::uint32_t>(f);
    lists_[f] = list_of(samples_around(face, {}));
    lists_[f].shrink_to_fit();
  };
  tbb::task_arena arena(static_cast<int>(options_.threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, lists_.size(), make); });
}

std::vector<std::uint32_t> BitfieldViewer::samples_around(std::uint32_t face, const ViewDirection& direction) const {
  const std::array<std::uint32_t, 6> corners = hull_.around(face);
  std::span<const std::uint32_t> chosen = corners;
  if (options_.neighbours == 1) {
    const auto near = [&](std::uint32_t c) { return nearness(hull_.directions()[c], direction); };
    const auto best = std::max_element(corners.begin(), corners.begin() + 3,
                                       [&](std::uint32_t a, std::uint32_t b) { return near(a) < near(b); });
    chosen = {best, 1};
  } else {
    chosen = chosen.first(options_.neighbours);
  }
  std::vector<std::uint32_t> out;
  for (const std::uint32_t c : chosen) out.insert(out.end(), at_corner_[c].begin(), at_corner_[c].end());
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

IdBitfield BitfieldViewer::joined(std::span<const std::uint32_t> samples) const {
  if (options_.form == BitfieldViewing::compressed) {
    CompressedBitfield all(IdBitfield(samples_.fields.front().size()));
    for (const std::uint32_t k : samples) all.join(compressed_[k]);
    return all.plain();
  }
  IdBitfield all(samples_.fields.front().size());
  for (const std::uint32_t k : samples) {
    if (options_.form == BitfieldViewing::hierarchical) {
      hierarchical_[k].join_into(all);
    } else {
      all.join(samples_.fields[k]);
    }
  }
  return all;
}

std::vector<PolygonId> BitfieldViewer::list_of(std::span<const std::uint32_t> samples) const {
  const IdBitfield all = joined(samples);
  return (patches_ ? patches_->polygons(all) : all).list();
}

const BitfieldViewer::View& BitfieldViewer::look(const Camera& camera) {
  const auto own = std::ranges::find_if(samples_.cameras, [&](const Camera& c) { return same_camera(c, camera); });
  if (samples_.exact && own != samples_.cameras.end()) {
    view_.face = none;
    view_.samples = {static_cast<std::uint32_t>(own - samples_.cameras.begin())};
    list_ = list_of(view_.samples);
    view_.polygons = list_;
    return view_;
  }
  const ViewDirection direction = view_direction(camera.eye - samples_.centre);
  view_.face = hull_.face_holding(direction);
  view_.samples = samples_around(view_.face, direction);
  if (options_.form == BitfieldViewing::lists) {
    view_.polygons = lists_[view_.face];
  } else {
    list_ = list_of(view_.samples);
    view_.polygons = list_;
  }
  return view_;
}

std::size_t BitfieldViewer::bytes() const {
  std::size_t sum = 0;
  if (options_.form == BitfieldViewing::plain) {
    for (const IdBitfield& f : samples_.fields) sum += f.bytes();
  }
  for (const HierarchicalBitfield& f : hierarchical_) sum += f.bytes();
  for (const CompressedBitfield& f : compressed_) sum += f.bytes();
  for (const auto& list : lists_) sum += list.size() * sizeof(PolygonId);
  return sum;
}

double BitfieldViewer::mean_list() const {
  std::size_t sum = 0;
  for (std::uint32_t f = 0; f < hull_.faces().size(); ++f) {
    sum += lists_.empty() ? list_of(samples_around(f, {})).size() : lists_[f].size();
  }
  return static_cast<double>(sum) / static_cast<double>(hull_.faces().size());
}

}  // namespace sightline
