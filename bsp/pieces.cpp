#include "bsp/pieces.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sightline {

void Pieces::bound(Piece& piece) const {
  piece.low = piece.high = corners_[piece.first].place.approx;
  for (const PieceCorner& c : corners(piece)) {
    piece.low = glm::min(piece.low, c.place.approx);
    piece.high = glm::max(piece.high, c.place.approx);
  }
}

double Pieces::area(const Piece& piece) const {
  const auto corner = corners(piece);
  glm::dvec3 sum{0, 0, 0};
  for (std::size_t k = 2; k < corner.size(); ++k) {
    sum += glm::cross(corner[k - 1].place.approx - corner[0].place.approx,
                      corner[k].place.approx - corner[0].place.approx);
  }
  return glm::length(sum) / 2;
}

Piece Pieces::whole(SurfaceId surface) {
  const Surface& s = scene_.surfaces()[surface];
  const auto edges = scene_.edges(s);
  Piece piece{surface, s.plane, static_cast<std::uint32_t>(corners_.size()), s.edge_count, {}, {}};
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const SurfaceEdge& before = edges[k == 0 ? edges.size() - 1 : k - 1];
    PieceCorner corner{{}, before.corner, edges[k].wall, 0};
    if (before.corner != none) {
      corner.place = {{s.plane, before.wall, edges[k].wall}, 0x1p-53, scene_.points().approx(before.corner)};
    } else {
      corner.place = make_vertex(planes_, s.plane, before.wall, edges[k].wall);
    }
    corners_.push_back(corner);
  }
  bound(piece);
  return piece;
}

Piece Pieces::piece(SurfaceId surface, std::uint32_t first, std::uint32_t count) const {
  Piece piece{surface, scene_.surfaces()[surface].plane, first, count, {}, {}};
  bound(piece);
  return piece;
}

int Pieces::sides(const Piece& piece, PlaneId plane) {
  if (piece.plane == plane) return 0;
  sign_.clear();
  CornerSides side(scene_, planes_, piece.surface, plane);
  int found = 0;
  for (const PieceCorner& c : corners(piece)) {
    const Sign s = side.of(c);
    sign_.push_back(static_cast<std::int8_t>(s));
    found |= s < 0 ? 1 : s > 0 ? 2 : 0;
  }
  return found;
}

int Pieces::exact_sides(const Piece& piece, PlaneId plane) const {
  CornerSides side(scene_, planes_, piece.surface, plane);
  int found = 0;
  for (const PieceCorner& c : corners(piece)) {
    const Sign s = side.of(c);
    found |= s < 0 ? 1 : s > 0 ? 2 : 0;
  }
  return found;
}

/// Where the plane cuts a side of the piece.
ImplicitVertex Pieces::meet(const Piece& piece, PlaneId side, PlaneId plane) const {
  const auto edges = scene_.edges(scene_.surfaces()[piece.surface]);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const SurfaceEdge& e = edges[k];
    if (e.wall != side || e.corner != e.b || edges[k == 0 ? edges.size() - 1 : k - 1].corner != e.a) continue;
    return make_edge_vertex(planes_, piece.plane, side, plane, e.a, e.b);
  }
  return make_vertex(planes_, piece.plane, side, plane);
}

void Pieces::split(const Piece& piece, PlaneId plane, Piece& behind, Piece& front) {
  for (auto& half : halves_) half.clear();
  const auto corner = corners(piece);
  const std::size_t n = corner.size();
  for (std::size_t k = 0; k < n; ++k) {
    const int here = sign_[k], next = sign_[(k + 1) % n];
    if (here == 0) {
      // Where a half leaves the plane the old edge follows, where it enters it the cut does.
      for (const Sign half : {-1, 1}) {
        halves_[half > 0].push_back(corner[k]);
        if (next == half) continue;
        halves_[half > 0].back().side = plane;
        halves_[half > 0].back().inside = half;
      }
      continue;
    }
    halves_[here > 0].push_back(corner[k]);
    if (here * next < 0) {
      PieceCorner made{meet(piece, corner[k].side, plane), none, plane, here};
      halves_[here > 0].push_back(made);
      made.side = corner[k].side;
      made.inside = corner[k].inside;
      halves_[here < 0].push_back(made);
    }
  }
  Piece* const out[2] = {&behind, &front};
  for (int h = 0; h < 2; ++h) {
    *out[h] = {piece.surface,
               piece.plane,
               static_cast<std::uint32_t>(corners_.size()),
               static_cast<std::uint32_t>(halves_[h].size()),
               {},
               {}};
    corners_.insert(corners_.end(), halves_[h].begin(), halves_[h].end());
    bound(*out[h]);
  }
}

}  // namespace sightline
