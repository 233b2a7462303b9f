// First stage: after it every index may be followed without a look.
#include "winged_pair/check_stages.hpp"

namespace sightline::check_detail {
namespace {

void check_vertex_records(const Complex& c, Faults& faults) {
  for (VertexId v = 0; v < c.vertices.size() && !faults.full(); ++v) {
    const Vertex& vertex = c.vertices[v];
    for (const PlaneId p : vertex.place.plane) {
      if (p >= c.planes.size()) faults.add("vertex ", v, ": plane ", p, " out of range");
    }
    if (vertex.edge >= c.edges.size()) {
      faults.add("vertex ", v, ": edge ", vertex.edge, " out of range");
    } else if (c.edges[vertex.edge].vertex[0] != v && c.edges[vertex.edge].vertex[1] != v) {
      faults.add("vertex ", v, ": its edge ", vertex.edge, " does not end in it");
    }
  }
}

void check_edge_records(const Complex& c, const Scene& scene, Faults& faults) {
  const std::uint32_t points = scene.points().size();
  for (EdgeId e = 0; e < c.edges.size() && !faults.full(); ++e) {
    const Edge& edge = c.edges[e];
    for (int k = 0; k < 2; ++k) {
      if (edge.vertex[k] >= c.vertices.size()) faults.add("edge ", e, ": vertex ", edge.vertex[k], " out of range");
      if (edge.plane[k] >= c.planes.size()) faults.add("edge ", e, ": plane ", edge.plane[k], " out of range");
    }
    if (edge.vertex[0] == edge.vertex[1]) faults.add("edge ", e, ": both ends are vertex ", edge.vertex[0]);
    if ((edge.a == none) != (edge.b == none)) faults.add("edge ", e, ": only one scene point on its line");
    for (const PointId p : {edge.a, edge.b}) {
      if (p != none && p >= points) faults.add("edge ", e, ": scene point ", p, " out of range");
    }
    if (edge.pair >= c.pairs.size()) {
      faults.add("edge ", e, ": pair ", edge.pair, " out of range");
    } else if (c.pairs[edge.pair].edge != e) {
      faults.add("edge ", e, ": its pair ", edge.pair, " belongs to edge ", c.pairs[edge.pair].edge);
    }
  }
}

void check_face_records(const Complex& c, Faults& faults) {
  for (FaceId f = 0; f < c.faces.size() && !faults.full(); ++f) {
    const Face& face = c.faces[f];
    for (const CellId cell : face.cell) {
      if (cell != none && cell >= c.cells.size()) faults.add("face ", f, ": cell ", cell, " out of range");
    }
    if (face.cell[0] == face.cell[1]) faults.add("face ", f, ": the same cell on both sides");
    if (face.plane >= c.planes.size()) faults.add("face ", f, ": plane ", face.plane, " out of range");
    if (face.label >= c.label_first.size() - 1) faults.add("face ", f, ": label ", face.label, " out of range");
    if (face.pair >= c.pairs.size()) {
      faults.add("face ", f, ": pair ", face.pair, " out of range");
    } else if (c.pairs[face.pair].face != f) {
      faults.add("face ", f, ": its pair ", face.pair, " belongs to face ", c.pairs[face.pair].face);
    }
  }
  for (CellId k = 0; k < c.cells.size() && !faults.full(); ++k) {
    const FaceId f = c.cells[k].face;
    if (f >= c.faces.size()) {
      faults.add("cell ", k, ": face ", f, " out of range");
    } else if (c.faces[f].cell[0] != k && c.faces[f].cell[1] != k) {
      faults.add("cell ", k, ": its face ", f, " does not bound it");
    }
  }
}

void check_pair_records(const Complex& c, Faults& faults) {
  for (PairId p = 0; p < c.pairs.size() && !faults.full(); ++p) {
    const Pair& pair = c.pairs[p];
    if (pair.face >= c.faces.size()) faults.add("pair ", p, ": face ", pair.face, " out of range");
    if (pair.edge >= c.edges.size()) faults.add("pair ", p, ": edge ", pair.edge, " out of range");
    for (int k = 0; k < 2; ++k) {
      if (pair.clock[k] >= c.pairs.size()) faults.add("pair ", p, ": clock ", pair.clock[k], " out of range");
      if (pair.spin[k] >= c.pairs.size()) faults.add("pair ", p, ": spin ", pair.spin[k], " out of range");
    }
    if (pair.direction > 1) faults.add("pair ", p, ": direction ", pair.direction);
  }
}

void check_label_table(const Complex& c, const Scene& scene, Faults& faults) {
  const auto& first = c.label_first;
  if (first.size() < 2 || first[0] != 0 || first[1] != 0 || first.back() != c.label_surfaces.size()) {
    faults.add("labels: the table must begin with the empty label and end with its last surface");
    return;
  }
  for (std::size_t k = 0; k + 1 < first.size(); ++k) {
    if (first[k] > first[k + 1]) {
      faults.add("label ", k, ": ends before it begins");
      return;
    }
  }
  for (std::size_t k = 1; k + 1 < first.size() && !faults.full(); ++k) {
    if (first[k] == first[k + 1]) faults.add("label ", k, ": empty, as only label 0 may be");
    for (std::uint32_t i = first[k]; i < first[k + 1]; ++i) {
      if (c.label_surfaces[i] >= scene.surfaces().size()) {
        faults.add("label ", k, ": surface ", c.label_surfaces[i], " out of range");
      } else if (i > first[k] && c.label_surfaces[i - 1] >= c.label_surfaces[i]) {
        faults.add("label ", k, ": surfaces not ascending");
      }
    }
  }
}

void check_planes(const Complex& c, const Scene& scene, Faults& faults) {
  if (c.planes.size() < scene.planes().size()) {
    faults.add("planes: ", c.planes.size(), " where the scene has ", scene.planes().size());
    return;
  }
  for (PlaneId p = 0; p < scene.planes().size() && !faults.full(); ++p) {
    for (int k = 0; k < 4; ++k) {
      if (c.planes.integer(p, k) != scene.planes().integer(p, k)) {
        faults.add("plane ", p, ": not the scene's");
        break;
      }
    }
  }
  for (int k = 0; k < 3; ++k) {
    if (c.box[0][k] >= c.box[1][k]) faults.add("box: empty along axis ", k);
    for (int end = 0; end < 2; ++end) {
      const PlaneId p = c.box_plane[k][end];
      if (p >= c.planes.size() || c.planes.axis(p) != k || c.planes.integer(p, 3) != c.box[end][k]) {
        faults.add("box: plane ", p, " is not its ", end == 0 ? "lower" : "upper", " side along axis ", k);
      }
    }
  }
}

}  // namespace

void check_records(const Complex& c, const Scene& scene, Faults& faults) {
  if (c.cells.empty()) faults.add("no cell");
  check_label_table(c, scene, faults);
  check_vertex_records(c, faults);
  check_edge_records(c, scene, faults);
  check_face_records(c, faults);
  check_pair_records(c, faults);
}

void check_references(const Complex& c, const Scene& scene, Faults& faults) {
  check_planes(c, scene, faults);
  check_records(c, scene, faults);
}

}  // namespace sightline::check_detail
