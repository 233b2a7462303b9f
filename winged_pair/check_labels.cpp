// Fifth stage: faces against the surfaces in their plane.
//
// Two convex polygons in a plane have disjoint interiors if and only if the line of an edge of one separates them. A
// surface is covered by the faces that carry it if each edge of these faces either has another such face beyond it or
// lies on the surface's border: their union is closed, not empty, and has no border inside the surface.
#include "winged_pair/check_stages.hpp"
#include "winged_pair/traverse.hpp"

#include <algorithm>

namespace sightline::check_detail {
namespace {

/// Bounds of a convex polygon in unit coordinates, no smaller than it.
struct Bounds {
  glm::dvec3 low{2, 2, 2}, high{-2, -2, -2};
  void include(const glm::dvec3& x, double error) {
    for (int k = 0; k < 3; ++k) {
      // The sums are rounded, by less than 2^-52 for unit coordinates: 2^-50 more covers it.
      low[k] = std::min(low[k], x[k] - error - 0x1p-50);
      high[k] = std::max(high[k], x[k] + error + 0x1p-50);
    }
  }
  bool meets(const Bounds& o) const {
    for (int k = 0; k < 3; ++k) {
      if (low[k] > o.high[k] || high[k] < o.low[k]) return false;
    }
    return true;
  }
};

class LabelCheck {
 public:
  LabelCheck(const Complex& c, const Scene& scene, Faults& faults)
      : c_(c), scene_(scene), faults_(faults), loops_(make_loops(c)), carried_(scene.surfaces().size(), 0) {}

  void run() {
    std::vector<std::pair<PlaneId, FaceId>> faces;
    std::vector<std::pair<PlaneId, SurfaceId>> surfaces;
    for (FaceId f = 0; f < c_.faces.size(); ++f) faces.emplace_back(c_.faces[f].plane, f);
    for (SurfaceId s = 0; s < scene_.surfaces().size(); ++s) surfaces.emplace_back(scene_.surfaces()[s].plane, s);
    std::sort(faces.begin(), faces.end());
    std::sort(surfaces.begin(), surfaces.end());
    auto s = surfaces.begin();
    for (auto f = faces.begin(); f != faces.end() && !faults_.full();) {
      const PlaneId plane = f->first;
      auto faces_end = f, surfaces_end = s;
      while (faces_end != faces.end() && faces_end->first == plane) ++faces_end;
      while (surfaces_end != surfaces.end() && surfaces_end->first < plane) ++surfaces_end;
      s = surfaces_end;
      while (surfaces_end != surfaces.end() && surfaces_end->first == plane) ++surfaces_end;
      check_plane({f, faces_end}, {s, surfaces_end});
      f = faces_end;
      s = surfaces_end;
    }
    for (SurfaceId k = 0; k < carried_.size() && !faults_.full(); ++k) {
      if (carried_[k] == 0) faults_.add("surface ", k, " of polygon ", scene_.surfaces()[k].polygon, ": on no face");
    }
  }

 private:
  template <class Id>
  struct Placed {
    Id id;
    Bounds bounds;
  };

  /// Sweeps along the wider of the plane's axes, so that only polygons whose bounds meet are compared.
  void check_plane(std::span<const std::pair<PlaneId, FaceId>> face_ids,
                   std::span<const std::pair<PlaneId, SurfaceId>> surface_ids) {
    if (surface_ids.empty()) {
      std::vector<SurfaceId> nothing;
      for (const auto& [plane, f] : face_ids) check_label(f, nothing);
      return;
    }
    std::vector<Placed<FaceId>> faces;
    std::vector<Placed<SurfaceId>> surfaces;
    Bounds all;
    for (const auto& [plane, f] : face_ids) {
      Placed<FaceId> placed{f, {}};
      for (const PairId p : loops_.of(f)) {
        const ImplicitVertex& place = c_.vertices[pair_tail(c_, p)].place;
        placed.bounds.include(place.approx, place.error);
        all.include(place.approx, place.error);
      }
      faces.push_back(placed);
    }
    for (const auto& [plane, s] : surface_ids) {
      Placed<SurfaceId> placed{s, {}};
      for (const Corner& corner : corners(s)) {
        if (corner.point == none) {
          placed.bounds.include(corner.place.approx, corner.place.error);
        } else {
          placed.bounds.include(scene_.points().approx(corner.point), 0x1p-54);
        }
      }
      surfaces.push_back(placed);
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (all.high[k] - all.low[k] > all.high[axis] - all.low[axis]) axis = k;
    }
    const auto lower = [axis](const auto& a, const auto& b) {
      return a.bounds.low[axis] < b.bounds.low[axis] || (a.bounds.low[axis] == b.bounds.low[axis] && a.id < b.id);
    };
    std::sort(faces.begin(), faces.end(), lower);
    std::sort(surfaces.begin(), surfaces.end(), lower);

    // Faces whose sweep interval begins later than a surface's must still meet it: both lists are kept open.
    std::vector<std::vector<SurfaceId>> inside(faces.size());
    std::vector<std::size_t> open_faces, open_surfaces;
    std::size_t f = 0, s = 0;
    while (f < faces.size() || s < surfaces.size()) {
      const bool face_next =
          s == surfaces.size() || (f < faces.size() && faces[f].bounds.low[axis] <= surfaces[s].bounds.low[axis]);
      const double at = face_next ? faces[f].bounds.low[axis] : surfaces[s].bounds.low[axis];
      std::erase_if(open_faces, [&](std::size_t k) { return faces[k].bounds.high[axis] < at; });
      std::erase_if(open_surfaces, [&](std::size_t k) { return surfaces[k].bounds.high[axis] < at; });
      if (face_next) {
        for (const std::size_t k : open_surfaces) compare(faces[f], surfaces[k], inside[f]);
        open_faces.push_back(f++);
      } else {
        for (const std::size_t k : open_faces) compare(faces[k], surfaces[s], inside[k]);
        open_surfaces.push_back(s++);
      }
    }
    for (std::size_t k = 0; k < faces.size() && !faults_.full(); ++k) check_label(faces[k].id, inside[k]);
  }

  void compare(const Placed<FaceId>& face, const Placed<SurfaceId>& surface, std::vector<SurfaceId>& inside) {
    if (!face.bounds.meets(surface.bounds) || faults_.full()) return;
    if (lies_inside(face.id, surface.id)) {
      inside.push_back(surface.id);
    } else if (!disjoint(face.id, surface.id)) {
      faults_.add("face ", face.id, ": partly inside surface ", surface.id, " of polygon ",
                  scene_.surfaces()[surface.id].polygon);
    }
  }

  bool lies_inside(FaceId f, SurfaceId s) const {
    for (const SurfaceEdge& edge : scene_.edges(scene_.surfaces()[s])) {
      for (const PairId p : loops_.of(f)) {
        if (vertex_side(c_.planes, c_.vertices[pair_tail(c_, p)].place, edge.wall) == -edge.inside) return false;
      }
    }
    return true;
  }

  bool disjoint(FaceId f, SurfaceId s) const {
    for (const SurfaceEdge& edge : scene_.edges(scene_.surfaces()[s])) {
      bool beyond = true;
      for (const PairId p : loops_.of(f)) {
        beyond &= vertex_side(c_.planes, c_.vertices[pair_tail(c_, p)].place, edge.wall) != edge.inside;
      }
      if (beyond) return true;
    }
    const std::vector<Corner> points = corners(s);
    for (const PairId p : loops_.of(f)) {
      const PlaneId wall = wall_of(c_.edges[c_.pairs[p].edge], c_.faces[f].plane);
      const Sign inner = side_of_face(c_, loops_.of(f), wall);
      bool beyond = true;
      for (const Corner& corner : points) beyond &= side(corner, wall) != inner;
      if (beyond) return true;
    }
    return false;
  }

  /// A corner of a surface: a point of the scene, or where the surface's plane and the walls of two edges meet.
  struct Corner {
    PointId point;
    ImplicitVertex place;  // of the second kind only
  };
  std::vector<Corner> corners(SurfaceId s) const {
    const Surface& surface = scene_.surfaces()[s];
    const auto edges = scene_.edges(surface);
    std::vector<Corner> points;
    points.reserve(edges.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      Corner corner{edges[k].corner, {}};
      const PlaneId next = edges[(k + 1) % edges.size()].wall;
      if (corner.point == none) corner.place = make_vertex(c_.planes, surface.plane, edges[k].wall, next);
      points.push_back(corner);
    }
    return points;
  }

  Sign side(const Corner& corner, PlaneId wall) const {
    return corner.point == none ? vertex_side(c_.planes, corner.place, wall)
                                : point_side(c_.planes, corner.point, wall);
  }

  void check_label(FaceId f, std::vector<SurfaceId>& inside) {
    std::sort(inside.begin(), inside.end());
    const auto label = c_.surfaces_on(c_.faces[f]);
    if (!std::ranges::equal(label, inside)) {
      std::string truth;
      for (const SurfaceId s : inside) truth += " " + std::to_string(s);
      faults_.add("face ", f, ": label ", c_.faces[f].label, " is wrong, the surfaces on it are",
                  truth.empty() ? " none" : truth);
      return;
    }
    for (const SurfaceId s : label) {
      carried_[s] = 1;
      for (const PairId p : loops_.of(f)) {
        if (!carried_beyond(f, p, s) && !on_border(p, s)) {
          faults_.add("surface ", s, " of polygon ", scene_.surfaces()[s].polygon, ": not covered beyond edge ",
                      c_.pairs[p].edge, " of face ", f);
          return;
        }
      }
    }
  }

  /// Does another face at the pair's edge, in the same plane, carry the surface?
  bool carried_beyond(FaceId f, PairId p, SurfaceId s) const {
    for (PairId q = c_.pairs[p].spin[1]; q != p; q = c_.pairs[q].spin[1]) {
      const Face& other = c_.faces[c_.pairs[q].face];
      if (other.plane == c_.faces[f].plane && std::ranges::binary_search(c_.surfaces_on(other), s)) return true;
    }
    return false;
  }

  bool on_border(PairId p, SurfaceId s) const {
    const Edge& edge = c_.edges[c_.pairs[p].edge];
    for (const SurfaceEdge& border : scene_.edges(scene_.surfaces()[s])) {
      if (vertex_side(c_.planes, c_.vertices[edge.vertex[0]].place, border.wall) == 0 &&
          vertex_side(c_.planes, c_.vertices[edge.vertex[1]].place, border.wall) == 0) {
        return true;
      }
    }
    return false;
  }

  const Complex& c_;
  const Scene& scene_;
  Faults& faults_;
  Loops loops_;
  std::vector<char> carried_;
};

}  // namespace

void check_labels(const Complex& c, const Scene& scene, Faults& faults) { LabelCheck(c, scene, faults).run(); }

}  // namespace sightline::check_detail
