// The winged-pair: a 3-manifold of convex cells (Funkhouser 1999, figure 4), in fixed-size records with 32-bit indices.
#pragma once

#include "exact/predicates.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace sightline {

using VertexId = std::uint32_t;
using EdgeId = std::uint32_t;
using FaceId = std::uint32_t;
using CellId = std::uint32_t;  // `none`: outside the box
using PairId = std::uint32_t;
using LabelId = std::uint32_t;  // which surfaces lie on a face; 0: none, the face is transparent

struct Vertex {
  ImplicitVertex place;
  EdgeId edge;  // one that ends here
};
struct Edge {
  VertexId vertex[2];
  PairId pair;       // one of those around it
  PlaneId plane[2];  // two planes that meet in its line; vertex[0] -> vertex[1] is along n[0] x n[1]
  PointId a = none, b = none;  // scene points on whose line it lies, a -> b along it, if it lies on a polygon's edge
};
struct Face {
  CellId cell[2];  // [0] behind its plane, [1] in front
  PairId pair;
  PlaneId plane;
  LabelId label;
};
struct Cell {
  FaceId face;
};
/// Face and edge. Seen from the front of the face's plane, clock[1] is the next pair counter-clockwise around the
/// face, clock[0] the next clockwise. direction 0: vertex[0] -> vertex[1] runs counter-clockwise. spin[1] is the next
/// pair counter-clockwise around the edge, seen with the edge pointing at the viewer; the ring is closed, the outside
/// of the box being one of its sectors. Between a pair and its spin[1] lies face.cell[1] if direction is 0, else cell[0].
struct Pair {
  FaceId face;
  EdgeId edge;
  PairId clock[2];
  PairId spin[2];
  std::uint32_t direction;
};

/// A complex is a plain structure of arrays: everything public, kept consistent by split.hpp, proved by check.hpp.
struct Complex {
  PlaneTable planes;  // the scene's, with the same ids, then those of the box and of cuts in free space
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<Cell> cells;
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> label_first{0, 0};  // label k: label_surfaces[label_first[k] .. label_first[k+1])
  std::vector<SurfaceId> label_surfaces;         // ascending by surface id (hence by polygon)
  Integer box[2][3];                             // lower and upper corner, grid units
  PlaneId box_plane[3][2] = {};                  // by axis: the box's lower and upper plane

  std::span<const SurfaceId> surfaces_on(const Face& f) const {
    return std::span(label_surfaces).subspan(label_first[f.label], label_first[f.label + 1] - label_first[f.label]);
  }
};

}  // namespace sightline
