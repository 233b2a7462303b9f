#include "compare/reference.hpp"

#include "compare/overlay.hpp"

#include <algorithm>
#include <unordered_map>

namespace sightline::comparison {

Reference::Reference(const VisibilityMap& map) {
  draw(map, drawing_);
  visible_ = drawing_.polygons;
  tidy(visible_);
  stand_in_.resize(visible_.size());
  for (const MapFace& f : map.faces) {
    const auto same = map.coincident_of(f);
    same_.emplace_back(same.begin(), same.end());
    excused_.insert(excused_.end(), same.begin(), same.end());
    if (f.polygon == none) continue;
    auto& list = stand_in_[static_cast<std::size_t>(std::ranges::lower_bound(visible_, f.polygon) - visible_.begin())];
    list.insert(list.end(), same.begin(), same.end());
  }
  tidy(excused_);
  for (auto& list : stand_in_) tidy(list);
}

bool Reference::shows(std::uint32_t face, PolygonId polygon) const {
  return drawing_.polygons[face] == polygon || std::ranges::binary_search(same_[face], polygon);
}

void Reference::count(const Answer& answer, Error& error) const {
  const auto reported = [&](PolygonId p) { return std::ranges::binary_search(answer.reported, p); };
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    error.missed += !reported(visible_[k]) && std::ranges::none_of(stand_in_[k], reported) ? 1 : 0;
  }
  for (const PolygonId p : answer.reported) {
    error.falsely += !std::ranges::binary_search(visible_, p) && !std::ranges::binary_search(excused_, p) ? 1 : 0;
  }
}

Error Reference::error_of(const Answer& answer) const {
  Error error;
  count(answer, error);
  std::unordered_map<PolygonId, double> of_polygon;
  const auto agrees = [&](std::uint32_t face, PolygonId shown) { return shows(face, shown); };
  const auto part = [&](std::uint32_t face, PolygonId shown, double area) {
    error.wrong_area += area;
    if (drawing_.polygons[face] != none) of_polygon[drawing_.polygons[face]] += area;
    if (shown != none) of_polygon[shown] += area;
  };
  std::visit([&](const auto& shown) { differences(drawing_, shown, agrees, part); }, answer.shown);
  for (const auto& [polygon, area] : of_polygon) error.worst_area = std::max(error.worst_area, area);
  error.wrong_area = std::min(error.wrong_area, 1.0);
  error.worst_area = std::min(error.worst_area, 1.0);
  return error;
}

Error Reference::error_of_nothing() const {
  Pixels nothing{1, {none}};
  return error_of({{}, std::move(nothing)});
}

}  // namespace sightline::comparison
