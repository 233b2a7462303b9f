// What the stages of stitching share: buffers that a sequence of maps reuses. Internal to visibility_map/.
//
// Stages, in order: arrange (fragments -> elementary intervals, faces), kinds (intervals -> parts with kind and owner),
// naming (parts -> edges with names), stitch (vertices, order, loops, areas).
#pragma once

#include "exact/window.hpp"
#include "visibility_map/fragment.hpp"
#include "visibility_map/map.hpp"
#include "visibility_map/stitch.hpp"
#include "visibility_map/stitch_twofold.hpp"

#include <stdexcept>

namespace sightline::stitching {

/// A corner of fragments, or one that a stage adds.
struct Corner : FragmentCorner {
  /// The ray up to a positive factor; largest component between 2^-10 and 2, each within 9 * 2^-53 (see arrange).
  glm::dvec3 approx;
  /// u such that the ray is N_line x n_u. `line` is one of the two.
  SightlineRef across(SightlineId line) const {
    return line == low ? SightlineRef{high, sign} : SightlineRef{low, -sign};
  }
};
using CornerId = std::uint32_t;

/// Disjoint sets of 0..n-1.
struct Sets {
  std::vector<std::uint32_t> parent;
  void reset(std::size_t n);
  std::uint32_t add();
  std::uint32_t find(std::uint32_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  }
  /// The lower root stays.
  void unite(std::uint32_t a, std::uint32_t b);
};

/// The positive direction of a line has the line's front (N.r > 0) on its left, seen from the eye. `from` and `to` are
/// corners that have the line in their names; `left` and `right` are fragments, `none` outside the window.
struct Interval {
  SightlineId line;
  CornerId from, to;
  std::uint32_t left, right;
};

/// A name of a line as one number: window sides below edges (lowest pair first) below plane pairs. A plane pair is an
/// index into State::plane_names.
using NameKey = std::uint64_t;
inline constexpr NameKey plane_key = NameKey{1} << 63;
inline constexpr NameKey no_name = ~NameKey{0};
inline constexpr NameKey edge_key(PointId a, PointId b) {
  return 4 + ((NameKey{a < b ? a : b} << 31) | NameKey{a < b ? b : a});
}

/// Consecutive intervals with one pair of planes beside them and one kind.
struct Part {
  SightlineId line;
  CornerId from, to;
  std::uint32_t left, right;
  EdgeKind kind;
  PolygonId owner;
  NameKey name;
};
/// A maximal edge of the map: parts first .. last.
struct Edge {
  std::uint32_t first, last;
  NameKey name;
};
/// The second line of a vertex between two edges of one line.
struct Mark {
  std::uint32_t root;  // of the corner
  SightlineId line;
  NameKey name;
};

/// A scene edge a-b on a line, where it meets the run looked at in positive length. Ends that lie strictly inside the
/// run are named; `none`: the run's own end is reached.
struct Carrier {
  PointId a, b;
  PointId start, end;
  bool covers() const { return start == none && end == none; }
};

/// A vertex of the map before it has its place in the order.
struct VertexDraft {
  std::uint32_t root;
  CornerId corner;  // one of its corners; on the border of the window one that has a side of it in its name
  glm::dvec2 st;
  glm::dvec3 direction;
};

/// A line's products with the camera's forward, right and up; see stitch_place.cpp.
struct WindowLine {
  Twofold forward, right, up;
};
struct LoopDraft {
  std::uint32_t start;  // half-edge
  std::uint32_t face;
  Twofold area{};    // twice, in (s,t)
  double angle = 0;  // solid angle, on the sphere up to multiples of 4 pi
};

struct State {
  // What is stitched.
  const Scene* scene = nullptr;
  SightlineTable* table = nullptr;
  const Fragments* fragments = nullptr;
  const Camera* camera = nullptr;  // null: the sphere
  const Window* window = nullptr;
  Sign handedness = 1;
  SightlineRef border[4];
  glm::dvec3 eye{};     // unit coordinates, each within 2^-52 * scale
  double scale = 1;     // max(1, largest unit coordinate of the eye)
  glm::dvec3 ahead{};   // within a right angle of every ray of the window; zero for the sphere
  glm::dvec3 frame[3];  // forward, right and up, times one power of two: largest component in [1/2, 1)
  std::array<std::array<Integer, 3>, 3> exact_frame;  // the same as integers, once they are needed
  bool has_exact_frame = false;
  double place_error[3];  // of the products that depth, s and t are made of

  // Fragments.
  std::vector<PolygonId> polygon_of;  // what a fragment shows; none: nothing
  std::vector<PlaneId> plane_of;
  Sets faces;  // fragments of one face

  // Corners and lines.
  std::vector<Corner> corners;
  Sets rays;  // corners that are the same ray
  struct Side {
    std::uint32_t fragment;
    CornerId from, to;
    bool left;
  };
  struct Spot {
    double key;
    CornerId corner;
  };
  std::vector<std::uint32_t> line_start;
  std::vector<Side> sides;
  std::vector<std::uint32_t> stamp, rank;  // per corner: the line last seen on, the place there
  std::vector<Spot> spots;
  std::vector<std::uint32_t> left, right;
  std::vector<Interval> intervals;
  std::vector<std::uint32_t> degree;  // per root

  // Kinds and names.
  std::vector<Part> parts;
  std::vector<Edge> edges;
  std::vector<Mark> marks;
  std::vector<MapLine> plane_names;
  std::vector<Carrier> carriers, other_carriers;
  struct Stop {  // an end of a carrier within a run
    PointId point;
    CornerId corner;
  };
  std::vector<Stop> stops;
  std::vector<std::pair<NameKey, std::uint32_t>> names;  // with its user: edges, then marks
  std::vector<std::uint32_t> line_of_user;

  // The map's own graph. Half-edge 2e runs along edge e, 2e+1 against it.
  std::vector<std::uint32_t> vertex_of;  // per root: place in the map
  std::vector<VertexDraft> vertices, placed;
  std::vector<std::uint32_t> window_line_of;  // per sightline: in window_lines, or none
  std::vector<WindowLine> window_lines;
  std::vector<std::pair<double, std::uint32_t>> vertex_order;
  std::vector<std::uint32_t> rank_of;  // per draft: place in the map
  struct Ends {
    std::uint32_t from, to;
  };
  std::vector<Ends> edge_ends;  // in `vertices`
  struct Half {
    SightlineRef line;    // oriented: the left of the half-edge, as seen from the eye, is its front
    CornerId tail, head;  // corners with this line in their names
    std::uint32_t left;   // fragments on the left in (s,t), beside its tail and its head; none outside
    std::uint32_t left_at_head;
  };
  std::vector<Half> halves;
  struct Place {  // of an edge: the lower vertex it is sorted under is told by where it stands
    std::uint32_t higher, line, edge;
    bool up;  // runs from the lower vertex to the higher
  };
  std::vector<Place> edge_places;
  std::vector<std::uint32_t> place_start;  // per vertex, and the end
  std::vector<SightlineId> vertex_line;    // per vertex: the sightline of its line[0]
  struct Leaving {                         // a vertex: in the direction (s,t), 0 on the sphere
    double s, t;
    std::uint32_t half_edge;
    int half;  // of the turn from the first
  };
  std::vector<Leaving> leaving;
  std::vector<std::uint32_t> out_start, outgoing, next;
  std::vector<std::uint32_t> face_of;  // per root of `faces`
  std::vector<char> traced;
  std::vector<LoopDraft> loops, face_loops;
  struct Measure {
    Twofold area;  // twice
    double angle;
  };
  std::vector<Measure> edge_measure;
  std::vector<double> along_apex;  // per vertex: the product of its direction with the apex
  std::vector<std::pair<std::uint32_t, PolygonId>> coincident;
  std::vector<std::pair<PolygonId, Twofold>> polygon_sums;  // twice the areas of fragments
};

// The stages.
void arrange(State& s);                     // corners, intervals, faces, degree
void find_kinds(State& s);                  // parts
void join_parts(State& s);                  // edges, marks
void number(State& s, VisibilityMap& map);  // lines, vertices, edges in canonical order; halves
void trace_loops(State& s, VisibilityMap& map);
void measure(State& s, VisibilityMap& map);
void name_scene_vertices(State& s, VisibilityMap& map);

/// All there is to do for areas alone: corners, their places, and sums by polygon.
void sum_areas(State& s, std::vector<PolygonArea>& areas);

/// Does the loop of this half-edge run clockwise in (s,t)? Exactly.
bool runs_clockwise(State& s, const VisibilityMap& map, std::uint32_t start);

/// Prepares place_vertices for the camera.
void set_frame(State& s);
/// Where the vertices are seen: (s,t), each the nearest double, or on the sphere the unit direction, rounded from exact
/// numbers: either depends on the ray alone.
void place_vertices(State& s);
/// Exact lexicographic order of rays: by (s,t), on the sphere by direction scaled to a primitive integer vector.
Sign compare_places(State& s, CornerId a, CornerId b);

/// The fragments' corners, and which of them are known to be one ray.
void take_corners(State& s);
/// The corner of two different lines that is the ray N_line x n_u.
CornerId add_corner(State& s, SightlineId line, SightlineRef u);
/// Sign of the turn at the tail that g and h share: +1 if h leaves it counter-clockwise of g by less than half a turn,
/// as seen from the eye, 0 if they leave in opposite directions.
Sign turn(State& s, const State::Half& g, const State::Half& h);

/// A stretch of a line between two corners that have it in their names.
struct Stretch {
  SightlineId line;
  CornerId from, to;
};
/// A polygon and the plane of that piece of it which is seen.
struct Shown {
  PolygonId polygon = none;
  PlaneId plane = none;
};
/// Would the stretch, continued to another corner of its line, go half way round the sphere or more?
bool half_turn(State& s, const Stretch& stretch, CornerId to);
/// Appends to `out` the edges of the polygon, which is seen beside the stretch, that lie on the line and in the plane,
/// as far as they meet the stretch in positive length: edges of the file, or, with `diagonals`, edges of its pieces in
/// that plane.
void find_carriers(State& s, const Stretch& stretch, const Shown& shown, bool diagonals, std::vector<Carrier>& out);
/// Does the line of the points a and b, which are not one, have this id?
bool on_line(State& s, SightlineId line, PointId a, PointId b);
/// The edges of a polygon that may lie on a line, as far as doubles tell: how many, and one of them, a < b.
struct NearEdges {
  std::uint32_t count;
  PointId a, b;
};
NearEdges near_edges(const State& s, SightlineId line, PolygonId polygon);
/// The side of a point of the scene against the plane of what is shown: corners of the pieces in it lie in it.
Sign side_of(const State& s, PointId p, const Shown& shown);
/// The name that FORMATS wants among carriers: the lowest that covers the stretch, else the lowest; no_name if none.
NameKey best_name(const std::vector<Carrier>& carriers);
/// The name of the line of two planes, each given by a polygon that lies in it.
NameKey planes_name(State& s, Shown a, Shown b);
bool plane_name_less(const State& s, NameKey a, NameKey b);
inline bool name_less(const State& s, NameKey a, NameKey b) {
  return (a & b & plane_key) == 0 ? a < b : plane_name_less(s, a, b);
}
/// A second line for the vertex between the collinear parts a and b, where a ends and b begins.
Mark find_mark(State& s, const Part& a, const Part& b);

}  // namespace sightline::stitching
