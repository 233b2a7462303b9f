#include "beam/trace.hpp"

#include <chrono>

#include "beam/region.hpp"
#include "beam/topology.hpp"
#include "visibility_map/stitch.hpp"

namespace sightline {

struct Tracer::State {
  State(const Scene& s, const Complex& c)
      : scene(s), complex(c), topology(std::make_shared<const Topology>(c)), table(c.planes) {}
  State(const State& o) : scene(o.scene), complex(o.complex), topology(o.topology), table(o.complex.planes) {}

  void begin(const glm::dvec3& eye);
  void view(Regions::Region region);
  void find_cells();
  void enter_from_outside(Regions::Region region);
  void enter(CellId cell, PlaneId through, Regions::Region region);
  void see(FaceId face, CellId from, Regions::Region region);
  Regions::Region through(FaceId face, Regions::Region region);
  SightlineRef line_of(EdgeId edge);
  bool opaque(FaceId face, Sign eye_side) const;
  void fragment(Regions::Region region, const Face* face);

  const Scene& scene;
  const Complex& complex;
  std::shared_ptr<const Topology> topology;

  SightlineTable table;
  Regions regions;
  Fragments fragments;
  Stitcher stitcher;
  Marks edge_marks, cell_marks, walk_marks;
  std::vector<SightlineRef> edge_line;  // by edge, where edge_marks say so
  std::vector<CellId> eye_cells;        // whose closure holds the eye
  CellId last_cell = 0;
  std::uint32_t beams = 0, cells = 0;
};

void Tracer::State::begin(const glm::dvec3& eye) {
  table.reset(complex.planes, scene.grid().point(eye));
  regions.release(0);
  fragments.clear();
  edge_marks.begin(complex.edges.size());
  edge_line.resize(complex.edges.size());
  cell_marks.begin(complex.cells.size());
  beams = cells = 0;
  find_cells();
}

// The edge's sightline, its normal along (vertex[0] - eye) x (vertex[1] - eye): see Edge.
SightlineRef Tracer::State::line_of(EdgeId e) {
  if (edge_marks.first(e)) {
    const Edge& edge = complex.edges[e];
    edge_line[e] = edge.a != none ? table.of_points(edge.a, edge.b) : table.of_planes(edge.plane[0], edge.plane[1]);
  }
  return edge_line[e];
}

bool Tracer::State::opaque(FaceId f, Sign eye_side) const {
  const Face& face = complex.faces[f];
  if (face.label == 0) return false;
  if (!scene.options().one_sided) return true;
  for (const SurfaceId s : complex.surfaces_on(face)) {
    if (scene.surfaces()[s].flipped == (eye_side < 0)) return true;
  }
  return false;
}

void Tracer::State::fragment(Regions::Region region, const Face* face) {
  Fragment f{static_cast<std::uint32_t>(fragments.sides.size()), region.count,
             static_cast<std::uint32_t>(fragments.seen.size()), 0};
  for (const RegionSide& side : regions.sides(region)) fragments.sides.push_back(side.line);
  if (face) {
    const auto on = complex.surfaces_on(*face);
    if (scene.options().one_sided) {
      const bool behind = table.eye_side(face->plane) < 0;
      for (const SurfaceId s : on) {
        if (scene.surfaces()[s].flipped == behind) fragments.seen.push_back(s);
      }
    } else {
      fragments.seen.insert(fragments.seen.end(), on.begin(), on.end());
    }
    f.seen_count = static_cast<std::uint32_t>(fragments.seen.size()) - f.first_seen;
  }
  fragments.fragments.push_back(f);
}

// The part of the region that is seen through a face. Walked counter-clockwise seen from the front of its plane, a
// side's rays head x tail point inwards for an eye in front, tail x head for an eye behind.
Regions::Region Tracer::State::through(FaceId f, Regions::Region region) {
  const Sign eye = table.eye_side(complex.faces[f].plane);
  for (const FaceSide& side : topology->sides_of(f)) {
    SightlineRef line = line_of(side.edge);
    line.sign *= side.direction == 0 ? -eye : eye;
    region = regions.clip(table, region, line);
    if (region.count == 0) break;
  }
  return region;
}

void Tracer::State::see(FaceId f, CellId from, Regions::Region region) {
  const Face& face = complex.faces[f];
  const CellId next = face.cell[0] == from ? face.cell[1] : face.cell[0];
  if (opaque(f, table.eye_side(face.plane))) {
    fragment(region, &face);
  } else if (next == none) {
    fragment(region, nullptr);
  } else {
    enter(next, face.plane, region);
  }
}

// A beam enters a cell through faces in plane `through` (none: it starts here) and leaves by the faces whose planes the
// eye lies on this side of. These tile it.
void Tracer::State::enter(CellId cell, PlaneId from_plane, Regions::Region region) {
  ++beams;
  if (cell_marks.first(cell)) ++cells;
  for (const FaceId f : topology->faces_of(cell)) {
    const Face& face = complex.faces[f];
    if (face.plane == from_plane) continue;
    if (table.eye_side(face.plane) != (face.cell[0] == cell ? -1 : 1)) continue;
    const std::uint32_t mark = regions.mark();
    const Regions::Region part = through(f, region);
    if (part.count != 0) see(f, cell, part);
    regions.release(mark);
  }
}

// All cells whose closure holds the eye; none if it is outside of the box.
void Tracer::State::find_cells() {
  eye_cells.clear();
  walk_marks.begin(complex.cells.size());
  const auto leaves_by = [&](CellId c) {  // a face whose plane strictly parts the cell from the eye
    for (const FaceId f : topology->faces_of(c)) {
      const Face& face = complex.faces[f];
      if (table.eye_side(face.plane) * (face.cell[0] == c ? -1 : 1) < 0) return f;
    }
    return none;
  };
  CellId at = last_cell;
  for (FaceId f = leaves_by(at); f != none; f = leaves_by(at)) {
    const CellId next = cell_across(complex, f, at);
    if (next == none) return;  // beyond a plane of the box
    if (!walk_marks.first(next)) {
      // The walk has come round in a circle, which it may where cells differ much in size: look at every cell.
      for (at = 0; leaves_by(at) != none; ++at) {
      }
      break;
    }
    at = next;
  }
  last_cell = at;
  walk_marks.begin(complex.cells.size());
  walk_marks.first(at);
  eye_cells.push_back(at);
  for (std::size_t k = 0; k < eye_cells.size(); ++k) {
    for (const FaceId f : topology->faces_of(eye_cells[k])) {
      if (table.eye_side(complex.faces[f].plane) != 0) continue;
      const CellId next = cell_across(complex, f, eye_cells[k]);
      if (next != none && walk_marks.first(next) && leaves_by(next) == none) eye_cells.push_back(next);
    }
  }
}

// Rays that pass by the box see nothing; the others enter through its faces. The box's outline are its edges between
// a face that the eye sees and one that it does not.
void Tracer::State::enter_from_outside(Regions::Region region) {
  PlaneId plane[3][2];
  bool seen[3][2];
  for (int k = 0; k < 3; ++k) {
    for (int high = 0; high < 2; ++high) {
      plane[k][high] = complex.box_plane[k][high];
      seen[k][high] = table.eye_side(plane[k][high]) == (high ? 1 : -1);
    }
  }
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) {
      if (j == k) continue;
      for (int high = 0; high < 4; ++high) {
        const int a = high & 1, b = high >> 1;
        if (!seen[k][a] || seen[j][b]) continue;
        // n = P(eye) n_q - Q(eye) n_p; for x in plane p it has the sign of P(eye) Q(x), and the box lies on Q's inner
        // side.
        SightlineRef line = table.of_planes(plane[k][a], plane[j][b]);
        line.sign *= (a ? 1 : -1) * (b ? -1 : 1);
        const Regions::Region past = regions.clip(table, region, -line);
        if (past.count != 0) fragment(past, nullptr);
        region = regions.clip(table, region, line);
        if (region.count == 0) return;
      }
    }
  }
  for (const FaceId f : topology->outer) {
    const Face& face = complex.faces[f];
    const CellId inside = face.cell[0] == none ? face.cell[1] : face.cell[0];
    if (table.eye_side(face.plane) != (face.cell[0] == none ? -1 : 1)) continue;
    const std::uint32_t mark = regions.mark();
    const Regions::Region part = through(f, region);
    if (part.count != 0) enter(inside, face.plane, part);
    regions.release(mark);
  }
}

// Everything that is seen in a region, from wherever the eye is.
void Tracer::State::view(Regions::Region region) {
  if (eye_cells.empty()) {
    enter_from_outside(region);
    return;
  }
  // An eye on the box's own boundary looks out of it as well.
  for (int k = 0; k < 6; ++k) {
    const PlaneId plane = complex.box_plane[k / 2][k % 2];
    if (table.eye_side(plane) != 0) continue;
    SightlineRef line = table.of_plane(plane);  // its normal points up the axis
    if (k % 2 == 1) line.sign = -line.sign;
    const Regions::Region out = regions.clip(table, region, -line);
    if (out.count != 0) fragment(out, nullptr);
    region = regions.clip(table, region, line);
    if (region.count == 0) return;
  }
  for (const CellId cell : eye_cells) {
    const std::uint32_t mark = regions.mark();
    Regions::Region part = region;
    for (const FaceId f : topology->faces_of(cell)) {
      const Face& face = complex.faces[f];
      if (table.eye_side(face.plane) != 0) continue;
      SightlineRef line = table.of_plane(face.plane);
      if (face.cell[0] == cell) line.sign = -line.sign;
      part = regions.clip(table, part, line);
      if (part.count == 0) break;
    }
    if (part.count != 0) enter(cell, none, part);
    regions.release(mark);
  }
}

Tracer::Tracer(const Scene& scene, const Complex& complex) : state_(std::make_unique<State>(scene, complex)) {}
Tracer::Tracer(const Tracer& other) : state_(std::make_unique<State>(*other.state_)) {}
Tracer::~Tracer() = default;

namespace {

template <class Work>
void timed(TraceStats* stats, VisibilityMap& map, Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  if (!stats) return;
  stats->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  stats->faces = static_cast<std::uint32_t>(map.faces.size());
  stats->edges = static_cast<std::uint32_t>(map.edges.size());
  stats->vertices = static_cast<std::uint32_t>(map.vertices.size());
}

}  // namespace

void Tracer::trace(const Camera& camera, VisibilityMap& map, TraceStats* stats) {
  State& s = *state_;
  timed(stats, map, [&] {
    const Window window(camera.forward, camera.right, camera.up);
    s.begin(camera.eye);
    // Counter-clockwise as an ordinary camera sees it; a mirrored one has its right side on the eye's left.
    const bool mirrored = window.handedness() < 0;
    const SightlineRef sides[] = {
        window.side(s.table, Window::bottom), window.side(s.table, mirrored ? Window::left : Window::right),
        window.side(s.table, Window::top), window.side(s.table, mirrored ? Window::right : Window::left)};
    s.view(s.regions.push(s.table, sides));
    s.stitcher.stitch(s.scene, camera, s.table, s.fragments, map);
  });
  if (stats) {
    stats->beams = s.beams;
    stats->cells = s.cells;
    stats->fragments = static_cast<std::uint32_t>(s.fragments.fragments.size());
  }
}

void Tracer::trace_sphere(const glm::dvec3& eye, VisibilityMap& map, TraceStats* stats) {
  State& s = *state_;
  timed(stats, map, [&] {
    s.begin(eye);
    SightlineRef axis[3];
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Integer, 3> n{0, 0, 0};
      n[k] = 1;
      axis[k] = s.table.of_normal(n);
    }
    for (int octant = 0; octant < 8; ++octant) {
      SightlineRef side[3];
      for (int k = 0; k < 3; ++k) side[k] = octant >> k & 1 ? -axis[k] : axis[k];
      // x, z, y run counter-clockwise around the octant of the positive axes; each mirroring turns that round.
      const bool even = octant == 0 || octant == 3 || octant == 5 || octant == 6;
      const SightlineRef around[] = {side[0], even ? side[2] : side[1], even ? side[1] : side[2]};
      s.view(s.regions.push(s.table, around));
      s.regions.release(0);
    }
    s.stitcher.stitch_sphere(s.scene, eye, s.table, s.fragments, map);
  });
  if (stats) {
    stats->beams = s.beams;
    stats->cells = s.cells;
    stats->fragments = static_cast<std::uint32_t>(s.fragments.fragments.size());
  }
}

}  // namespace sightline
