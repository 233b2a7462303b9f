#include "beam/cells.hpp"

namespace sightline {
namespace {

class Cells : public Engine {
 public:
  Cells(const Scene& scene, const Complex& complex, std::shared_ptr<const Topology> topology, double max_distance)
      : Engine(scene, complex.planes, max_distance), complex_(complex), topology_(std::move(topology)) {}

  std::unique_ptr<Engine> copy() const override {
    return std::make_unique<Cells>(view.scene, complex_, topology_, view.reach.distance());
  }
  void fill(std::span<const SightlineRef> window, const glm::dvec3& ahead) override;

 private:
  void begin() override;
  void find_cells();
  void enter_from_outside(Regions::Region region);
  void enter(CellId cell, PlaneId through, Regions::Region region);
  void see(FaceId face, CellId from, Regions::Region region);
  Regions::Region through(FaceId face, Regions::Region region);
  SightlineRef line_of(EdgeId edge);
  bool opaque(const Face& face, Sign eye_side) const;

  const Complex& complex_;
  std::shared_ptr<const Topology> topology_;
  Marks edge_marks_, cell_marks_, walk_marks_;
  std::vector<SightlineRef> edge_line_;  // by edge, where edge_marks_ say so
  std::vector<CellId> eye_cells_;        // whose closure holds the eye
  CellId last_cell_ = 0;
};

void Cells::begin() {
  edge_marks_.begin(complex_.edges.size());
  edge_line_.resize(complex_.edges.size());
  cell_marks_.begin(complex_.cells.size());
  find_cells();
}

// The edge's sightline, its normal along (vertex[0] - eye) x (vertex[1] - eye): see Edge.
SightlineRef Cells::line_of(EdgeId e) {
  if (edge_marks_.first(e)) {
    const Edge& edge = complex_.edges[e];
    edge_line_[e] =
        edge.a != none ? view.table.of_points(edge.a, edge.b) : view.table.of_planes(edge.plane[0], edge.plane[1]);
  }
  return edge_line_[e];
}

bool Cells::opaque(const Face& face, Sign eye_side) const {
  if (face.label == 0) return false;
  for (const SurfaceId s : complex_.surfaces_on(face)) {
    if (view.opaque(s, eye_side) && view.in_reach(s)) return true;
  }
  return false;
}

// The part of the region that is seen through a face. Walked counter-clockwise seen from the front of its plane, a
// side's rays head x tail point inwards for an eye in front, tail x head for an eye behind.
Regions::Region Cells::through(FaceId f, Regions::Region region) {
  const Sign eye = view.table.eye_side(complex_.faces[f].plane);
  for (const FaceSide& side : topology_->sides_of(f)) {
    SightlineRef line = line_of(side.edge);
    line.sign *= side.direction == 0 ? -eye : eye;
    region = view.regions.clip(view.table, region, line);
    if (region.count == 0) break;
  }
  return region;
}

void Cells::see(FaceId f, CellId from, Regions::Region region) {
  const Face& face = complex_.faces[f];
  const CellId next = face.cell[0] == from ? face.cell[1] : face.cell[0];
  const Sign eye = view.table.eye_side(face.plane);
  if (opaque(face, eye)) {
    view.see(region, complex_.surfaces_on(face), eye);
  } else if (next == none) {
    view.see(region, {}, 0);
  } else {
    enter(next, face.plane, region);
  }
}

// A beam enters a cell through faces in plane `through` (none: it starts here) and leaves by the faces whose planes the
// eye lies on this side of. These tile it.
void Cells::enter(CellId cell, PlaneId from_plane, Regions::Region region) {
  ++view.beams;
  if (cell_marks_.first(cell)) ++view.cells;
  for (const FaceId f : topology_->faces_of(cell)) {
    const Face& face = complex_.faces[f];
    if (face.plane == from_plane) continue;
    if (view.table.eye_side(face.plane) != (face.cell[0] == cell ? -1 : 1)) continue;
    const std::uint32_t mark = view.regions.mark();
    const Regions::Region part = through(f, region);
    if (part.count != 0) see(f, cell, part);
    view.regions.release(mark);
  }
}

// All view.cells whose closure holds the eye; none if it is outside of the box.
void Cells::find_cells() {
  eye_cells_.clear();
  walk_marks_.begin(complex_.cells.size());
  const auto leaves_by = [&](CellId c) {  // a face whose plane strictly parts the cell from the eye
    for (const FaceId f : topology_->faces_of(c)) {
      const Face& face = complex_.faces[f];
      if (view.table.eye_side(face.plane) * (face.cell[0] == c ? -1 : 1) < 0) return f;
    }
    return none;
  };
  CellId at = last_cell_;
  for (FaceId f = leaves_by(at); f != none; f = leaves_by(at)) {
    const CellId next = cell_across(complex_, f, at);
    if (next == none) return;  // beyond a plane of the box
    if (!walk_marks_.first(next)) {
      // The walk has come round in a circle, which it may where view.cells differ much in size: look at every cell.
      for (at = 0; leaves_by(at) != none; ++at) {
      }
      break;
    }
    at = next;
  }
  last_cell_ = at;
  walk_marks_.begin(complex_.cells.size());
  walk_marks_.first(at);
  eye_cells_.push_back(at);
  for (std::size_t k = 0; k < eye_cells_.size(); ++k) {
    for (const FaceId f : topology_->faces_of(eye_cells_[k])) {
      if (view.table.eye_side(complex_.faces[f].plane) != 0) continue;
      const CellId next = cell_across(complex_, f, eye_cells_[k]);
      if (next != none && walk_marks_.first(next) && leaves_by(next) == none) eye_cells_.push_back(next);
    }
  }
}

// Rays that pass by the box see nothing; the others enter through its faces. The box's outline are its edges between
// a face that the eye sees and one that it does not.
void Cells::enter_from_outside(Regions::Region region) {
  PlaneId plane[3][2];
  bool seen[3][2];
  for (int k = 0; k < 3; ++k) {
    for (int high = 0; high < 2; ++high) {
      plane[k][high] = complex_.box_plane[k][high];
      seen[k][high] = view.table.eye_side(plane[k][high]) == (high ? 1 : -1);
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
        SightlineRef line = view.table.of_planes(plane[k][a], plane[j][b]);
        line.sign *= (a ? 1 : -1) * (b ? -1 : 1);
        const Regions::Region past = view.regions.clip(view.table, region, -line);
        if (past.count != 0) view.see(past, {}, 0);
        region = view.regions.clip(view.table, region, line);
        if (region.count == 0) return;
      }
    }
  }
  for (const FaceId f : topology_->outer) {
    const Face& face = complex_.faces[f];
    const CellId inside = face.cell[0] == none ? face.cell[1] : face.cell[0];
    if (view.table.eye_side(face.plane) != (face.cell[0] == none ? -1 : 1)) continue;
    const std::uint32_t mark = view.regions.mark();
    const Regions::Region part = through(f, region);
    if (part.count != 0) enter(inside, face.plane, part);
    view.regions.release(mark);
  }
}

// Everything that is seen in a region, from wherever the eye is.
void Cells::fill(std::span<const SightlineRef> window, const glm::dvec3&) {
  view.regions.release(0);
  Regions::Region region = view.regions.push(view.table, window);
  if (eye_cells_.empty()) {
    enter_from_outside(region);
    return;
  }
  // An eye on the box's own boundary looks out of it as well.
  for (int k = 0; k < 6; ++k) {
    const PlaneId plane = complex_.box_plane[k / 2][k % 2];
    if (view.table.eye_side(plane) != 0) continue;
    SightlineRef line = view.table.of_plane(plane);  // its normal points up the axis
    if (k % 2 == 1) line.sign = -line.sign;
    const Regions::Region out = view.regions.clip(view.table, region, -line);
    if (out.count != 0) view.see(out, {}, 0);
    region = view.regions.clip(view.table, region, line);
    if (region.count == 0) return;
  }
  for (const CellId cell : eye_cells_) {
    const std::uint32_t mark = view.regions.mark();
    Regions::Region part = region;
    for (const FaceId f : topology_->faces_of(cell)) {
      const Face& face = complex_.faces[f];
      if (view.table.eye_side(face.plane) != 0) continue;
      SightlineRef line = view.table.of_plane(face.plane);
      if (face.cell[0] == cell) line.sign = -line.sign;
      part = view.regions.clip(view.table, part, line);
      if (part.count == 0) break;
    }
    if (part.count != 0) enter(cell, none, part);
    view.regions.release(mark);
  }
}

}  // namespace

std::unique_ptr<Engine> cells_engine(const Scene& scene, const Complex& complex, double max_distance) {
  return std::make_unique<Cells>(scene, complex, std::make_shared<const Topology>(complex), max_distance);
}

}  // namespace sightline
