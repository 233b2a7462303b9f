// The stages of check(): each relies on what the ones before it have proved.
#pragma once

#include "winged_pair/complex.hpp"

#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace sightline::check_detail {

/// Faults found so far, at most `most` of them, one line each.
class Faults {
 public:
  explicit Faults(std::size_t most) : most_(most) {}
  template <class... Parts>
  void add(const Parts&... parts) {
    if (full()) return;
    std::string line;
    (append(line, parts), ...);
    lines_.push_back(std::move(line));
  }
  bool empty() const { return lines_.empty(); }
  bool full() const { return lines_.size() >= most_; }
  std::vector<std::string>& lines() { return lines_; }

 private:
  template <class Part>
  static void append(std::string& line, const Part& part) {
    if constexpr (std::is_same_v<Part, Integer>) {
      line += part.get_str();
    } else if constexpr (std::is_integral_v<Part>) {
      line += std::to_string(part);
    } else {
      line += part;
    }
  }
  std::size_t most_;
  std::vector<std::string> lines_;
};

/// The faces and vertices of every cell, as lists one after the other. Entry `cells.size()` is the outside of the box.
struct CellLists {
  struct Side {
    FaceId face;
    std::uint32_t side;  // the cell is face.cell[side]
  };
  std::vector<std::uint32_t> first_face, first_vertex;
  std::vector<Side> faces;
  std::vector<VertexId> vertices;

  std::span<const Side> faces_of(std::size_t cell) const {
    return std::span(faces).subspan(first_face[cell], first_face[cell + 1] - first_face[cell]);
  }
  std::span<const VertexId> vertices_of(std::size_t cell) const {
    return std::span(vertices).subspan(first_vertex[cell], first_vertex[cell + 1] - first_vertex[cell]);
  }
};
CellLists make_cell_lists(const Complex& complex);

/// The pairs of every face, counter-clockwise, one face after the other.
struct Loops {
  std::vector<std::uint32_t> first;
  std::vector<PairId> pairs;
  std::span<const PairId> of(FaceId f) const { return std::span(pairs).subspan(first[f], first[f + 1] - first[f]); }
};
Loops make_loops(const Complex& complex);

/// A vertex in homogeneous grid coordinates: c[k] / w, w > 0.
struct ExactVertex {
  std::array<Integer, 3> c;
  Integer w;
};
/// By Cramer's rule from the three planes; w = 0 where they do not meet in one point.
ExactVertex exact_vertex(const PlaneTable& planes, const PlaneId (&plane)[3]);
/// Sign of a.c[axis]/a.w - b.c[axis]/b.w.
Sign compare(const ExactVertex& a, const ExactVertex& b, int axis);

/// A plane through the edge's line that is not the given plane of a face at the edge.
inline PlaneId wall_of(const Edge& edge, PlaneId face_plane) {
  return edge.plane[0] == face_plane ? edge.plane[1] : edge.plane[0];
}
/// The side of `wall` on which a convex face lies that has an edge on it: 0 if all its vertices lie on the wall.
Sign side_of_face(const Complex& complex, std::span<const PairId> loop, PlaneId wall);

/// References in range, records that point back.
void check_records(const Complex& complex, const Scene& scene, Faults& faults);
/// The same, and the planes are the scene's with those of the box.
void check_references(const Complex& complex, const Scene& scene, Faults& faults);
/// clock and spin inverse to each other, loops and rings closed, sectors agree.
void check_loops(const Complex& complex, Faults& faults);
/// The same, and everything connected, Euler numbers right.
void check_topology(const Complex& complex, Faults& faults);
/// Vertices on their planes and different from each other, edges on their lines.
void check_vertices(const Complex& complex, const Scene& scene, Faults& faults);
/// Faces flat, convex and counter-clockwise; rings in geometric order; cells convex.
void check_convexity(const Complex& complex, Faults& faults);
/// Faces wholly inside or outside of every surface in their plane, labels that say so, surfaces covered.
void check_labels(const Complex& complex, const Scene& scene, Faults& faults);
/// The cells' volumes add up to the box.
void check_volume(const Complex& complex, Faults& faults);

}  // namespace sightline::check_detail
