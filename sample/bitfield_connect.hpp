// What an ID buffer has missed between polygons that it has seen. (Meruvia and Strothotte, section 3.1.1.)
#pragma once

#include "sample/bitfield.hpp"
#include "scene/scene.hpp"

#include <limits>

namespace sightline {

/// Which polygons share an edge: two vertices, by place and not by index.
class PolygonNeighbours {
 public:
  struct Neighbour {
    PolygonId polygon;
    bool alike;  // the two run along the edge in opposite directions, so that they show the same side there
  };
  explicit PolygonNeighbours(const Scene& scene);
  std::span<const Neighbour> of(PolygonId p) const {
    return std::span(neighbours_).subspan(first_[p], first_[p + 1] - first_[p]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Neighbour> neighbours_;
};

inline constexpr unsigned all_rounds = std::numeric_limits<unsigned>::max();

/// In every round, sets the bits of those neighbours of set polygons that face the eye as they do: that show it the
/// same side, across the edge that they share (exactly; where polygons are one-sided, the side that is opaque). What
/// else hides them is not asked. `all_rounds`: until nothing changes.
///
/// Laws. 1: no bit is lost. 2: more rounds give a superset. 3: what is added faces the eye, and hangs together with
/// what was there.
void fill_in(const Scene& scene, const PolygonNeighbours& neighbours, const glm::dvec3& eye, unsigned rounds,
             IdBitfield& field);

}  // namespace sightline
