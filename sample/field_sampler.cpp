#include "sample/field_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

/// How far behind a hit a ray goes on, in unit coordinates: a few times what floats can tell apart there.
constexpr double clearance = 1e-6;

/// The middle of part k of n equal parts of [0,1]. A quotient of integers, so that the same place is the same double
/// however many samples and parts of samples it was found by.
double middle(std::uint32_t k, std::uint32_t n) { return (2.0 * k + 1) / (2.0 * n); }

}  // namespace

FieldSampler::FieldSampler(const Scene& scene, const RayCaster& caster, const FieldCells& partition,
                           const FieldOptions& options, const FieldSlab& slab)
    : caster_(caster),
      partition_(partition),
      options_(options),
      slab_(slab),
      scale_(std::ldexp(1 / scene.grid().step(), -scene.grid().unit_bits())),
      base_(slab.st.corner),
      base_unit_(scene.grid().unit(base_)),
      met_(options.samples[2]) {}

FieldRow FieldSampler::sample(std::uint32_t u, std::uint32_t v) {
  FieldRow row;
  for (std::uint32_t t = 0; t < options_.samples[3]; ++t) {
    for (auto& met : met_) met.clear();
    send(u, v, t);
    for (auto& met : met_) rank(met, row);
  }
  return row;
}

/// The rays of the samples (u, v, s, t) for all s; those of one place on uv together, which run nearly alike.
void FieldSampler::send(std::uint32_t u, std::uint32_t v, std::uint32_t t) {
  const std::uint32_t n = options_.rays;
  const auto place = [&](std::size_t axis, std::uint32_t sample, std::uint32_t part) {
    return middle(sample * n + part, options_.samples[axis] * n);
  };
  for (std::uint32_t pu = 0; pu < n; ++pu) {
    for (std::uint32_t pv = 0; pv < n; ++pv) {
      for (std::uint32_t s = 0; s < options_.samples[2]; ++s) {
        for (std::uint32_t k = 0; k < n * n; ++k) {
          const FieldRay ray =
              ray_of(slab_, {place(0, u, pu), place(1, v, pv), place(2, s, k % n), place(3, t, k / n)});
          going_.push_back({base_unit_ + scale_ * (ray.origin - base_), ray.direction * scale_, s});
        }
      }
      follow();
    }
  }
}

/// Until every ray has met what the slab's viewers see along it.
void FieldSampler::follow() {
  const double within = slab_.end - slab_.begin;
  while (!going_.empty()) {
    cast_.clear();
    for (const Going& g : going_) cast_.push_back({glm::vec3(g.origin + g.gone * g.direction), glm::vec3(g.direction)});
    hits_.resize(cast_.size());
    caster_.cast(cast_, hits_, true);
    rays_ += cast_.size();
    std::size_t left = 0;
    for (std::size_t k = 0; k < going_.size(); ++k) {
      if (hits_[k].polygon == none) continue;
      Going& g = going_[k];
      const std::uint32_t cell = partition_.of[hits_[k].polygon];
      if (hits_[k].polygon != g.last) met_[g.sample].push_back(cell);
      const double at = g.gone + static_cast<double>(hits_[k].distance);
      if (at > within) continue;
      // A ray that runs along a polygon meets it again and again: longer and longer steps come to its end.
      g.step = hits_[k].polygon == g.last ? 2 * g.step : clearance / glm::length(g.direction);
      g.last = hits_[k].polygon;
      g.gone = at + g.step;
      going_[left++] = g;
    }
    going_.resize(left);
  }
}

/// The cells that most of the rays met, of equals the first.
void FieldSampler::rank(std::vector<std::uint32_t>& met, FieldRow& row) {
  std::ranges::sort(met);
  ranked_.clear();
  for (const std::uint32_t cell : met) {
    if (ranked_.empty() || ranked_.back().second != cell) ranked_.emplace_back(0, cell);
    ++ranked_.back().first;
  }
  if (ranked_.size() > options_.ids) {
    std::ranges::sort(ranked_, [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    ranked_.resize(options_.ids);
    std::ranges::sort(ranked_, {}, [](const auto& counted) { return counted.second; });
  }
  for (const auto& [count, cell] : ranked_) row.members.push_back(cell);
  row.first.push_back(static_cast<std::uint32_t>(row.members.size()));
}

}  // namespace sightline
