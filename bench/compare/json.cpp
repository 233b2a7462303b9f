#include <nlohmann/json.hpp>

#include "bench/compare/report.hpp"

namespace sightline::peers {

using nlohmann::ordered_json;

namespace {

ordered_json view_json(std::size_t camera, const ViewResult& v) {
  constexpr const char* status[] = {"done", "cut off", "failed"};
  ordered_json out{
      {"camera", camera}, {"status", status[static_cast<int>(v.outcome.status)]}, {"seconds", v.outcome.seconds}};
  if (v.outcome.edges > 0) {
    out["faces"] = v.outcome.faces;
    out["edges"] = v.outcome.edges;
    out["vertices"] = v.outcome.vertices;
  }
  if (v.outcome.gives_visible) out["visible"] = v.outcome.visible.size();
  if (v.judged) {
    out["missed"] = v.missed;
    out["falsely_visible"] = v.falsely;
  }
  if (!v.outcome.note.empty()) out["note"] = v.outcome.note;
  return out;
}

}  // namespace

std::string json(std::span<const SceneResult> scenes) {
  ordered_json all = ordered_json::array();
  for (const SceneResult& s : scenes) {
    ordered_json methods = ordered_json::array();
    for (const MethodResult& m : s.methods) {
      const Figures f = figures_of(s, m);
      ordered_json views = ordered_json::array();
      for (std::size_t k = 0; k < m.views.size(); ++k) {
        if (m.views[k].begun()) views.push_back(view_json(s.cameras[k], m.views[k]));
      }

      ordered_json entry{{"name", m.name}, {"prepare_seconds", m.cost.seconds}, {"bytes", m.cost.bytes}};
      if (!m.fault.empty()) entry["fault"] = m.fault;
      entry["median_seconds"] = f.median_seconds;
      entry["worst_seconds"] = f.worst_seconds;
      entry["to_ours"] = {{"median", f.to_ours}, {"least", f.to_ours_least}, {"most", f.to_ours_most}};
      entry["to_limit"] = {{"median", f.to_limit}, {"most", f.to_limit_most}};
      entry["cut_off"] = f.cut_off;
      entry["failed"] = f.failed;
      entry["views"] = std::move(views);
      methods.push_back(std::move(entry));
    }
    all.push_back({{"scene", s.name},
                   {"polygons", s.polygons},
                   {"vertices", s.vertices},
                   {"bits", s.bits},
                   {"scene_seconds", s.read_seconds},
                   {"ray_seconds", s.ray_seconds},
                   {"methods", std::move(methods)}});
  }
  return ordered_json{{"format", "sightline-compare"}, {"version", 1}, {"scenes", std::move(all)}}.dump(1) + "\n";
}

}  // namespace sightline::peers
