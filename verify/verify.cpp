#include "verify/verify.hpp"

#include "verify/checks.hpp"

namespace sightline::verify {

Verifier::Verifier(Soup soup, Options options) : soup_(std::move(soup)), options_(std::move(options)) {}
Verifier::~Verifier() = default;

Report Verifier::check(const std::string& file, std::string_view text, const CameraLine* camera) {
  Report report(options_.limit);
  const std::optional<MapFile> map = parse_map(file, text, report);
  if (!map) {
    report.left_out = "all checks after schema";
    return report;
  }
  if (map->scene_vertices != soup_.vertices.size() || map->scene_polygons != soup_.polygon_count()) {
    report.fault("scene", "scene",
                 "has " + std::to_string(soup_.vertices.size()) + " vertices and " +
                     std::to_string(soup_.polygon_count()) + " polygons, the map says " +
                     std::to_string(map->scene_vertices) + " and " + std::to_string(map->scene_polygons));
    report.left_out = "all checks after scene";
    return report;
  }
  const std::string snap = options_.snap.value_or(map->snap);
  std::unique_ptr<View> view;
  try {
    if (!map->snap.empty() && parse_decimal(map->snap) <= 0) throw std::invalid_argument("the snap is not positive");
    if (options_.snap && (map->snap.empty() || parse_decimal(map->snap) != parse_decimal(snap))) {
      report.fault("scene", "snap", "is not the one asked for");
    }
    Scene* scene = nullptr;
    for (auto& [name, made] : scenes_) {
      if (name == snap) scene = made.get();
    }
    if (!scene) scene = scenes_.emplace_back(snap, std::make_unique<Scene>(soup_, snap)).second.get();
    view = std::make_unique<View>(*scene, map->eye, map->forward, map->right, map->up);
  } catch (const std::invalid_argument& error) {
    report.fault("scene", "snap or camera", error.what());
    report.left_out = "all checks after scene";
    return report;
  }
  if (camera) check_camera(*map, *camera, report);
  Drawing drawing(*view, *map);
  if (!drawing.check(report)) return report;
  check_measures(drawing, *map, report);
  Context context = make_context(drawing, options_.one_sided, options_.threads);
  check_cover(context, report);
  check_depth(context, report);
  check_kinds(context, report);
  check_maximality(context, report);
  check_scene_vertices(context, report);
  return report;
}

}  // namespace sightline::verify
