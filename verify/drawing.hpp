// A map file made exact: its lines and vertices in the window of its camera, and the checks that show it to be a
// planar subdivision of the window.
#pragma once

#include "verify/edge_tree.hpp"
#include "verify/map_file.hpp"
#include "verify/window.hpp"

namespace sightline::verify {

class Drawing {
 public:
  Drawing(const View& view, const MapFile& file) : view_(view), file_(file) {}

  /// The checks "lines", "vertices", "edges", "crossings", "loops", "border" and "holes", as far as each rests on
  /// sound ones before it. True where the map is a subdivision of the window into the faces that it names, connected
  /// and with the loops that the contract asks for: everything below may be used then.
  bool check(Report& report);

  const View& view() const { return view_; }
  const MapFile& file() const { return file_; }
  const Line& line(std::uint32_t i) const { return lines_[i]; }
  const Point& vertex(std::uint32_t i) const { return vertices_[i]; }
  const EdgeTree& tree() const { return tree_; }
  EdgeTree& tree() { return tree_; }
  const Point& start(std::uint32_t edge) const { return vertices_[file_.edges[edge].vertices[0]]; }
  const Point& end(std::uint32_t edge) const { return vertices_[file_.edges[edge].vertices[1]]; }
  /// Its line's positive side is its left side: 1; the right one: -1.
  int left_sign(std::uint32_t edge) const { return left_sign_[edge]; }
  /// Edges at a vertex in the order of their directions, counter-clockwise: entries as in loops, leading away.
  std::span<const std::int32_t> around(std::uint32_t vertex) const {
    return std::span(around_).subspan(first_around_[vertex], first_around_[vertex + 1] - first_around_[vertex]);
  }
  std::uint32_t from(std::int32_t entry) const { return file_.edges[edge_of(entry)].vertices[entry >= 0 ? 0 : 1]; }
  std::uint32_t to(std::int32_t entry) const { return file_.edges[edge_of(entry)].vertices[entry >= 0 ? 1 : 0]; }
  /// The face on the left of an entry.
  std::uint32_t face(std::int32_t entry) const {
    const MapEdge& e = file_.edges[edge_of(entry)];
    return entry >= 0 ? e.left : e.right;
  }

  /// Sign of a line of the file at a vertex; by its name where it can be.
  int side_at(std::uint32_t line, std::uint32_t vertex) const {
    const auto& own = file_.vertices[vertex].lines;
    if (own[0] == line || own[1] == line) return 0;
    return side(lines_[line], vertices_[vertex]);
  }
  /// Calls f(edge) for each edge that passes below a point (an edge's left end belongs to it, its right end not).
  template <class F>
  void below(const Point& p, F&& f) const {
    const Box upright{p.s - 0x1p-48, -1, p.s + 0x1p-48, p.t + 0x1p-48};
    tree_.visit([&](const Box& b, double) { return b.meets(upright); },
                [&](std::uint32_t e) {
                  if (tree_.box(e).meets(upright) && passes_below(e, p)) f(e);
                  return true;
                });
  }
  /// The face that holds a point which lies on no edge.
  std::uint32_t locate(const Point& p) const;
  /// Does the open face hold the point? The point lies on no edge of the face.
  bool holds(std::uint32_t face, const Point& p) const;

 private:
  bool make_lines(Report& report);
  bool make_vertices(Report& report);
  bool make_edges(Report& report);
  bool check_crossings(Report& report);
  void sort_around();
  bool check_loops(Report& report);
  bool check_border(Report& report);
  bool check_holes(Report& report);
  bool passes_below(std::uint32_t edge, const Point& p) const;
  bool directed_before(std::int32_t a, std::int32_t b) const;
  int rising(std::int32_t entry) const;

  const View& view_;
  const MapFile& file_;
  std::vector<Line> lines_;
  std::vector<Point> vertices_;
  std::vector<signed char> left_sign_;
  std::vector<signed char> rightwards_;  // 1: the end has the larger s; 0: they are equal; -1
  std::vector<std::uint32_t> first_around_;
  std::vector<std::int32_t> around_;
  EdgeTree tree_;
};

/// Sign of a loop's area, counter-clockwise 1; exact.
int loop_orientation(const Drawing& drawing, std::span<const std::int32_t> loop);

}  // namespace sightline::verify
