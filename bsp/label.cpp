#include "bsp/label.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>

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

// Most are far from each other. Boxes are rounded, by less than 2^-46.
template <class A, class B>
bool clear_of(const A& a, const B& b) {
  constexpr double clear = 0x1p-40;
  return glm::any(glm::greaterThan(a.low - b.high, glm::dvec3{clear})) ||
         glm::any(glm::greaterThan(b.low - a.high, glm::dvec3{clear}));
}

constexpr std::size_t few = 8;  // faces, or pieces, to be taken one by one

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

// The edges of a face that lie on the wall of a polygon's edge lie on that edge's line: they take its name. `side`: on
// which side of the wall the face lies.
void Labeller::name_edges(FaceId face, Sign side, const SurfaceEdge& edge) {
  Sign forwards = 0;
  splitter_.for_pairs_on(face, [&](PairId p) {
    Edge& e = c_.edges[c_.pairs[p].edge];
    if (e.a != none) return;
    if (forwards == 0) forwards = along(c_.planes, c_.faces[face].plane, edge.wall, edge.a, edge.b);
    // Counter-clockwise around the face its inside is on the left: along n_face x n_wall if the face lies behind.
    const Sign direction = -side * (c_.pairs[p].direction == 0 ? 1 : -1) * forwards;
    e.a = direction > 0 ? edge.a : edge.b;
    e.b = direction > 0 ? edge.b : edge.a;
  });
}

/// Bounds of the face's corners, rounded.
Labeller::Box Labeller::bounds(FaceId face) const {
  Box b{glm::dvec3{INFINITY}, glm::dvec3{-INFINITY}};
  for_pairs_of_face(c_, face, [&](PairId p) {
    const glm::dvec3& at = c_.vertices[pair_tail(c_, p)].place.approx;
    b.low = glm::min(b.low, at);
    b.high = glm::max(b.high, at);
  });
  return b;
}

void Labeller::note(FaceId face, std::span<const Piece> pieces) {
  if (pieces.empty()) return;
  c_.faces[face].label = static_cast<LabelId>(first_.size() - 1);
  for (const Piece& p : pieces) noted_.push_back({p.surface, p.first, p.count});
  first_.push_back(static_cast<std::uint32_t>(noted_.size()));
}

void Labeller::finish(const Pieces& arena) {
  // Faces by the cut that made them, in order.
  std::vector<std::uint32_t> end(first_.size(), 0);
  for (const Face& f : c_.faces) ++end[f.label];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<FaceId> faces(c_.faces.size());
  for (auto f = static_cast<FaceId>(faces.size()); f-- > 0;) faces[--end[c_.faces[f].label]] = f;
  for (const FaceId f : faces) c_.faces[f].label = 0;
  end.push_back(static_cast<std::uint32_t>(faces.size()));

  for (std::size_t cut = 1; cut + 1 < first_.size(); ++cut) {
    faces_.clear();
    for (std::uint32_t k = end[cut]; k < end[cut + 1]; ++k) faces_.push_back({faces[k], bounds(faces[k])});
    pieces_.clear();
    near_.clear();
    for (std::uint32_t k = first_[cut]; k < first_[cut + 1]; ++k) {
      near_.push_back(static_cast<std::uint32_t>(pieces_.size()));
      pieces_.push_back(arena.piece(noted_[k].surface, noted_[k].first, noted_[k].count));
    }
    meet(faces_, 0, arena);
  }
}

/// Faces and pieces of one plane, those of near_ from `first` on: halved by place until few are left.
void Labeller::meet(std::span<Found> faces, std::size_t first, const Pieces& arena) {
  if (faces.size() <= few || near_.size() - first <= few) {
    for (const Found& f : faces) label(f, first, arena);
    return;
  }
  const auto twice_centre = [](const Found& f) { return f.box.low + f.box.high; };
  glm::dvec3 low = twice_centre(faces[0]), high = low;
  for (const Found& f : faces) {
    low = glm::min(low, twice_centre(f));
    high = glm::max(high, twice_centre(f));
  }
  const glm::dvec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const double middle = (low[axis] + high[axis]) / 2;
  scratch_.clear();
  std::size_t below = 0;
  for (const Found& f : faces) {
    if (twice_centre(f)[axis] < middle) {
      faces[below++] = f;
    } else {
      scratch_.push_back(f);
    }
  }
  std::copy(scratch_.begin(), scratch_.end(), faces.begin() + static_cast<std::ptrdiff_t>(below));
  if (below == 0) {  // all in one place
    for (const Found& f : faces) label(f, first, arena);
    return;
  }
  const std::size_t mine = near_.size();
  for (const auto part : {faces.first(below), faces.subspan(below)}) {
    Box box = part[0].box;
    for (const Found& f : part) {
      box.low = glm::min(box.low, f.box.low);
      box.high = glm::max(box.high, f.box.high);
    }
    for (std::size_t k = first; k < mine; ++k) {
      if (!clear_of(pieces_[near_[k]], box)) near_.push_back(near_[k]);
    }
    meet(part, mine, arena);
    near_.resize(mine);
  }
}

void Labeller::label(const Found& face, std::size_t first, const Pieces& arena) {
  parts_.assign(1, face);
  for (std::size_t i = first; i < near_.size(); ++i) {
    const Piece& piece = pieces_[near_[i]];
    if (clear_of(piece, face.box)) continue;
    for (std::size_t k = 0, n = parts_.size(); k < n; ++k) {
      if (!clear_of(piece, parts_[k].box)) label_part(k, piece, arena);
    }
  }
}

void Labeller::label_part(std::size_t part, const Piece& piece, const Pieces& arena) {
  const auto [face, box] = parts_[part];
  crossed_.clear();
  const auto edges = scene_.edges(scene_.surfaces()[piece.surface]);
  // Most faces lie outside, as neighbours: first the wall that most of the face is beyond of.
  std::size_t start = 0;
  double least = INFINITY;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const ApproxPlane& p = c_.planes.approx(edges[k].wall);
    const glm::dvec3 twice = box.low + box.high;
    const double within = edges[k].inside * (p.n[0] * twice.x + p.n[1] * twice.y + p.n[2] * twice.z - 2 * p.d);
    if (within < least) {
      least = within;
      start = k;
    }
  }
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const SurfaceEdge& e = edges[start + k < edges.size() ? start + k : start + k - edges.size()];
    const Sign clear = BoxSide(c_.planes.approx(e.wall)).of(box.low, box.high);
    Splitter::FaceSide found{clear > 0 ? Splitter::Side::front : Splitter::Side::behind, false};
    if (clear == 0) found = splitter_.classify_face(face, e.wall);
    if (found.side == Splitter::Side::crossed) {
      crossed_.push_back(e);
      continue;
    }
    const Sign side = found.side == Splitter::Side::front ? 1 : -1;
    if (side != e.inside) return;  // its edges on the wall, if any are the piece's, are those of a face inside
    if (found.flush) name_edges(face, side, e);
  }
  if (!crossed_.empty() && apart(face, piece, arena)) return;
  FaceId rest = face;  // what is left of the face inside of the walls so far
  for (const SurfaceEdge& e : crossed_) {
    if (splitter_.classify_face(rest, e.wall).side != Splitter::Side::crossed) continue;
    EdgeId between;
    const FaceId front = splitter_.cut_face(rest, e.wall, &between);
    const Sign forwards = along(c_.planes, c_.edges[between].plane[0], e.wall, e.a, e.b);
    c_.edges[between].a = forwards > 0 ? e.a : e.b;
    c_.edges[between].b = forwards > 0 ? e.b : e.a;
    const FaceId off = e.inside > 0 ? rest : front;
    if (e.inside > 0) rest = front;
    parts_.push_back({off, bounds(off)});
  }
  if (!crossed_.empty()) parts_[part] = {rest, bounds(rest)};
  c_.faces[rest].label = labels_.with(c_.faces[rest].label, piece.surface);
}

}  // namespace sightline
