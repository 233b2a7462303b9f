// A place is found by walking in a straight line from an anchor, whose face is known, to the point: each edge that the
// way crosses takes one away from the count of the face on the near side and adds one to that on the far side. Counts
// telescope: whatever the order of the crossings, in the end one face is left with one.
#include "visibility_map/locate.hpp"

#include "visibility_map/locate_exact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sightline {

namespace {

/// A point with its exact coordinates, made when first asked for.
class Spot {
 public:
  explicit Spot(const glm::dvec2& place) : st(place) {}
  explicit Spot(const WindowPoint& point) : st(rounded(point)), exact_(point) {}
  const WindowPoint& exact() const {
    if (!exact_) exact_ = exact_point(st);
    return *exact_;
  }
  const glm::dvec2 st;  // within 2^-53

 private:
  mutable std::optional<WindowPoint> exact_;
};

/// Orientation of three points of which each coordinate lies within [-1, 1] and is known to 2^-53; or `uncertain`.
/// In units of u = 2^-53: a difference is at most 2 and off by 2u and a rounding of u; a product is at most 4 and off
/// by 2 (3u) 2 and a rounding of 4u; the difference of two products by 32u and a rounding of 8u: 40u and terms in u^2,
/// less than 64u = 2^-47.
Sign filter_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  constexpr double bound = 0x1p-47;
  const double det = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return det > bound ? 1 : det < -bound ? -1 : uncertain;
}

/// Walks through the edges of one map.
class Walker {
 public:
  Walker(const VisibilityMap& map, const Scene& scene) : map_(map), exact_(map, scene) {}

  /// Where `to` lies, if every edge that the way there from `from` crosses, or that holds `to`, is among `edges`, and
  /// `from` lies in the interior of `face`, or outside the window (`none`).
  MapPlace walk(const Spot& from, std::uint32_t face, const Spot& to, std::span<const std::uint32_t> edges) const {
    Counts counts{{face, 1}};
    for (const std::uint32_t e : edges) {
      const MapEdge& edge = map_.edges[e];
      const Sign side = side_of(to, edge);
      if (side == 0) {
        if (const MapPlace place = place_on(to, e); place.kind != MapPlace::outside) return place;
        continue;  // beyond an end of the edge: the way, which runs up to its line, cannot cross it
      }
      // An end on the way's line counts as on its left: as if the way were moved by less than anything.
      const bool left0 = way_side(from, to, edge.vertex[0]) >= 0;
      const bool left1 = way_side(from, to, edge.vertex[1]) >= 0;
      if (left0 == left1) continue;
      // The edge crosses the line of the way; it crosses the way itself iff `from` lies on its other side.
      if (side_of(from, edge) == side) continue;
      add(counts, side > 0 ? edge.right : edge.left, -1);
      add(counts, side > 0 ? edge.left : edge.right, 1);
    }
    for (const auto& [f, count] : counts) {
      if (count > 0) return f == none ? MapPlace{} : MapPlace{MapPlace::face, f};
    }
    return {};
  }

 private:
  using Counts = std::vector<std::pair<std::uint32_t, int>>;

  static void add(Counts& counts, std::uint32_t face, int change) {
    const auto found = std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == face; });
    if (found == counts.end()) {
      counts.emplace_back(face, change);
    } else {
      found->second += change;
    }
  }

  /// +1: the spot lies on the left of the edge's line.
  Sign side_of(const Spot& spot, const MapEdge& edge) const {
    const Sign sign = filter_orientation(st(edge.vertex[0]), st(edge.vertex[1]), spot.st);
    if (sign != uncertain) return sign;
    return exact_orientation(exact_.vertex(edge.vertex[0]), exact_.vertex(edge.vertex[1]), spot.exact());
  }
  Sign way_side(const Spot& from, const Spot& to, std::uint32_t v) const {
    const Sign sign = filter_orientation(from.st, to.st, st(v));
    return sign != uncertain ? sign : exact_orientation(from.exact(), to.exact(), exact_.vertex(v));
  }
  const glm::dvec2& st(std::uint32_t v) const { return map_.vertices[v].st; }

  /// The place of a spot on an edge's line: the edge, one of its vertices, or `outside` beyond them.
  MapPlace place_on(const Spot& spot, std::uint32_t e) const {
    const MapEdge& edge = map_.edges[e];
    Sign along[2];
    for (int k = 0; k < 2; ++k) {
      const WindowPoint end = exact_.vertex(edge.vertex[k]);
      along[k] = exact_compare(spot.exact(), end, 1);
      if (along[k] == 0) along[k] = exact_compare(spot.exact(), end, 2);
      if (along[k] == 0) return {MapPlace::vertex, edge.vertex[k]};
    }
    return along[0] != along[1] ? MapPlace{MapPlace::edge, e} : MapPlace{};
  }

  const VisibilityMap& map_;
  ExactWindow exact_;
};

const Spot& beyond() {
  static const Spot spot = [] {
    Spot s(glm::dvec2(-0.75, -0.875));
    s.exact();
    return s;
  }();
  return spot;
}

std::vector<std::uint32_t> all_edges(const VisibilityMap& map) {
  std::vector<std::uint32_t> edges(map.edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) edges[e] = e;
  return edges;
}

bool in_window(const glm::dvec2& st) { return st.x >= 0 && st.x <= 1 && st.y >= 0 && st.y <= 1; }

}  // namespace

struct Locator::Cells {
  Cells(const VisibilityMap& m, const Scene& scene) : map(m), walker(m, scene) {
    size = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(map.edges.size()) / 3)), 1, 1024);
    edges.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (std::uint32_t e = 0; e < map.edges.size(); ++e) enter(e);
    place_anchors();
  }

  /// A cell's number along one axis; points beyond the window belong to the outermost cells.
  int cell(double x) const { return std::clamp(static_cast<int>(std::floor(x * size)), 0, size - 1); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
  }

  /// Enters an edge in every cell that it meets, and perhaps in some that it only comes near: `slack` is far more than
  /// all the rounding of st (2^-54) and of the interpolation below (some 2^-50).
  void enter(std::uint32_t e) {
    constexpr double slack = 0x1p-40;
    glm::dvec2 a = map.vertices[map.edges[e].vertex[0]].st, b = map.vertices[map.edges[e].vertex[1]].st;
    if (b.x < a.x) std::swap(a, b);
    for (int column = cell(a.x - slack); column <= cell(b.x + slack); ++column) {
      const double from = static_cast<double>(column) / size - slack, to = (column + 1.0) / size + slack;
      const auto height = [&](double x) {
        return b.x - a.x < slack ? a.y : a.y + (b.y - a.y) * std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0);
      };
      double low = height(from), high = height(to);
      if (b.x - a.x < 4 * slack) low = a.y, high = b.y;  // upright: the whole of it
      if (low > high) std::swap(low, high);
      for (int row = cell(low - slack); row <= cell(high + slack); ++row) edges[index(column, row)].push_back(e);
    }
  }

  /// Gives each cell an anchor off all edges, found from that of the cell before it.
  void place_anchors() {
    const std::vector<std::uint32_t> all = all_edges(map);
    anchors.assign(edges.size(), {});
    std::vector<std::uint32_t> both;
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const std::size_t here = index(column, row);
        const std::size_t before = column > 0 ? index(column - 1, row) : row > 0 ? index(column, row - 1) : here;
        const bool known = before != here && anchors[before].face != none;
        if (known) {
          both = edges[before];
          both.insert(both.end(), edges[here].begin(), edges[here].end());
          std::sort(both.begin(), both.end());
          both.erase(std::unique(both.begin(), both.end()), both.end());
        }
        // Places on a parabola: an edge holds two of them at most.
        for (int attempt = 0; attempt < 16 && anchors[here].face == none; ++attempt) {
          const double x = 0.4371 + attempt / 32.0, y = 0.2913 + attempt * attempt / 512.0;
          const Spot spot(glm::dvec2((column + x) / size, (row + y) / size));
          const MapPlace place = known ? walker.walk(Spot(anchors[before].st), anchors[before].face, spot, both)
                                       : walker.walk(beyond(), none, spot, all);
          if (place.kind == MapPlace::face) anchors[here] = {spot.st, place.index};
        }
      }
    }
  }

  MapPlace at(const Spot& spot) const {
    const std::size_t here = index(cell(spot.st.x), cell(spot.st.y));
    if (anchors[here].face == none) return walker.walk(beyond(), none, spot, all_edges(map));
    return walker.walk(Spot(anchors[here].st), anchors[here].face, spot, edges[here]);
  }

  struct Anchor {
    glm::dvec2 st;
    std::uint32_t face = none;  // none: there is no anchor
  };
  const VisibilityMap& map;
  Walker walker;
  int size = 1;
  std::vector<std::vector<std::uint32_t>> edges;  // of each cell
  std::vector<Anchor> anchors;
};

Locator::Locator(const VisibilityMap& map, const Scene& scene) : cells_(std::make_unique<const Cells>(map, scene)) {}
Locator::~Locator() = default;
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;

MapPlace Locator::at(const glm::dvec2& st) const { return in_window(st) ? cells_->at(Spot(st)) : MapPlace{}; }

MapPlace Locator::at_exact(const std::array<Integer, 3>& point) const {
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(point[k]) * 2 > point[0]) return {};
  }
  return cells_->at(Spot(point));
}

std::uint32_t Locator::face_at(const glm::dvec2& st) const {
  const MapPlace place = at(st);
  return place.kind == MapPlace::face ? place.index : none;
}

std::vector<std::uint32_t> Locator::edges_near(const glm::dvec2& low, const glm::dvec2& high) const {
  std::vector<std::uint32_t> found;
  for (int row = cells_->cell(low.y); row <= cells_->cell(high.y); ++row) {
    for (int column = cells_->cell(low.x); column <= cells_->cell(high.x); ++column) {
      const auto& here = cells_->edges[cells_->index(column, row)];
      found.insert(found.end(), here.begin(), here.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

MapPlace locate(const VisibilityMap& map, const Scene& scene, const glm::dvec2& st) {
  if (!in_window(st)) return {};
  return Walker(map, scene).walk(beyond(), none, Spot(st), all_edges(map));
}

}  // namespace sightline
