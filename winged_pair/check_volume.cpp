// The cells' volumes add up to the box, exactly, by sums in which equal terms of opposite sign cancel by name.
//
// By the divergence theorem three times a convex cell's volume is the sum over its faces of outward distance times
// area. A face between two cells stands in the sums of both with opposite signs, so the total is that of the outer
// faces. These must lie in the box's six sides, where the distance is the side's coordinate. Twice the area of the
// faces in one side is the sum of tail x head over their pairs; an edge between two of these faces stands in it twice
// with opposite signs. What is left must lie on the border of the side, where a term is (+-) coordinate * (head -
// tail), and vertices between two border edges cancel in turn. What is left then is added in rationals: a few corners.
#include "winged_pair/check_stages.hpp"
#include "winged_pair/traverse.hpp"

#include <map>

namespace sightline::check_detail {
namespace {

struct Side {
  int axis;
  std::uint32_t end;  // 0 lower, 1 upper
};

/// The box side in whose plane an outer face lies; axis -1 if in none, or if its inside looks out of the box.
Side side_of_face_on_box(const Complex& c, const Face& face) {
  const int axis = c.planes.axis(face.plane);
  if (axis < 0) return {-1, 0};
  const std::uint32_t end = face.cell[1] == none ? 1 : 0;
  if (c.planes.integer(face.plane, 3) != c.box[end][axis]) return {-1, 0};
  return {axis, end};
}

bool on_axis_plane(const Complex& c, VertexId v, int axis, const Integer& value) {
  const ExactVertex exact = exact_vertex(c.planes, c.vertices[v].place.plane);
  return exact.c[static_cast<std::size_t>(axis)] == value * exact.w;
}

/// Twice the area of a side's faces, from their pairs counted with sign; nothing after a fault.
mpq_class twice_area(const Complex& c, Side side, const std::map<EdgeId, int>& border, Faults& faults) {
  const int x = (side.axis + 1) % 3, y = (side.axis + 2) % 3;
  // On x = value a term tail x head is value * (head.y - tail.y), on y = value it is -value * (head.x - tail.x).
  struct Line {
    int axis;
    std::uint32_t end;
    auto operator<=>(const Line&) const = default;
  };
  std::map<std::pair<Line, VertexId>, int> ends;
  for (const auto& [e, count] : border) {
    if (count == 0) continue;
    const auto& vertex = c.edges[e].vertex;
    Line line{-1, 0};
    for (const int axis : {x, y}) {
      for (std::uint32_t end = 0; end < 2; ++end) {
        const Integer& value = c.box[end][axis];
        if (on_axis_plane(c, vertex[0], axis, value) && on_axis_plane(c, vertex[1], axis, value)) line = {axis, end};
      }
    }
    if (line.axis < 0) {
      faults.add("edge ", e, ": the outer faces beside it do not cover their side of the box");
      return 0;
    }
    ends[{line, vertex[1]}] += count;
    ends[{line, vertex[0]}] -= count;
  }
  mpq_class sum = 0;
  for (const auto& [end, count] : ends) {
    if (count == 0) continue;
    const auto& [line, v] = end;
    const ExactVertex exact = exact_vertex(c.planes, c.vertices[v].place.plane);
    const int along = line.axis == x ? y : x;
    mpq_class coordinate(exact.c[static_cast<std::size_t>(along)], exact.w);
    coordinate.canonicalize();
    sum += (line.axis == x ? count : -count) * mpq_class(c.box[line.end][line.axis]) * coordinate;
  }
  return sum;
}

}  // namespace

void check_volume(const Complex& c, Faults& faults) {
  std::map<EdgeId, int> border[3][2];
  for (FaceId f = 0; f < c.faces.size(); ++f) {
    const Face& face = c.faces[f];
    if (face.cell[0] != none && face.cell[1] != none) continue;
    const Side side = side_of_face_on_box(c, face);
    if (side.axis < 0) {
      faults.add("face ", f, ": on the outside, but not in a side of the box");
      if (faults.full()) return;
      continue;
    }
    for_pairs_of_face(
        c, f, [&](PairId p) { border[side.axis][side.end][c.pairs[p].edge] += c.pairs[p].direction == 0 ? 1 : -1; });
  }
  if (!faults.empty()) return;
  mpq_class volume = 0;  // six times
  Integer box = 6;
  for (int axis = 0; axis < 3; ++axis) box *= c.box[1][axis] - c.box[0][axis];
  for (int axis = 0; axis < 3; ++axis) {
    for (std::uint32_t end = 0; end < 2; ++end) {
      const mpq_class area = twice_area(c, {axis, end}, border[axis][end], faults);
      volume += (end == 1 ? 1 : -1) * mpq_class(c.box[end][axis]) * area;
    }
  }
  if (!faults.empty()) return;
  if (volume != box) faults.add("the cells' volumes do not add up to the box");
}

}  // namespace sightline::check_detail
