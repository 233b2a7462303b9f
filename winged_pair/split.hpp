// Splitting: every operation leaves a 3-manifold behind.
#pragma once

#include <unordered_map>

#include "winged_pair/traverse.hpp"

namespace sightline {

/// A complex of one cell, the box from `lower` to `upper` (grid units, lower < upper on each axis). Edges 0..11, faces
/// 0..5 (x low, x high, y low, y high, z low, z high).
Complex make_box(const Scene& scene, const Integer lower[3], const Integer upper[3]);

/// The index of a set of surfaces (ascending, distinct) as a face label; `base` plus one surface. Labels are interned.
class Labels {
 public:
  explicit Labels(Complex& complex) : complex_(&complex) {}
  LabelId with(LabelId base, SurfaceId added);

 private:
  LabelId close();  // of the surfaces that were appended

  Complex* complex_;
  std::vector<LabelId> alone_;                       // by surface: the label of just that one, or none
  std::unordered_map<std::uint64_t, LabelId> next_;  // (base, added) -> label, for other bases
};

/// Splits elements of one complex by planes. Holds scratch memory; one object serves a whole construction.
///
/// Laws. After each call: check() finds no fault that was not there before; ids of existing elements stay valid; a
/// split edge keeps vertex[0], a split face keeps the part behind the plane, a split cell the part behind it.
class Splitter {
 public:
  explicit Splitter(Complex& complex) : c_(complex) {}

  struct CellCut {
    CellId front = none;  // the new cell; none: the plane does not meet the interior of the cell, nothing was done
    FaceId face = none;   // the new face between them
  };
  CellCut cut_cell(CellId cell, PlaneId plane);

  /// Where a face lies against a plane other than its own, and whether an edge of it lies on the plane.
  enum class Side { behind, front, crossed };
  struct FaceSide {
    Side side;
    bool flush;
  };
  FaceSide classify_face(FaceId face, PlaneId plane);
  /// Splits a crossed face (classified by the call just before): returns the new part in front; `between` is the edge.
  FaceId cut_face(FaceId face, PlaneId plane, EdgeId* between);
  /// After classify_face: visits the pairs of the face whose edges lie on the plane.
  template <class Visit>
  void for_pairs_on(FaceId face, Visit&& visit) {
    for_pairs_of_face(c_, face, [&](PairId p) {
      if (sign(pair_tail(c_, p)) == 0 && sign(pair_head(c_, p)) == 0) visit(p);
    });
  }

 private:
  Sign sign(VertexId v) const { return static_cast<Sign>(vertex_state_[v] & 3u) - 1; }
  void set_sign(VertexId v, Sign s) { vertex_state_[v] = now_ << 2 | static_cast<std::uint32_t>(s + 1); }
  Sign side(const ImplicitVertex& at, PlaneId plane, const ApproxPlane& q) const;
  Sign classify(VertexId v, PlaneId plane, const ApproxPlane& q) {
    if (vertex_state_[v] >> 2 != now_) set_sign(v, side(c_.vertices[v].place, plane, q));
    return sign(v);
  }
  void make_room();
  bool walk(CellId cell, PlaneId plane);
  VertexId split_edge(EdgeId edge, PlaneId plane);
  FaceId split_face(FaceId face, PlaneId plane, EdgeId* between);
  FaceId cap(CellId back, CellId front, PlaneId plane);
  void join_clock(PairId before, PairId after);
  void join_spin(PairId before, PairId after);

  Complex& c_;
  // The number of the cut that last came by, shifted, and what it found: of a vertex its sign and 1, of a face on which
  // sides it has vertices (bit 0: behind, bit 1: in front).
  std::vector<std::uint32_t> vertex_state_, face_state_;
  std::uint32_t now_ = 0;
  std::vector<FaceId> faces_;
  std::vector<EdgeId> crossing_;
  struct Rim {
    PairId before;  // counter-clockwise around an edge in the plane the cell comes after it
    bool from_behind;
  };
  std::vector<Rim> rim_;
  std::vector<PairId> ring_;
  std::vector<PairId> rim_at_;  // by vertex: the rim pair that starts there
};

}  // namespace sightline
