// Which polygons are seen, how much of them, and whether wholly.
//
// Let V be the closed union of the faces of polygon P, and C the open projection, inside the window, of one of its
// convex pieces. P is *full* iff every C lies in V.
//   The boundary of V consists of edges of P's faces: a map's edge never has the same polygon on both sides. If none of
//   them meets C, then C, being connected, lies in the interior of V or outside of V, and any one point of C tells
//   which. If one of them meets C then C does not lie in V, because every neighbourhood of an inner point of that edge
//   reaches beyond V, and some of these are within C.
// So it is enough to test P's own edges against C, and to locate one inner point of C. Both are decided exactly, and
// pieces that overlap in the projection (a folded polygon) or do not hang together (a self-crossing one, one cut by
// the window) need no special care.
#include "visibility_map/locate.hpp"
#include "visibility_map/locate_exact.hpp"
#include "visibility_map/query.hpp"
#include "visibility_map/visible_view.hpp"
#include "visibility_map/write.hpp"
#include "visibility_map/write_text.hpp"

#include <algorithm>
#include <optional>

namespace sightline {

namespace {

class Visibility {
 public:
  Visibility(const VisibilityMap& map, const Scene& scene)
      : map_(map),
        scene_(scene),
        exact_(map, scene),
        table_(scene.planes()),
        window_(map.camera.forward, map.camera.right, map.camera.up),
        clipper_(table_, window_),
        adjacency_(map),
        lines_(map.lines.size()) {
    table_.reset(scene.planes(), scene.grid().point(map.camera.eye));
  }

  std::vector<PolygonVisibility> all() {
    std::vector<PolygonVisibility> result;
    for (const PolygonId polygon : adjacency_.polygons()) {
      const std::vector<ConvexView> views = projections(polygon);
      PolygonVisibility v{polygon, full(polygon, views), 0, 1};
      for (const std::uint32_t face : adjacency_.faces_of(polygon)) v.area += map_.faces[face].area;
      if (!v.full) {
        const double whole = scene_.planar(polygon) ? sum_of_areas(views) : area_of_union(views);
        v.fraction = v.area < whole ? v.area / whole : 1;
      }
      result.push_back(v);
    }
    return result;
  }

 private:
  /// The projections of a polygon's pieces inside the window.
  std::vector<ConvexView> projections(PolygonId polygon) {
    std::vector<ConvexView> views;
    for (const Surface& surface : scene_.surfaces(polygon)) {
      const Sign eye = table_.eye_side(surface.plane);
      if (eye == 0 || (scene_.options().one_sided && (eye > 0) == surface.flipped)) continue;
      ConvexView view = clipper_.whole();
      for (const SurfaceEdge& edge : scene_.edges(surface)) {
        // Seen from the front, edges run counter-clockwise, and (a - eye) x (b - eye) points outwards.
        const SightlineRef line = table_.of_points(edge.a, edge.b);
        view = clipper_.clip(view, eye > 0 ? -line : line);
        if (view.empty()) break;
      }
      if (!view.empty()) views.push_back(std::move(view));
    }
    return views;
  }

  bool full(PolygonId polygon, const std::vector<ConvexView>& views) {
    for (const ConvexView& view : views) {
      const std::vector<glm::dvec2> corners = clipper_.corners(view);
      for (const std::uint32_t e : adjacency_.edges_of(polygon)) {
        if (meets(map_.edges[e], view, corners)) return false;
      }
      const MapPlace place = inner_place(view, corners);
      if (place.kind != MapPlace::face || map_.faces[place.index].polygon != polygon) return false;
    }
    return true;
  }

  /// Does an edge meet the interior of a view? Two convex figures of the plane are apart iff a line along a side of
  /// one of them separates them.
  bool meets(const MapEdge& edge, const ConvexView& view, const std::vector<glm::dvec2>& corners) {
    const glm::dvec2 a = map_.vertices[edge.vertex[0]].st, b = map_.vertices[edge.vertex[1]].st;
    for (int k = 0; k < 2; ++k) {
      // Rounding to nearest keeps order: what differs when rounded differs the same way.
      const auto [low, high] = std::minmax_element(corners.begin(), corners.end(),
                                                   [k](const auto& p, const auto& q) { return p[k] < q[k]; });
      if (std::max(a[k], b[k]) < (*low)[k] || std::min(a[k], b[k]) > (*high)[k]) return false;
    }
    for (const SightlineRef side : view.sides) {
      if (vertex_side(edge.vertex[0], side) <= 0 && vertex_side(edge.vertex[1], side) <= 0) return false;
    }
    bool left = false, right = false;
    for (std::size_t i = 0; i < view.sides.size() && !(left && right); ++i) {
      const Sign side = clipper_.corner_side(view, i, line(edge.line));
      left = left || side > 0;
      right = right || side < 0;
    }
    return left && right;
  }

  Sign vertex_side(std::uint32_t v, SightlineRef k) {
    const SightlineRef a = line(map_.vertices[v].line[0]), b = line(map_.vertices[v].line[1]);
    return table_.order(b, a, k) * window_.forwardness(table_, a, b);
  }

  SightlineRef line(std::uint32_t l) {
    if (!lines_[l]) {
      const MapLine& named = map_.lines[l];
      lines_[l] = named.kind == MapLine::window ? window_.side(table_, static_cast<Window::Side>(named.v[0]))
                                                : table_.of_normal(exact_.normal(named));
    }
    return *lines_[l];
  }

  /// Where some inner point of a view lies.
  MapPlace inner_place(const ConvexView& view, const std::vector<glm::dvec2>& corners) {
    if (!locator_) locator_.emplace(map_, scene_);
    // The middle of three corners far apart is taken if it is clearly inside: corners are off by 2^-54, so that a turn,
    // two products of differences up to 1, is off by less than 2^-49.
    const std::size_t n = corners.size();
    const glm::dvec2 middle = (corners[0] + corners[n / 3] + corners[2 * n / 3]) / 3.0;
    int sign = 0;
    bool clear = true;
    for (std::size_t i = 0; i < n && clear; ++i) {
      const glm::dvec2 a = corners[i], d = corners[(i + 1) % n] - a, m = middle - a;
      const double turn = d.x * m.y - d.y * m.x;
      const int here = turn > 0x1p-48 ? 1 : turn < -0x1p-48 ? -1 : 0;
      clear = here != 0 && (sign == 0 || here == sign);
      sign = here;
    }
    if (clear) return locator_->at(middle);

    WindowPoint sum{0, 0, 0};  // of points with positive weights: inside, since three corners are not on one line
    for (const std::size_t i : {std::size_t{0}, n / 3, 2 * n / 3}) {
      const WindowPoint corner = ExactWindow::meet(exact_.line(table_.normal(view.sides[i].id)),
                                                   exact_.line(table_.normal(view.sides[(i + 1) % n].id)));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += corner[k];
    }
    return locator_->at_exact(sum);
  }

  double sum_of_areas(const std::vector<ConvexView>& views) const {
    double sum = 0;
    for (const ConvexView& view : views) sum += clipper_.area(view);
    return sum;
  }

  double area_of_union(const std::vector<ConvexView>& views) const {
    double sum = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
      std::vector<ConvexView> rest{views[i]};
      for (std::size_t k = 0; k < i; ++k) {
        std::vector<ConvexView> next;
        for (ConvexView& part : rest) {
          for (ConvexView& left : clipper_.subtract(std::move(part), views[k])) next.push_back(std::move(left));
        }
        rest = std::move(next);
      }
      sum += sum_of_areas(rest);
    }
    return sum;
  }

  const VisibilityMap& map_;
  const Scene& scene_;
  ExactWindow exact_;
  SightlineTable table_;
  Window window_;
  ViewClipper clipper_;
  MapAdjacency adjacency_;
  std::vector<std::optional<SightlineRef>> lines_;
  std::optional<Locator> locator_;
};

}  // namespace

std::vector<PolygonVisibility> visible_polygons(const VisibilityMap& map, const Scene& scene) {
  return Visibility(map, scene).all();
}

std::string map_csv(const VisibilityMap& map, const Scene& scene, std::size_t camera) {
  std::string out;
  for (const PolygonVisibility& v : visible_polygons(map, scene)) {
    text::append(out, camera);
    out += ',';
    text::append(out, v.polygon);
    out += v.full ? ",full," : ",partial,";
    text::append(out, v.area);
    out += ',';
    text::append(out, v.fraction);
    out += '\n';
  }
  return out;
}

}  // namespace sightline
