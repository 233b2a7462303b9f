#include "sample/field_cells.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace sightline {
namespace {

void extend(FieldBox& box, const glm::dvec3& p) {
  box.low = glm::min(box.low, p);
  box.high = glm::max(box.high, p);
}

FieldBox empty_box() { return {glm::dvec3(INFINITY), glm::dvec3(-INFINITY)}; }

bool has_area(const Scene& scene, PolygonId p) { return !scene.surfaces(p).empty(); }

FieldBox box_of(const Scene& scene, PolygonId p) {
  FieldBox box = empty_box();
  for (const std::uint32_t v : scene.corners(p)) extend(box, scene.soup().vertices[v]);
  return box;
}

glm::dvec3 middle(const FieldBox& box) { return 0.5 * box.low + 0.5 * box.high; }

double longest_side(const FieldBox& box) {
  const glm::dvec3 size = box.high - box.low;
  return std::max({size.x, size.y, size.z});
}

/// Numbers keys by first appearance.
template <class Key>
class Numbering {
 public:
  std::uint32_t operator()(const Key& key) {
    return numbers_.try_emplace(key, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(numbers_.size()); }

 private:
  std::map<Key, std::uint32_t> numbers_;
};

/// Sets of vertices that hang together.
class Components {
 public:
  explicit Components(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t of(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Divides cubes until they are small enough for where they lie.
class Octree {
 public:
  Octree(const Scene& scene, const std::vector<FieldSlab>& slabs, const std::array<std::uint32_t, 4>& uvst,
         double samples)
      : slabs_(slabs), uvst_(uvst), samples_(samples) {
    cells_.of.assign(scene.polygon_count(), none);
    std::vector<PolygonId> all;
    middles_.resize(scene.polygon_count());
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
      if (!has_area(scene, p)) continue;
      middles_[p] = middle(box_of(scene, p));
      all.push_back(p);
    }
    const FieldBox box = sightline::box_of(scene);
    if (!all.empty()) divide(box.low, longest_side(box), 0, all);
  }
  FieldCells take() { return std::move(cells_); }

 private:
  void divide(const glm::dvec3& low, double side, int depth, std::vector<PolygonId>& here) {
    const glm::dvec3 centre = low + 0.5 * side;
    if (here.size() == 1 || depth == 16 || side <= samples_ * spacing(centre)) {
      for (const PolygonId p : here) cells_.of[p] = cells_.count;
      ++cells_.count;
      return;
    }
    std::array<std::vector<PolygonId>, 8> parts;
    for (const PolygonId p : here) {
      const glm::dvec3& m = middles_[p];
      parts[(m.x >= centre.x ? 1U : 0U) + (m.y >= centre.y ? 2U : 0U) + (m.z >= centre.z ? 4U : 0U)].push_back(p);
    }
    here = {};
    for (unsigned k = 0; k < 8; ++k) {
      if (parts[k].empty()) continue;
      const glm::dvec3 step(k & 1U ? 1 : 0, k & 2U ? 1 : 0, k & 4U ? 1 : 0);
      divide(low + 0.5 * side * step, 0.5 * side, depth + 1, parts[k]);
    }
  }

  /// How far from one another the rays of one (u,v) run at a point, in the finest slab. Rays from a point of uv spread
  /// in proportion to their distance from it; those of one direction do not.
  double spacing(const glm::dvec3& p) const {
    double finest = INFINITY;
    for (const FieldSlab& slab : slabs_) {
      const double step = std::max(glm::length(slab.st.across) / uvst_[2], glm::length(slab.st.upwards) / uvst_[3]);
      double spread = 1;
      if (!slab.infinite) {
        const glm::dvec3 normal = glm::cross(slab.st.across, slab.st.upwards);
        const double apart = glm::dot(normal, slab.st.corner - slab.uv.corner);
        spread = std::abs(glm::dot(normal, p - slab.uv.corner) / apart);
      }
      finest = std::min(finest, step * spread);
    }
    return finest;
  }

  const std::vector<FieldSlab>& slabs_;
  const std::array<std::uint32_t, 4>& uvst_;
  double samples_;
  std::vector<glm::dvec3> middles_;
  FieldCells cells_;
};

}  // namespace

FieldBox box_of(const Scene& scene) {
  FieldBox box = empty_box();
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (!has_area(scene, p)) continue;
    const FieldBox part = box_of(scene, p);
    extend(box, part.low);
    extend(box, part.high);
  }
  return box.low.x <= box.high.x ? box : FieldBox{};
}

std::vector<std::uint32_t> field_objects(const Scene& scene, FieldObjects kind) {
  std::vector<std::uint32_t> objects(scene.polygon_count(), none);
  Components components(scene.soup().vertices.size());
  if (kind == FieldObjects::connected) {
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
      if (!has_area(scene, p)) continue;
      const auto corners = scene.corners(p);
      for (const std::uint32_t v : corners) components.join(scene.lowest_twin(corners[0]), scene.lowest_twin(v));
    }
  }
  Numbering<std::uint32_t> numbers;
  const auto& names = scene.soup().object_of;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (!has_area(scene, p)) continue;
    if (kind == FieldObjects::connected) {
      objects[p] = numbers(components.of(scene.lowest_twin(scene.corners(p)[0])));
    } else {
      objects[p] = numbers(names.empty() ? none : names[p]);
    }
  }
  return objects;
}

FieldCells cells_of_polygons(const Scene& scene) {
  FieldCells cells{std::vector<std::uint32_t>(scene.polygon_count(), none), 0};
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (has_area(scene, p)) cells.of[p] = cells.count++;
  }
  return cells;
}

FieldCells cells_of_objects(const Scene& scene, const std::vector<std::uint32_t>& objects, double along) {
  std::vector<FieldBox> boxes;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (objects[p] == none) continue;
    if (objects[p] >= boxes.size()) boxes.resize(objects[p] + 1, empty_box());
    const FieldBox box = box_of(scene, p);
    extend(boxes[objects[p]], box.low);
    extend(boxes[objects[p]], box.high);
  }
  FieldCells cells{std::vector<std::uint32_t>(scene.polygon_count(), none), 0};
  Numbering<std::tuple<std::uint32_t, int, int, int>> numbers;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (objects[p] == none) continue;
    const FieldBox& box = boxes[objects[p]];
    const double edge = longest_side(box) / along;
    glm::dvec3 place = (middle(box_of(scene, p)) - box.low) / edge;
    place = glm::floor(place);
    cells.of[p] =
        numbers({objects[p], static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z)});
  }
  cells.count = numbers.count();
  return cells;
}

FieldCells cells_of_scene(const Scene& scene, double along) {
  std::vector<std::uint32_t> one(scene.polygon_count(), none);
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    if (has_area(scene, p)) one[p] = 0;
  }
  return cells_of_objects(scene, one, along);
}

FieldCells cells_of_octree(const Scene& scene, const std::vector<FieldSlab>& slabs,
                           const std::array<std::uint32_t, 4>& uvst, double samples) {
  return Octree(scene, slabs, uvst, samples).take();
}

CellName parse_cells(const std::string& text) {
  if (text == "polygon") return {CellName::polygon, 0};
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
  CellName name;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), name.setting);
  const bool fine = error == std::errc() && end == number.data() + number.size();
  name.kind = kind == "scene" ? CellName::scene : kind == "octree" ? CellName::octree : CellName::object;
  const bool known = kind == "object" || kind == "scene" || kind == "octree";
  const double least = name.kind == CellName::octree ? 0.01 : 1;
  if (!known || !fine || !(name.setting >= least && name.setting <= 4096)) {
    throw std::invalid_argument(
        "polygon, object:N or scene:N (cells along the longest side, 1 to 4096) or octree:N (samples along a cell, "
        "0.01 "
        "to 4096)");
  }
  return name;
}

}  // namespace sightline
