#include "models/storey.hpp"

#include <algorithm>

namespace sightline::models {
namespace {

constexpr int door_width = 5 * units_per_metre / 4, door_height = 2 * units_per_metre + 2;
constexpr int window_width = 3 * units_per_metre / 2, window_head = 9 * units_per_metre / 4;

/// An opening's extent along its wall, about `middle`, and in height.
struct Hole {
  int middle, half_width, low, high;
};

Hole make_hole(Opening kind, int middle, int floor) {
  return kind == Opening::door ? Hole{middle, door_width / 2, floor, floor + door_height}
                               : Hole{middle, window_width / 2, floor + sill, floor + window_head};
}

/// One face of a wall: from `origin` along d, seen from the left of d, or from the right if `outer`.
struct Face {
  Point origin;
  glm::ivec2 d;
  int length, low, high;
  bool outer;

  Point at(int along, int z) const { return {origin.x + d.x * along, origin.y + d.y * along, z}; }
};

void add_ring(Mesh& mesh, std::vector<Point> ring, bool outer) {
  if (outer) std::reverse(ring.begin(), ring.end());
  mesh.polygon(ring);
}

void add_piece(Mesh& mesh, const Face& f, int from, int to, int low, int high) {
  add_ring(mesh, {f.at(to, low), f.at(from, low), f.at(from, high), f.at(to, high)}, f.outer);
}

/// Piers from floor to ceiling, and what is above and below each hole. A short wall with a doorway is one polygon.
void add_face(Mesh& mesh, const Face& f, const std::vector<Hole>& holes) {
  if (holes.size() == 1 && holes[0].low == f.low && f.length <= 2 * cell_size) {
    const int a = holes[0].middle - holes[0].half_width, b = holes[0].middle + holes[0].half_width, h = holes[0].high;
    add_ring(mesh,
             {f.at(f.length, f.low), f.at(b, f.low), f.at(b, h), f.at(a, h), f.at(a, f.low), f.at(0, f.low),
              f.at(0, f.high), f.at(f.length, f.high)},
             f.outer);
    return;
  }
  int from = 0;
  for (const Hole& hole : holes) {
    const int a = hole.middle - hole.half_width, b = hole.middle + hole.half_width;
    add_piece(mesh, f, from, a, f.low, f.high);
    if (hole.low > f.low) add_piece(mesh, f, a, b, f.low, hole.low);
    add_piece(mesh, f, a, b, hole.high, f.high);
    from = b;
  }
  add_piece(mesh, f, from, f.length, f.low, f.high);
}

/// All wall faces along an outline, `inset` to its left.
void add_faces(Mesh& mesh, const Storey& storey, const std::vector<Cell>& outline, int inset, int low, int high) {
  const std::size_t n = outline.size();
  const auto edge = [&](std::size_t i) { return outline[(i + 1) % n] - outline[i % n]; };
  const auto direction = [&](std::size_t i) {
    return glm::ivec2((edge(i).x > 0) - (edge(i).x < 0), (edge(i).y > 0) - (edge(i).y < 0));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const glm::ivec2 d = direction(i), before = left_of(direction(i + n - 1)), after = left_of(direction(i + 1));
    const int cells = std::abs(edge(i).x + edge(i).y);
    const int begin = inset * (before.x * d.x + before.y * d.y), end = inset * (after.x * d.x + after.y * d.y);
    const glm::ivec2 origin = outline[i] * cell_size + left_of(d) * inset + d * begin;
    const Face face{{origin.x, origin.y, 0}, d, cells * cell_size - begin + end, low, high, inset < 0};
    std::vector<Hole> holes;
    for (int k = 0; k < cells; ++k) {
      // The wall between two cells belongs to the one on its right or above.
      const Cell a = outline[i] + d * k, b = a + d;
      const Opening kind =
          storey.plan.opening({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::abs(d.y), std::abs(d.x)});
      if (kind == Opening::none) continue;
      holes.push_back(make_hole(kind, k * cell_size + cell_size / 2 - begin, storey.floor()));
    }
    add_face(mesh, face, holes);
  }
}

void add_level(Mesh& mesh, const std::vector<Cell>& outline, int z, bool ceiling) {
  const std::size_t n = outline.size();
  std::vector<Point> ring;
  for (std::size_t i = 0; i < n; ++i) {
    const auto inward = [&](std::size_t k) {
      const glm::ivec2 e = outline[(k + 1) % n] - outline[k % n];
      return left_of({(e.x > 0) - (e.x < 0), (e.y > 0) - (e.y < 0)});
    };
    const glm::ivec2 p = outline[i] * cell_size + (inward(i + n - 1) + inward(i)) * half_wall;
    ring.emplace_back(p.x, p.y, z);
  }
  add_ring(mesh, ring, ceiling);
}

/// The four sides of every doorway and window within its wall.
void add_jambs(Mesh& mesh, const Storey& storey) {
  const Plan& plan = storey.plan;
  for (int y = 0; y <= plan.rows(); ++y) {
    for (int x = 0; x <= plan.columns(); ++x) {
      const Point at(x * cell_size, y * cell_size, 0);
      for (const glm::ivec2 side : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
        const Opening kind = plan.opening({x, y}, side);
        if (kind == Opening::none) continue;
        const Hole hole = make_hole(kind, cell_size / 2, storey.floor());
        const Point along(side.y, side.x, 0), across(side.x, side.y, 0);
        mesh.hollow(at + along * (hole.middle - hole.half_width) - across * half_wall + Point(0, 0, hole.low),
                    at + along * (hole.middle + hole.half_width) + across * half_wall + Point(0, 0, hole.high),
                    top | bottom | (side.x ? front | back : left | right));
      }
    }
  }
}

}  // namespace

void add_storey(Mesh& mesh, const Storey& storey, int base) {
  const int floor = storey.floor();
  for (int room = 0; room < storey.plan.room_count(); ++room) {
    mesh.object(storey.name() + " room " + std::to_string(room));
    const std::vector<Cell> outline = storey.plan.outline(room);
    const bool shaft = storey.shaft[static_cast<std::size_t>(room)];
    const bool open_above = shaft && storey.level + 1 < storey.levels;
    if (!shaft || storey.level == 0) add_level(mesh, outline, floor, false);
    if (!open_above) add_level(mesh, outline, floor + room_height, true);
    add_faces(mesh, storey, outline, half_wall, floor, floor + (open_above ? storey_height : room_height));
  }
  mesh.object(storey.name() + " doors and windows");
  add_jambs(mesh, storey);
  mesh.object(storey.name() + " facade");
  add_faces(mesh, storey, storey.plan.outline(Plan::outside), -half_wall, base, floor + storey_height);
}

}  // namespace sightline::models
