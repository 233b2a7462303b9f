// Cutting the faces in a plane along the polygons that lie in it.
#pragma once

#include "bsp/pieces.hpp"
#include "winged_pair/split.hpp"

namespace sightline {

/// Cuts and labels faces so that each is wholly inside or outside of every surface.
class Labeller {
 public:
  Labeller(const Scene& scene, Complex& complex, Splitter& splitter)
      : scene_(scene), c_(complex), splitter_(splitter), labels_(complex) {}
  /// `face` is one convex face without label; `pieces` are the parts of surfaces in its plane and cell.
  void label(FaceId face, std::span<const Piece> pieces, const Pieces& arena);

 private:
  bool apart(FaceId face, const Piece& piece, const Pieces& arena) const;
  void name_edges(FaceId face, const SurfaceEdge& edge);
  struct Bounds {
    glm::dvec3 low, high;
  };
  Bounds bounds(FaceId face) const;

  const Scene& scene_;
  Complex& c_;
  Splitter& splitter_;
  Labels labels_;
  std::vector<FaceId> faces_;
  std::vector<Bounds> bounds_;  // of faces_
};

}  // namespace sightline
