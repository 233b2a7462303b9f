// A polygon scene, validated once: after `make_scene` nothing about it can fail.
#pragma once

#include "exact/plane_table.hpp"
#include "scene/place_index.hpp"

#include <memory>
#include <string>
#include <vector>

namespace sightline {

using PolygonId = std::uint32_t;  // its place in the file
using SurfaceId = std::uint32_t;  // a convex piece of a polygon

/// Polygons as a file holds them. `first[k]..first[k+1]` are polygon k's entries in `corners`.
struct PolygonSoup {
  std::string source;  // the file's name, without its folder
  std::vector<glm::dvec3> vertices;
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> corners;
  std::vector<std::string> objects;      // distinct `o`/`g` names in order of appearance; may be empty
  std::vector<std::uint32_t> object_of;  // per polygon, index into objects or `none`; empty when there are no names
};

struct SceneOptions {
  std::string snap;        // decimal unit, "" for none
  bool one_sided = false;  // opaque only from the side from which the vertices run counter-clockwise
};

/// One edge of a convex piece: it runs along the line of points a and b (an edge or a diagonal of the polygon).
struct SurfaceEdge {
  PointId a, b;
  PlaneId wall;    // plane through a, b parallel to the axis in which the piece's plane is steepest
  Sign inside;     // the side of `wall` on which the piece lies
  PointId corner;  // the scene point where this edge ends and the next begins; `none` where edges of the file cross
};

/// A convex planar piece of a polygon: a convex polygon is one, others several, which tile it without overlap.
struct Surface {
  PolygonId polygon;
  PlaneId plane;
  std::uint32_t first_edge;
  std::uint32_t edge_count;
  bool flipped;  // the polygon's counter-clockwise normal is opposite to the plane's canonical normal
};

/// What reading changed or left out.
struct SceneReport {
  std::uint32_t dropped = 0;        // polygons of zero area
  std::uint32_t nonplanar = 0;      // cut into triangles
  std::uint32_t nonconvex = 0;      // planar, held as several convex pieces
  std::uint32_t self_crossing = 0;  // among them, read by the even-odd rule
  std::uint32_t duplicates = 0;     // same vertex set as an earlier polygon
  double largest_displacement = 0;  // of a snap, in world units
};

/// Exact scene. Immovable parts are shared, so a Scene can be copied and moved freely.
class Scene {
 public:
  const PolygonSoup& soup() const { return *soup_; }
  std::uint32_t polygon_count() const { return static_cast<std::uint32_t>(soup_->first.size()) - 1; }
  std::span<const std::uint32_t> corners(PolygonId p) const {
    return std::span(soup_->corners).subspan(soup_->first[p], soup_->first[p + 1] - soup_->first[p]);
  }
  const PointTable& points() const { return *points_; }
  const PlaneTable& planes() const { return *planes_; }
  const Grid& grid() const { return points_->grid(); }
  const SceneOptions& options() const { return options_; }
  const SceneReport& report() const { return report_; }

  /// Convex pieces, ascending by polygon. Edges run counter-clockwise seen from the front of the piece's plane.
  std::span<const Surface> surfaces() const { return surfaces_; }
  std::span<const SurfaceEdge> edges(const Surface& s) const {
    return std::span(edges_).subspan(s.first_edge, s.edge_count);
  }
  std::span<const SurfaceEdge> all_edges() const { return edges_; }
  /// The pieces of one polygon; none if it was dropped.
  std::span<const Surface> surfaces(PolygonId p) const {
    return std::span(surfaces_).subspan(first_surface_[p], first_surface_[p + 1] - first_surface_[p]);
  }
  /// True if all its pieces lie in one plane.
  bool planar(PolygonId p) const { return planar_[p]; }
  /// The lowest index of a vertex that is used by a polygon of non-zero area and is the same point as v.
  PointId lowest_twin(PointId v) const { return lowest_twin_[v]; }
  /// The places of vertices of polygons of non-zero area, each by the lowest of its vertices.
  const PlaceIndex& places() const { return places_; }

 private:
  friend Scene make_scene(PolygonSoup soup, const SceneOptions& options);
  std::shared_ptr<const PolygonSoup> soup_;
  std::shared_ptr<const PointTable> points_;
  std::shared_ptr<const PlaneTable> planes_;
  SceneOptions options_;
  SceneReport report_;
  std::vector<Surface> surfaces_;
  std::vector<SurfaceEdge> edges_;
  std::vector<std::uint32_t> first_surface_;
  std::vector<char> planar_;
  std::vector<PointId> lowest_twin_;
  PlaceIndex places_;
};

/// Make a scene exact. Throws SceneError (below) naming vertex or polygon when a coordinate is not finite, an index is
/// out of range or a polygon has fewer than 3 corners; std::invalid_argument when the snap is no positive decimal.
Scene make_scene(PolygonSoup soup, const SceneOptions& options = {});

}  // namespace sightline
