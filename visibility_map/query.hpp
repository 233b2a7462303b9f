// Asking a map for what lies next to what.
#pragma once

#include "visibility_map/map.hpp"

#include <utility>

namespace sightline {

/// The edge that a loop's entry names.
inline std::uint32_t edge_of(std::int32_t e) { return static_cast<std::uint32_t>(e >= 0 ? e : -(e + 1)); }
/// Where an entry of a loop starts.
inline std::uint32_t start_vertex(const VisibilityMap& map, std::int32_t e) {
  return map.edges[edge_of(e)].vertex[e >= 0 ? 0 : 1];
}
/// Where it ends.
inline std::uint32_t end_vertex(const VisibilityMap& map, std::int32_t e) {
  return map.edges[edge_of(e)].vertex[e >= 0 ? 1 : 0];
}

/// Adjacency of a map, gathered once in linear time; every list ascends and holds nothing twice.
/// Laws: a is a neighbour of b iff b is one of a; the faces of all polygons and those that see nothing are all faces;
/// an edge is an edge of the polygons on its two sides and of no other.
class MapAdjacency {
 public:
  explicit MapAdjacency(const VisibilityMap& map);

  /// Polygons seen, ascending.
  std::span<const PolygonId> polygons() const { return polygons_; }
  /// Faces in which a polygon is visible; `none`: those in which nothing is.
  std::span<const std::uint32_t> faces_of(PolygonId polygon) const;
  /// Edges with a face of the polygon on one side.
  std::span<const std::uint32_t> edges_of(PolygonId polygon) const;
  /// Faces across the edges of a face.
  std::span<const std::uint32_t> neighbours(std::uint32_t face) const { return face_neighbours_[face]; }
  /// Edges that end in a vertex.
  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const { return vertex_edges_[vertex]; }

 private:
  /// Lists one after the other.
  struct Lists {
    std::vector<std::uint32_t> first, values;
    std::span<const std::uint32_t> operator[](std::size_t k) const {
      return std::span(values).subspan(first[k], first[k + 1] - first[k]);
    }
  };
  static Lists group(std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs);
  std::size_t rank(PolygonId polygon) const;

  std::vector<PolygonId> polygons_;
  Lists polygon_faces_, polygon_edges_;  // by place in polygons_; the last list is that of `none`
  Lists face_neighbours_, vertex_edges_;
};

}  // namespace sightline
