#include "scene/scene.hpp"

#include "exact/predicates.hpp"
#include "scene/decompose.hpp"
#include "scene/errors.hpp"
#include "scene/surface_list.hpp"
#include "scene/triangulate.hpp"
#include "scene/twins.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

void validate(const PolygonSoup& soup) {
  const auto fail = [](const char* kind, std::size_t index, const std::string& what) {
    throw SceneError(std::string(kind) + " " + std::to_string(index) + ": " + what);
  };
  if (soup.vertices.size() >= none || soup.corners.size() >= none) throw SceneError("scene: too many vertices");
  for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
    const glm::dvec3& x = soup.vertices[v];
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z)) fail("vertex", v, "is not finite");
  }
  if (soup.first.empty() || soup.first.front() != 0 || soup.first.back() != soup.corners.size()) {
    throw SceneError("scene: the polygons do not cover the list of corners");
  }
  const std::size_t polygons = soup.first.size() - 1;
  if (!soup.object_of.empty() && soup.object_of.size() != polygons) {
    throw SceneError("scene: not every polygon has an object");
  }
  for (std::size_t p = 0; p < polygons; ++p) {
    if (soup.first[p] > soup.first[p + 1] || soup.first[p + 1] > soup.corners.size() ||
        soup.first[p + 1] - soup.first[p] < 3) {
      fail("polygon", p, "has fewer than 3 vertices");
    }
    for (std::uint32_t k = soup.first[p]; k < soup.first[p + 1]; ++k) {
      if (soup.corners[k] >= soup.vertices.size()) {
        fail("polygon", p,
             "vertex " + std::to_string(soup.corners[k]) + " is out of range, there are " +
                 std::to_string(soup.vertices.size()));
      }
    }
    if (!soup.object_of.empty() && soup.object_of[p] != none && soup.object_of[p] >= soup.objects.size()) {
      fail("polygon", p, "its object is out of range");
    }
  }
}

/// Makes polygon after polygon into surfaces.
class PolygonCutter {
 public:
  PolygonCutter(PlaneTable& planes, std::span<const PointId> representative, const PolygonSoup& soup,
                SceneReport& report)
      : planes_(planes),
        points_(planes.points()),
        representative_(representative),
        report_(report),
        list_(planes, representative, soup.first.size(), soup.corners.size()) {}

  /// True if the polygon is planar.
  bool add(PolygonId polygon, std::span<const std::uint32_t> corners) {
    loop_.clear();
    for (PointId p : corners) {
      if (loop_.empty() || !same(loop_.back(), p)) loop_.push_back(p);
    }
    while (loop_.size() > 1 && same(loop_.front(), loop_.back())) loop_.pop_back();
    const std::size_t before = list_.surfaces.size();
    const PlaneTable::Interned plane = plane_of_loop();
    bool planar = true;
    if (plane.id != none) {
      planar = loop_.size() == 3 || std::all_of(loop_.begin(), loop_.end(),
                                                [&](PointId p) { return point_side(planes_, p, plane.id) == 0; });
      if (!planar) {
        add_triangles(polygon, plane);
      } else if (loop_.size() == 3) {
        list_.add(polygon, plane, loop_);
      } else {
        add_planar(polygon, plane.id);
      }
    }
    if (list_.surfaces.size() == before) ++report_.dropped;
    return planar;
  }

  SurfaceList& list() { return list_; }

 private:
  bool same(PointId a, PointId b) const { return representative_[a] == representative_[b]; }

  /// The plane through the first two vertices and the first that is not collinear with them; none: all are collinear.
  PlaneTable::Interned plane_of_loop() {
    for (std::size_t k = 2; k < loop_.size(); ++k) {
      const PlaneTable::Interned plane = planes_.add_points(loop_[0], loop_[1], loop_[k]);
      third_ = k;
      if (plane.id != none) return plane;
    }
    return {};
  }

  void add_planar(PolygonId polygon, PlaneId plane) {
    const int axis = steepest_axis(planes_.approx(plane));
    const Sign slope = planes_.approx(plane).n[axis] > 0 ? 1 : -1;
    if (const Sign turn = convex_turn(axis)) {
      list_.add(polygon, {plane, turn != slope}, corners_);
      return;
    }
    const Decomposition cut = decompose(points_, loop_, axis);
    for (const ConvexPiece& piece : cut.pieces) list_.add(polygon, plane, piece.sides, slope < 0, piece.turn != slope);
    report_.nonconvex += cut.pieces.size() > 1 || (cut.self_crossing && !cut.pieces.empty());
    report_.self_crossing += cut.self_crossing && !cut.pieces.empty();
  }

  /// `first` is what plane_of_loop has found: mostly the plane of the first triangle.
  void add_triangles(PolygonId polygon, PlaneTable::Interned first) {
    ++report_.nonplanar;
    const Triangle known{loop_[0], loop_[1], loop_[third_]};
    for (const Triangle& t : triangulate(points_, loop_)) {
      const PlaneTable::Interned plane = t == known ? first : planes_.add_points(t[0], t[1], t[2]);
      if (plane.id != none) list_.add(polygon, plane, t);
    }
  }

  /// The direction in which a convex loop runs, seen along the axis, its corners in corners_; 0 if it is not convex, or
  /// runs back over itself. It is convex if every turn that it makes has the same sign, and it turns once round: the
  /// order of (u, v) changes its direction twice along it.
  Sign convex_turn(int axis) {
    const std::size_t n = loop_.size();
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto direction = [&](std::size_t i) {
      const PointId a = loop_[i], b = loop_[i + 1 == n ? 0 : i + 1];
      const Sign s = compare(points_, b, a, u);
      return s != 0 ? s : compare(points_, b, a, v);
    };
    corners_.clear();
    Sign turn = 0, last = direction(n - 1);
    int changes = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Sign here =
          orientation(points_, loop_[i == 0 ? n - 1 : i - 1], loop_[i], loop_[i + 1 == n ? 0 : i + 1], axis);
      const Sign next = direction(i);
      changes += next != last;
      if (here == 0) {
        if (next != last) return 0;  // it turns back
      } else {
        if (turn != 0 && here != turn) return 0;
        turn = here;
        corners_.push_back(loop_[i]);
      }
      last = next;
    }
    return changes == 2 ? turn : 0;
  }

  PlaneTable& planes_;
  const PointTable& points_;
  std::span<const PointId> representative_;
  SceneReport& report_;
  SurfaceList list_;
  std::vector<PointId> loop_;     // the polygon's vertices, none in the same place as its neighbour
  std::size_t third_ = 2;         // what plane_of_loop took beside the first two
  std::vector<PointId> corners_;  // of a convex loop, those amid a straight side left out
};

double displacement(const Grid& grid, const std::vector<glm::dvec3>& vertices) {
  double largest = 0;
  for (const glm::dvec3& v : vertices) {
    const GridPoint p = grid.point(v);
    const glm::dvec3 moved{grid.world(p.c[0], 0), grid.world(p.c[1], 1), grid.world(p.c[2], 2)};
    largest = std::max(largest, glm::distance(v, moved));
  }
  return largest;
}

}  // namespace

Scene make_scene(PolygonSoup soup, const SceneOptions& options) {
  validate(soup);
  Scene scene;
  scene.options_ = options;
  const Grid grid = options.snap.empty() ? Grid::covering(soup.vertices) : Grid::snapped(soup.vertices, options.snap);
  if (!options.snap.empty()) scene.report_.largest_displacement = displacement(grid, soup.vertices);
  const auto points = std::make_shared<const PointTable>(grid, soup.vertices);
  const auto planes = std::make_shared<PlaneTable>(*points);
  const std::vector<PointId> representative = lowest_equal(*points);
  const auto polygons = static_cast<PolygonId>(soup.first.size() - 1);

  PolygonCutter cutter(*planes, representative, soup, scene.report_);
  std::vector<Surface>& surfaces = cutter.list().surfaces;
  scene.first_surface_.reserve(polygons + std::size_t{1});
  scene.planar_.reserve(polygons);
  // By representative, the lowest vertex there of a polygon that has an area.
  std::vector<PointId> lowest_used(points->size(), none);
  for (PolygonId p = 0; p < polygons; ++p) {
    const auto corners = std::span(soup.corners).subspan(soup.first[p], soup.first[p + 1] - soup.first[p]);
    scene.first_surface_.push_back(static_cast<std::uint32_t>(surfaces.size()));
    scene.planar_.push_back(cutter.add(p, corners));
    if (surfaces.size() == scene.first_surface_.back()) continue;
    for (PointId v : corners) {
      PointId& lowest = lowest_used[representative[v]];
      lowest = std::min(lowest, v);  // `none` is the largest number
    }
  }
  scene.first_surface_.push_back(static_cast<std::uint32_t>(surfaces.size()));
  scene.surfaces_ = std::move(surfaces);
  scene.edges_ = std::move(cutter.list().edges);
  scene.report_.duplicates = count_duplicates(soup.first, soup.corners, representative);
  scene.lowest_twin_.resize(points->size());
  for (PointId v = 0; v < points->size(); ++v) {
    const PointId lowest = lowest_used[representative[v]];
    scene.lowest_twin_[v] = lowest == none ? v : lowest;
  }
  std::erase(lowest_used, none);
  scene.places_ = PlaceIndex(*points, lowest_used);
  scene.soup_ = std::make_shared<const PolygonSoup>(std::move(soup));
  scene.points_ = points;
  scene.planes_ = planes;
  return scene;
}

}  // namespace sightline
