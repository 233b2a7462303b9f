#include "bsp/label.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace sightline {
namespace {

// Sign of (b - a).(n_p x n_q), where a-b lies in both planes and they meet at an angle well away from 0 (a wall and the
// plane whose steepest axis it is parallel to: sin >= 1/sqrt(3)). The product's largest component is then at least a
// third of the normals' lengths, far above its rounding error, so its sign is certain; the points are compared exactly.
Sign along(const PlaneTable& planes, PlaneId p, PlaneId q, PointId a, PointId b) {
  const double* m = planes.approx(p).n;
  const double* n = planes.approx(q).n;
  const double t[3] = {m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2], m[0] * n[1] - m[1] * n[0]};
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(t[i]) > std::abs(t[k])) k = i;
  }
  const Sign rising = compare(planes.points(), b, a, k);
  return t[k] > 0 ? rising : -rising;
}

}  // namespace

// Do the interiors of the face and the piece lie on two sides of one of the face's edges?
bool Labeller::apart(FaceId face, const Piece& piece, const Pieces& arena) const {
  const PlaneId own = c_.faces[face].plane;
  bool found = false;
  for_pairs_of_face(c_, face, [&](PairId p) {
    if (found) return;
    const Edge& e = c_.edges[c_.pairs[p].edge];
    const PlaneId other = e.plane[0] == own ? e.plane[1] : e.plane[0];
    Sign inner = 0;
    for (PairId q = c_.pairs[p].clock[1]; q != p && inner == 0; q = c_.pairs[q].clock[1]) {
      inner = vertex_side(c_.planes, c_.vertices[pair_head(c_, q)].place, other);
    }
    for (const PieceCorner& corner : arena.corners(piece)) {
      if (arena.side(corner, other) == inner) return;
    }
    found = true;
  });
  return found;
}

// The edges of a face that lie on the wall of a polygon's edge lie on that edge's line: they take its name.
void Labeller::name_edges(FaceId face, const SurfaceEdge& edge) {
  const PlaneId own = c_.faces[face].plane;
  const Sign forwards = along(c_.planes, own, edge.wall, edge.a, edge.b);
  Sign face_side = 0;  // on which side of the wall the face lies
  for_pairs_of_face(c_, face, [&](PairId p) {
    if (face_side == 0) face_side = splitter_.sign(pair_tail(c_, p));
  });
  splitter_.for_pairs_on(face, [&](PairId p) {
    Edge& e = c_.edges[c_.pairs[p].edge];
    if (e.a != none) return;
    // Counter-clockwise around the face its inside is on the left: along n_face x n_wall if the face lies behind.
    const Sign direction = -face_side * (c_.pairs[p].direction == 0 ? 1 : -1) * forwards;
    e.a = direction > 0 ? edge.a : edge.b;
    e.b = direction > 0 ? edge.b : edge.a;
  });
}

/// Bounds of the face's corners, rounded.
Labeller::Bounds Labeller::bounds(FaceId face) const {
  Bounds b{glm::dvec3{INFINITY}, glm::dvec3{-INFINITY}};
  for_pairs_of_face(c_, face, [&](PairId p) {
    const glm::dvec3& at = c_.vertices[pair_tail(c_, p)].place.approx;
    b.low = glm::min(b.low, at);
    b.high = glm::max(b.high, at);
  });
  return b;
}

void Labeller::label(FaceId face, std::span<const Piece> pieces, const Pieces& arena) {
  faces_.assign(1, face);
  bounds_.assign(1, bounds(face));
  for (const Piece& piece : pieces) {
    const auto edges = scene_.edges(scene_.surfaces()[piece.surface]);
    for (std::size_t k = 0, n = faces_.size(); k < n; ++k) {
      // Most are far from each other. Both boxes are rounded, by less than 2^-46.
      constexpr double clear = 0x1p-40;
      if (glm::any(glm::greaterThan(piece.low - bounds_[k].high, glm::dvec3{clear})) ||
          glm::any(glm::greaterThan(bounds_[k].low - piece.high, glm::dvec3{clear}))) {
        continue;
      }
      const FaceId inside = faces_[k];
      bool outside = false, crossed = false;
      for (const SurfaceEdge& e : edges) {
        const auto side = splitter_.classify_face(inside, e.wall);
        if (side == Splitter::Side::crossed) {
          crossed = true;
        } else {
          name_edges(inside, e);
          outside |= side != (e.inside > 0 ? Splitter::Side::front : Splitter::Side::behind);
        }
        if (outside) break;
      }
      if (outside || (crossed && apart(inside, piece, arena))) continue;
      FaceId rest = inside;  // what is left of the face inside of the walls so far
      for (const SurfaceEdge& e : edges) {
        if (splitter_.classify_face(rest, e.wall) != Splitter::Side::crossed) continue;
        EdgeId between;
        const FaceId front = splitter_.cut_face(rest, e.wall, &between);
        const Sign forwards = along(c_.planes, c_.edges[between].plane[0], e.wall, e.a, e.b);
        c_.edges[between].a = forwards > 0 ? e.a : e.b;
        c_.edges[between].b = forwards > 0 ? e.b : e.a;
        if (e.inside > 0) {
          faces_.push_back(rest);
          rest = front;
        } else {
          faces_.push_back(front);
        }
        bounds_.push_back(bounds(faces_.back()));
      }
      bounds_[k] = bounds(rest);
      faces_[k] = rest;
      c_.faces[rest].label = labels_.with(c_.faces[rest].label, piece.surface);
    }
  }
}

}  // namespace sightline
