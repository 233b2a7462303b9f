#include "scene/decompose.hpp"

#include "scene/loop_segments.hpp"

#include <algorithm>
#include <optional>

namespace sightline {
namespace {

/// A binary space partition of a frame around the loop, cut along lines of its edges until no edge is inside a cell:
/// every cell is then inside or outside as a whole.
class Partition {
 public:
  Partition(const PointTable& points, std::span<const PointId> loop, int axis)
      : view_(points, axis), base_(loop_segments(view_, loop)), lines_(base_.lines) {
    for (PointId p : loop) named_.push_back({view_.grid(p), p});
    std::sort(named_.begin(), named_.end());
  }

  Decomposition run() {
    Decomposition result;
    if (base_.segments.empty()) return result;
    std::vector<Cell> stack{whole()};
    int lowest = 0, highest = 0;
    while (!stack.empty()) {
      Cell cell = std::move(stack.back());
      stack.pop_back();
      if (const auto cut = best_cut(cell)) {
        Cell left, right;
        split(cell, *cut, left, right);
        stack.push_back(std::move(right));
        stack.push_back(std::move(left));
        continue;
      }
      const int turns = winding(cell);
      lowest = std::min(lowest, turns);
      highest = std::max(highest, turns);
      if (turns % 2 != 0) result.pieces.push_back({sides(cell), turns > 0 ? 1 : -1});
    }
    result.self_crossing = highest > 1 || lowest < -1 || (highest == 1 && lowest == -1);
    return result;
  }

 private:
  struct Corner {  // of a cell: a point, and the line of the side from it to the next corner
    std::uint32_t point, line;
  };
  struct Part {  // of an edge, within a cell; used: it lies on the border
    std::uint32_t line, p, q;
    bool used;
  };
  struct Cell {
    std::vector<Corner> corners;  // counter-clockwise
    std::vector<Part> parts;
  };
  using Named = std::pair<std::array<Integer, 2>, PointId>;

  std::uint32_t add(PlanePoint p) {
    points_.push_back(std::move(p));
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  /// The frame: one grid step around the loop, so that no side of an inner cell lies on it.
  Cell whole() {
    std::array<Integer, 2> low = named_.front().first, high = low;
    for (const Named& n : named_) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (n.first[k] < low[k]) low[k] = n.first[k];
        if (n.first[k] > high[k]) high[k] = n.first[k];
      }
    }
    for (std::size_t k = 0; k < 2; ++k) --low[k], ++high[k];
    const std::array<std::array<Integer, 2>, 4> frame{low, {high[0], low[1]}, high, {low[0], high[1]}};
    Cell cell;
    for (std::size_t k = 0; k < 4; ++k) {
      cell.corners.push_back({add(view_.point(frame[k])), static_cast<std::uint32_t>(lines_.size())});
      lines_.push_back(view_.line(frame[k], frame[(k + 1) % 4]));
    }
    for (const LoopSegment& s : base_.segments) {
      cell.parts.push_back({s.line, add(view_.point(s.p)), add(view_.point(s.q)), false});
      ends_.push_back({cell.parts.back().p, cell.parts.back().q});
    }
    return cell;
  }

  Sign side_of(std::uint32_t line, std::uint32_t point) const { return side(lines_[line], points_[point]); }

  /// The line of an edge in the cell that cuts few edges (the border's too: each cut through the inside adds a piece)
  /// and takes many along with it. Large cells try some only.
  std::optional<std::uint32_t> best_cut(const Cell& cell) const {
    constexpr std::size_t pairs = 4096, fewest = 4;
    const std::size_t n = cell.parts.size();
    const std::size_t tries = std::max(fewest, pairs / std::max<std::size_t>(n, 1));
    const auto open = static_cast<std::size_t>(
        std::count_if(cell.parts.begin(), cell.parts.end(), [](const Part& part) { return !part.used; }));
    const std::size_t stride = (open + tries - 1) / tries;
    std::optional<std::uint32_t> best;
    std::ptrdiff_t best_cost = 0;
    std::size_t index = 0;
    std::uint32_t last = none;
    for (const Part& part : cell.parts) {
      if (part.used || index++ % stride != 0 || part.line == last) continue;
      last = part.line;
      const std::ptrdiff_t cost = cost_of(cell, part.line);
      if (!best || cost < best_cost) {
        best = part.line;
        best_cost = cost;
      }
    }
    return best;
  }

  std::ptrdiff_t cost_of(const Cell& cell, std::uint32_t line) const {
    std::ptrdiff_t cost = 0;
    for (const Part& part : cell.parts) {
      if (part.line == line) {
        --cost;
      } else if (side_of(line, part.p) * side_of(line, part.q) < 0) {
        cost += 2;
      }
    }
    return cost;
  }

  void split(const Cell& cell, std::uint32_t line, Cell& left, Cell& right) {
    const std::size_t n = cell.corners.size();
    std::vector<Sign> signs(n);
    for (std::size_t k = 0; k < n; ++k) signs[k] = side_of(line, cell.corners[k].point);
    // A corner on the line is the last of one half, and the first of the other: the line is the side that follows it in
    // the half that the border leaves there. Going round counter-clockwise, it leaves the left half on the way to the
    // right one.
    for (std::size_t k = 0; k < n; ++k) {
      const Corner& c = cell.corners[k];
      const Sign next = signs[k + 1 == n ? 0 : k + 1];
      if (signs[k] > 0) left.corners.push_back(c);
      if (signs[k] < 0) right.corners.push_back(c);
      if (signs[k] == 0) {
        left.corners.push_back(next > 0 ? c : Corner{c.point, line});
        right.corners.push_back(next < 0 ? c : Corner{c.point, line});
      }
      if (signs[k] * next < 0) {
        const std::uint32_t crossing = add(view_.meet(lines_[c.line], lines_[line]));
        left.corners.push_back({crossing, next > 0 ? c.line : line});
        right.corners.push_back({crossing, next < 0 ? c.line : line});
      }
    }
    for (const Part& part : cell.parts) {
      const Sign p = part.line == line ? 0 : side_of(line, part.p), q = part.line == line ? 0 : side_of(line, part.q);
      if (p == 0 && q == 0) {
        left.parts.push_back({part.line, part.p, part.q, true});
        right.parts.push_back({part.line, part.p, part.q, true});
      } else if (p >= 0 && q >= 0) {
        left.parts.push_back(part);
      } else if (p <= 0 && q <= 0) {
        right.parts.push_back(part);
      } else {
        const std::uint32_t crossing = add(view_.meet(lines_[part.line], lines_[line]));
        (p > 0 ? left : right).parts.push_back({part.line, part.p, crossing, part.used});
        (q > 0 ? left : right).parts.push_back({part.line, crossing, part.q, part.used});
      }
    }
  }

  /// How often the loop runs around the cell: the signed passages over a ray from its inside towards +x.
  int winding(const Cell& cell) {
    const auto corner = [&](std::size_t k) -> const PlanePoint& { return points_[cell.corners[k].point]; };
    PlanePoint inside{(corner(0).x + corner(1).x + corner(2).x) / 3, (corner(0).y + corner(1).y + corner(2).y) / 3, 0,
                      0};
    inside.near_x = (corner(0).near_x + corner(1).near_x + corner(2).near_x) / 3;
    inside.near_y = (corner(0).near_y + corner(1).near_y + corner(2).near_y) / 3;
    const auto above = [&](const PlanePoint& p) {  // both are within 2^-51 (three roundings of a sum up to 3)
      const double difference = p.near_y - inside.near_y;
      return difference > 0x1p-49 || (difference > -0x1p-49 && p.y > inside.y);
    };
    int turns = 0;
    for (std::size_t i = 0; i < base_.segments.size(); ++i) {
      const LoopSegment& s = base_.segments[i];
      const bool p = above(points_[ends_[i].first]), q = above(points_[ends_[i].second]);
      if (p == q) continue;
      if (side(lines_[s.line], inside) == (q ? 1 : -1)) turns += q ? s.net : -s.net;
    }
    return turns;
  }

  std::vector<PieceSide> sides(const Cell& cell) const {
    std::vector<PieceSide> result;
    const std::size_t n = cell.corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Corner &from = cell.corners[k], &to = cell.corners[k + 1 == n ? 0 : k + 1];
      const PointId corner = scene_point(points_[to.point]);
      const auto [a, b] = carrier(from, to, corner);
      result.push_back({a, b, corner});
    }
    return result;
  }

  /// The ends of an edge that lies on the cell's side, in its direction; where only the line of an edge does, the
  /// side's own ends if they are scene points, else the ends of any edge on that line.
  std::pair<PointId, PointId> carrier(const Corner& from, const Corner& to, PointId end) const {
    const PlanePoint &a = points_[from.point], &b = points_[to.point];
    const bool along = before(a, b);
    const PlanePoint &low = along ? a : b, &high = along ? b : a;
    const auto first = std::lower_bound(base_.segments.begin(), base_.segments.end(), from.line,
                                        [](const LoopSegment& s, std::uint32_t line) { return s.line < line; });
    auto found = base_.segments.end();
    for (auto s = first; s != base_.segments.end() && s->line == from.line && found == base_.segments.end(); ++s) {
      const auto& [p, q] = ends_[static_cast<std::size_t>(s - base_.segments.begin())];
      if (before(points_[p], high) && before(low, points_[q])) found = s;
    }
    if (found == base_.segments.end()) {
      const PointId begin = scene_point(a);
      if (begin != none && end != none) return {begin, end};
      found = first;
    }
    return along ? std::pair(found->p, found->q) : std::pair(found->q, found->p);
  }

  static bool before(const PlanePoint& a, const PlanePoint& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

  /// The loop's vertex in this place (the lowest index), or none.
  PointId scene_point(const PlanePoint& p) const {
    if (p.x.get_den() != 1 || p.y.get_den() != 1) return none;
    const Named wanted{{p.x.get_num(), p.y.get_num()}, 0};
    const auto found = std::lower_bound(named_.begin(), named_.end(), wanted);
    return found != named_.end() && found->first == wanted.first ? found->second : none;
  }

  PlaneView view_;
  LoopSegments base_;
  std::vector<PlaneLine> lines_;  // base_.lines, then the frame
  std::vector<PlanePoint> points_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  // of base_.segments, in points_
  std::vector<Named> named_;
};

}  // namespace

Decomposition decompose(const PointTable& points, std::span<const PointId> loop, int axis) {
  return Partition(points, loop, axis).run();
}

}  // namespace sightline
