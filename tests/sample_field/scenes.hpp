// Scenes with a way to look at them from outside.
#pragma once

#include "models/model.hpp"
#include "sample/field.hpp"
#include "sample/field_query.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace sightline::test {

inline Scene model_scene(const std::string& name, std::uint32_t polygons = 0, double degrees = 0) {
  return make_scene(make_model(name, {.polygons = polygons, .rotate_degrees = degrees}).soup);
}

/// Around and above the scene, `apart` of its diagonals from its middle, looking there.
inline std::vector<Camera> cameras_around(const Scene& scene, std::size_t count, double apart = 1.2) {
  const FieldBox box = box_of(scene);
  const glm::dvec3 middle = 0.5 * (box.low + box.high);
  std::vector<Camera> cameras;
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = 0.3 + 2 * std::acos(-1.0) * static_cast<double>(k) / static_cast<double>(count);
    const glm::dvec3 from(std::cos(turn), std::sin(turn), 0.7 + 0.4 * std::cos(2.5 * turn));
    cameras.push_back(make_camera(middle + apart * glm::length(box.high - box.low) * glm::normalize(from), -from,
                                  {0, 0.1, 1}, 50, 1.25));
  }
  return cameras;
}

inline FieldCells grid_of(const Scene& scene, double along = 6) {
  return cells_of_objects(scene, field_objects(scene, FieldObjects::named), along);
}

template <class T>
bool within(const std::vector<T>& less, const std::vector<T>& more) {
  return std::ranges::includes(more, less);
}

/// A sample as a vector.
inline std::vector<std::uint32_t> held(const Field& field, std::size_t level, std::size_t place) {
  const auto list = field.list(field.levels[level].lists[place]);
  return {list.begin(), list.end()};
}

}  // namespace sightline::test
