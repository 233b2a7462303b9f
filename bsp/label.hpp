// Cutting the faces in a plane along the polygons that lie in it.
#pragma once

#include "bsp/pieces.hpp"
#include "winged_pair/split.hpp"

namespace sightline {

/// Cuts and labels faces so that each is wholly inside or outside of every surface. Not at once: a face that is parted
/// early carries its parts through all later cuts of the cells on both its sides. While space is cut, a face's `label`
/// is the number of the cut that made it, which its parts inherit.
class Labeller {
 public:
  Labeller(const Scene& scene, Complex& complex, Splitter& splitter)
      : scene_(scene), c_(complex), splitter_(splitter), labels_(complex) {}
  /// `face` is one convex face without label; `pieces` are the parts of surfaces in its plane and cell.
  void note(FaceId face, std::span<const Piece> pieces);
  /// Cuts and labels what has become of all faces that were noted; to be called once, after the last.
  void finish(const Pieces& arena);

 private:
  struct Box {
    glm::dvec3 low, high;
  };
  struct Found {
    FaceId face;
    Box box;
  };
  void meet(std::span<Found> faces, std::size_t first, const Pieces& arena);
  void label(const Found& face, std::size_t first, const Pieces& arena);
  void label_part(std::size_t part, const Piece& piece, const Pieces& arena);
  bool apart(FaceId face, const Piece& piece, const Pieces& arena) const;
  void name_edges(FaceId face, Sign side, const SurfaceEdge& edge);
  Box bounds(FaceId face) const;

  const Scene& scene_;
  Complex& c_;
  Splitter& splitter_;
  Labels labels_;
  struct Noted {  // a piece
    SurfaceId surface;
    std::uint32_t first, count;
  };
  std::vector<Noted> noted_;
  std::vector<std::uint32_t> first_{0, 0};  // those of cut k: noted_[first_[k] .. first_[k + 1]); there is no cut 0
  std::vector<Piece> pieces_;               // of the cut at hand
  std::vector<Found> faces_, scratch_;      // that came of it
  std::vector<std::uint32_t> near_;         // of pieces_, those near the faces at hand; above them those near fewer
  std::vector<Found> parts_;                // of the face at hand
  std::vector<SurfaceEdge> crossed_;
};

}  // namespace sightline
