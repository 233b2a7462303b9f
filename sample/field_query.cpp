#include "sample/field_query.hpp"

#include "sample/places.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sightline {
namespace {

/// How many pixels of a row are looked up.
std::uint32_t looked_at(std::uint32_t pixels, std::uint32_t subsample) { return (pixels + subsample - 1) / subsample; }

void check(std::uint32_t pixels, std::uint32_t subsample) {
  if (pixels < 1 || pixels > 16384) throw std::invalid_argument("pixels: 1 to 16384");
  if (subsample < 1 || subsample > pixels) throw std::invalid_argument("subsample: from 1 to the number of pixels");
}

/// Where linear functions of one variable are not negative: an interval, made smaller one by one.
struct Stretch {
  double from, to;
  void keep(double at, double slope) {  // at + slope x >= 0
    if (slope > 0) from = std::max(from, -at / slope);
    if (slope < 0) to = std::min(to, at / -slope);
    if (slope == 0 && at < 0) to = -INFINITY;
  }
};

}  // namespace

FieldQuery::FieldQuery(const Field& field, const FieldQueryOptions& options)
    : field_(field), options_(options), list_at_(field.list_count()), cell_at_(field.partition.count) {
  check(options.pixels, options.subsample);
}

FieldMarks FieldQuery::mark(const Camera& camera) {
  ++now_;
  FieldMarks marks;
  const std::size_t along = looked_at(options_.pixels, options_.subsample);
  marks.pixels = along * along;
  covered_.assign(marks.pixels, 0);
  for (std::size_t slab = 0; slab < field_.slabs.size(); ++slab) look(slab, camera, marks);
  marks.covered = static_cast<std::size_t>(std::ranges::count(covered_, 1));
  for (std::uint32_t cell = 0; cell < cell_at_.size(); ++cell) {
    if (cell_at_[cell] != 0 && now_ - cell_at_[cell] <= options_.keep) marks.cells.push_back(cell);
  }
  return marks;
}

/// Row by row the stretch of pixels that lies within the projections of both planes.
void FieldQuery::look(std::size_t slab, const Camera& camera, FieldMarks& marks) {
  const SlabView view(field_.slabs[slab], camera);
  const double step = static_cast<double>(options_.subsample) / options_.pixels, first = 0.5 / options_.pixels;
  const std::uint32_t along = looked_at(options_.pixels, options_.subsample);
  const bool levels = options_.mipmap && field_.levels.size() > 1;
  for (std::uint32_t row = 0; row < along; ++row) {
    const double y = first + row * step;
    Stretch stretch{first, 1};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& above = view.numerators()[k];
      const auto& below = k < 2 ? view.uv_denominator() : view.st_denominator();
      stretch.keep(above(0, y), above.s);
      stretch.keep(below(0, y) - above(0, y), below.s - above.s);
      stretch.keep(below(0, y), below.s);
    }
    if (!(stretch.from <= stretch.to)) continue;
    // One pixel more at both ends: each says itself whether it is within.
    const auto column = [&](double x) { return std::clamp((x - first) / step, 0.0, static_cast<double>(along)); };
    const auto from = static_cast<std::uint32_t>(std::max(0.0, std::floor(column(stretch.from)) - 1));
    const auto to = static_cast<std::uint32_t>(std::min<double>(along, std::ceil(column(stretch.to)) + 2));
    for (std::uint32_t k = from; k < to; ++k) {
      const double x = first + k * step, uv = view.uv_denominator()(x, y), st = view.st_denominator()(x, y);
      if (!(uv > 0 && st > 0)) continue;
      const auto& n = view.numerators();
      const std::array<double, 4> uvst{n[0](x, y) / uv, n[1](x, y) / uv, n[2](x, y) / st, n[3](x, y) / st};
      if (!std::ranges::all_of(uvst, [](double c) { return c >= 0 && c <= 1; })) continue;
      ++marks.looked_up;
      covered_[std::size_t{row} * along + k] = 1;
      add(slab, levels ? level_at(view, x, y) : 0, uvst);
    }
  }
}

/// The level at which the next pixels across and upwards are at most a sample away.
std::size_t FieldQuery::level_at(const SlabView& view, double x, double y) const {
  const double step = static_cast<double>(options_.subsample) / options_.pixels;
  double most = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& above = view.numerators()[k];
    const auto& below = k < 2 ? view.uv_denominator() : view.st_denominator();
    const double n = above(x, y), d = below(x, y);
    const double slope = std::max(std::abs(above.s * d - n * below.s), std::abs(above.t * d - n * below.t)) / (d * d);
    most = std::max(most, slope * step * field_.levels.front().size[k]);
  }
  std::size_t level = 0;
  for (; most > 1 && level + 1 < field_.levels.size(); most /= 2) ++level;
  return level;
}

void FieldQuery::add(std::size_t slab, std::size_t level, const std::array<double, 4>& uvst) {
  const FieldLevel& samples = field_.levels[level];
  std::array<std::array<std::uint32_t, 2>, 4> at;  // along each axis, the nearest and the one beside it
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t finest = field_.levels.front().size[k];
    const double place = uvst[k] * finest;
    const std::uint32_t nearest = std::min(static_cast<std::uint32_t>(place), finest - 1) >> level;
    const double within = std::ldexp(place, -static_cast<int>(level)) - nearest;
    const std::uint32_t beside = within < 0.5 ? std::max(nearest, 1U) - 1 : std::min(nearest + 1, samples.size[k] - 1);
    at[k] = {nearest, beside};
  }
  const unsigned uv = options_.filter == FieldFilter::uv || options_.filter == FieldFilter::uvst ? 3U : 0U;
  const unsigned st = options_.filter == FieldFilter::st || options_.filter == FieldFilter::uvst ? 12U : 0U;
  for (unsigned k = 0; k < 16; ++k) {
    if ((k & ~(uv | st)) != 0) continue;
    add(samples.lists[samples.place(slab, {at[0][k & 1U], at[1][k >> 1U & 1U], at[2][k >> 2U & 1U], at[3][k >> 3U]})]);
  }
}

/// Many samples are alike: each list is gone through once a view.
void FieldQuery::add(std::uint32_t list) {
  if (list_at_[list] == now_) return;
  list_at_[list] = now_;
  for (const std::uint32_t cell : field_.list(list)) cell_at_[cell] = now_;
}

FieldMarks trace_marks(const RayCaster& caster, const Scene& scene, const FieldCells& partition, const Camera& camera,
                       std::uint32_t pixels, std::uint32_t subsample) {
  check(pixels, subsample);
  const std::uint32_t along = looked_at(pixels, subsample);
  const glm::vec3 eye = place_of_eye(scene, camera.eye);
  FieldMarks marks;
  marks.pixels = marks.looked_up = marks.covered = std::size_t{along} * along;
  std::vector<char> seen(partition.count);
  std::vector<Ray> rays;
  std::vector<RayHit> hits(along);
  for (std::uint32_t row = 0; row < along; ++row) {
    rays.clear();
    for (std::uint32_t k = 0; k < along; ++k) {
      const double x = (k * static_cast<double>(subsample) + 0.5) / pixels - 0.5;
      const double y = (row * static_cast<double>(subsample) + 0.5) / pixels - 0.5;
      rays.push_back({eye, glm::vec3(camera.forward + x * camera.right + y * camera.up)});
    }
    caster.cast(rays, hits, true);
    for (const RayHit& hit : hits) {
      const std::uint32_t cell = hit.polygon == none ? none : partition.of[hit.polygon];
      if (cell != none) seen[cell] = 1;  // the partition of another scene may leave out what is hit
    }
  }
  for (std::uint32_t cell = 0; cell < partition.count; ++cell) {
    if (seen[cell] != 0) marks.cells.push_back(cell);
  }
  return marks;
}

std::vector<PolygonId> polygons_of(const FieldCells& partition, std::span<const std::uint32_t> cells) {
  std::vector<char> marked(partition.count);
  for (const std::uint32_t cell : cells) marked[cell] = 1;
  std::vector<PolygonId> polygons;
  for (PolygonId p = 0; p < partition.of.size(); ++p) {
    if (partition.of[p] != none && marked[partition.of[p]] != 0) polygons.push_back(p);
  }
  return polygons;
}

}  // namespace sightline
