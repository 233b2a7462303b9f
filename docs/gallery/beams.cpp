#include "docs/gallery/beams.hpp"

#include "visibility_map/visible_view.hpp"
#include "winged_pair/traverse.hpp"

namespace sightline::gallery {

namespace {

class Beams {
 public:
  Beams(const Scene& scene, const Complex& complex, const Camera& camera)
      : complex_(complex),
        table_(complex.planes),
        window_(camera.forward, camera.right, camera.up),
        clipper_(table_, window_) {
    table_.reset(complex.planes, scene.grid().point(camera.eye));
    faces_.resize(complex.cells.size());
    for (CellId c = 0; c < complex.cells.size(); ++c) faces_of_cell(complex, c, marks_, faces_[c]);
  }

  std::vector<std::vector<glm::dvec2>> all() {
    for (CellId c = 0; c < complex_.cells.size(); ++c) {
      bool holds_eye = true;
      for (const FaceId f : faces_[c]) holds_eye = holds_eye && side(f) == (complex_.faces[f].cell[0] == c ? -1 : 1);
      if (holds_eye) enter(c, clipper_.whole());
    }
    return std::move(outlines_);
  }

 private:
  Sign side(FaceId f) { return table_.eye_side(complex_.faces[f].plane); }

  void enter(CellId cell, const ConvexView& beam) {
    for (const FaceId f : faces_[cell]) {
      const Face& face = complex_.faces[f];
      if (side(f) != (face.cell[0] == cell ? -1 : 1)) continue;  // beams leave by faces that turn towards the eye
      const ConvexView part = through(f, beam);
      if (part.empty()) continue;
      outlines_.push_back(clipper_.corners(part));
      const CellId next = cell_across(complex_, f, cell);
      if (face.label == 0 && next != none) enter(next, part);
    }
  }

  ConvexView through(FaceId f, ConvexView beam) {
    for_pairs_of_face(complex_, f, [&](PairId p) {
      if (beam.empty()) return;
      const Edge& edge = complex_.edges[complex_.pairs[p].edge];
      SightlineRef line =
          edge.a != none ? table_.of_points(edge.a, edge.b) : table_.of_planes(edge.plane[0], edge.plane[1]);
      line.sign *= complex_.pairs[p].direction == 0 ? -side(f) : side(f);
      beam = clipper_.clip(beam, line);
    });
    return beam;
  }

  const Complex& complex_;
  SightlineTable table_;
  Window window_;
  ViewClipper clipper_;
  Marks marks_;
  std::vector<std::vector<FaceId>> faces_;  // by cell
  std::vector<std::vector<glm::dvec2>> outlines_;
};

}  // namespace

std::vector<std::vector<glm::dvec2>> beam_outlines(const Scene& scene, const Complex& complex, const Camera& camera) {
  return Beams(scene, complex, camera).all();
}

}  // namespace sightline::gallery
