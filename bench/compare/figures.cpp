#include <algorithm>

#include "bench/compare/report.hpp"

namespace sightline::peers {

Figures figures_of(const SceneResult& scene, const MethodResult& method) {
  Figures out;
  const MethodResult* reference = scene.reference();
  std::vector<double> times, ratios, measures;
  for (std::size_t k = 0; k < method.views.size(); ++k) {
    const ViewResult& v = method.views[k];
    if (!v.begun()) continue;
    ++out.views;
    if (v.outcome.status == Status::failed) {
      ++out.failed;
      continue;
    }
    if (v.outcome.status == Status::cut_off) ++out.cut_off;
    times.push_back(v.outcome.seconds);
    if (v.judged) {
      ++out.judged;
      out.missed += v.missed;
      out.falsely += v.falsely;
      if (v.missed + v.falsely > 0) ++out.wrong_views;
    }
    if (reference == nullptr || method.kind == Method::Kind::ray) continue;
    const Outcome& truth = reference->views[k].outcome;
    if (truth.status != Status::done) continue;
    if (truth.seconds > 0) ratios.push_back(v.outcome.seconds / truth.seconds);
    if (scene.ray_seconds > 0 && truth.vertices > 0) {
      measures.push_back(v.outcome.seconds / (truth.vertices * scene.ray_seconds));
    }
  }
  out.median_seconds = median(times);
  if (!times.empty()) out.worst_seconds = std::ranges::max(times);
  out.to_ours = median(ratios);
  if (!ratios.empty()) {
    out.to_ours_least = std::ranges::min(ratios);
    out.to_ours_most = std::ranges::max(ratios);
  }
  out.to_limit = median(measures);
  if (!measures.empty()) out.to_limit_most = std::ranges::max(measures);
  return out;
}

}  // namespace sightline::peers
