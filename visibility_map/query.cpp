#include "visibility_map/query.hpp"

#include <algorithm>

namespace sightline {

MapAdjacency::Lists MapAdjacency::group(std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Lists lists;
  lists.first.assign(count + 1, 0);
  lists.values.reserve(pairs.size());
  for (const auto& [key, value] : pairs) {
    ++lists.first[key + 1];
    lists.values.push_back(value);
  }
  for (std::size_t k = 0; k < count; ++k) lists.first[k + 1] += lists.first[k];
  return lists;
}

MapAdjacency::MapAdjacency(const VisibilityMap& map) {
  for (const MapFace& face : map.faces) {
    if (face.polygon != none) polygons_.push_back(face.polygon);
  }
  std::sort(polygons_.begin(), polygons_.end());
  polygons_.erase(std::unique(polygons_.begin(), polygons_.end()), polygons_.end());

  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  Pairs polygon_faces, polygon_edges, face_neighbours, vertex_edges;
  std::vector<std::uint32_t> rank_of(map.faces.size());
  for (std::uint32_t f = 0; f < map.faces.size(); ++f) {
    rank_of[f] = static_cast<std::uint32_t>(rank(map.faces[f].polygon));
    polygon_faces.emplace_back(rank_of[f], f);
  }
  for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
    const MapEdge& edge = map.edges[e];
    for (const std::uint32_t face : {edge.left, edge.right}) {
      if (face != none) polygon_edges.emplace_back(rank_of[face], e);
    }
    if (edge.left != none && edge.right != none && edge.left != edge.right) {
      face_neighbours.emplace_back(edge.left, edge.right);
      face_neighbours.emplace_back(edge.right, edge.left);
    }
    vertex_edges.emplace_back(edge.vertex[0], e);
    vertex_edges.emplace_back(edge.vertex[1], e);
  }
  polygon_faces_ = group(polygons_.size() + 1, std::move(polygon_faces));
  polygon_edges_ = group(polygons_.size() + 1, std::move(polygon_edges));
  face_neighbours_ = group(map.faces.size(), std::move(face_neighbours));
  vertex_edges_ = group(map.vertices.size(), std::move(vertex_edges));
}

std::size_t MapAdjacency::rank(PolygonId polygon) const {
  return static_cast<std::size_t>(std::lower_bound(polygons_.begin(), polygons_.end(), polygon) - polygons_.begin());
}

std::span<const std::uint32_t> MapAdjacency::faces_of(PolygonId polygon) const {
  const std::size_t k = rank(polygon);
  if (polygon != none && (k == polygons_.size() || polygons_[k] != polygon)) return {};
  return polygon_faces_[k];
}

std::span<const std::uint32_t> MapAdjacency::edges_of(PolygonId polygon) const {
  const std::size_t k = rank(polygon);
  if (polygon != none && (k == polygons_.size() || polygons_[k] != polygon)) return {};
  return polygon_edges_[k];
}

}  // namespace sightline
