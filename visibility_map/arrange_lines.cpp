// Fragments -> elementary intervals: along every line the corners are sorted exactly, the fragments on its two sides
// are laid over each other, and intervals with the same polygon on both sides dissolve.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {

namespace {

/// Is corner b strictly after a in the line's positive direction? (N x u_b) comes after (N x u_a), by less than half a
/// turn, when det(N, u_b, u_a) > 0, because (N x u_b) x (N x u_a) = N det(N, u_b, u_a).
Sign after(State& s, SightlineId line, CornerId a, CornerId b) {
  if (s.rays.find(a) == s.rays.find(b)) return 0;
  return s.table->order({line, 1}, s.corners[b].across(line), s.corners[a].across(line));
}

/// A coordinate along a line: monotone in the angle of a ray r of the line's plane, from -2 to 2 going once round,
/// starting opposite to e.
struct Ruler {
  glm::dvec3 e, f;
  double error = 0;  // of any key measured so far
  Ruler(const State& s, SightlineId line) {
    const glm::dvec3& n = s.table->approx(line);
    e = s.ahead;
    if (!s.camera) {
      e = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? glm::dvec3(0, -n.z, n.y)
          : std::abs(n.y) <= std::abs(n.z)                                 ? glm::dvec3(n.z, 0, -n.x)
                                                                           : glm::dvec3(-n.y, n.x, 0);
    }
    f = glm::cross(e, n);
    // The map r -> (r.e, r.f) keeps the order round the circle unless e is (nearly) perpendicular to the plane.
    if (std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)}) < 0x1p-20) error = HUGE_VAL;
  }
  /// |e| <= 1 and |f| <= 2 by component, those of r <= 2 and within 9u, u = 2^-53: r.e and r.f are within 27u and 54u
  /// (of r) + 16u and 32u (rounding) < 128u =: E. A key k = y / (|x| + |y|) changes by at most 2 E / (|x| + |y|) when x
  /// and y do by E < (|x| + |y|) / 4; its own rounding and that of the shift by 2 are below 8u.
  double measure(const glm::dvec3& r) {
    const double x = glm::dot(r, e), y = glm::dot(r, f), size = std::abs(x) + std::abs(y);
    error = std::max(error, size > 0x1p-40 ? 0x1p-45 / size + 0x1p-50 : HUGE_VAL);
    if (size == 0) return 0;
    const double k = y / size;
    return x >= 0 ? k : std::copysign(2.0, y) - k;
  }
};

/// On the sphere a line is a circle: it is opened at its widest gap. Keys stay ascending.
void open_circle(State& s) {
  auto& spots = s.spots;
  std::size_t first = 0;
  double widest = 4 - (spots.back().key - spots.front().key);
  for (std::size_t k = 1; k < spots.size(); ++k) {
    const double gap = spots[k].key - spots[k - 1].key;
    if (gap > widest) {
      widest = gap;
      first = k;
    }
  }
  for (std::size_t k = 0; k < first; ++k) spots[k].key += 4;
  std::rotate(spots.begin(), spots.begin() + static_cast<std::ptrdiff_t>(first), spots.end());
}

/// Sorts s.spots along the line; equal rays become one set and one rank. Returns the number of ranks, and leaves in
/// s.spots one corner per rank.
std::uint32_t sort_spots(State& s, SightlineId line, Ruler& ruler) {
  auto& spots = s.spots;
  for (auto& spot : spots) spot.key = ruler.measure(s.corners[spot.corner].approx);
  const auto lower = [](const State::Spot& a, const State::Spot& b) { return a.key < b.key; };
  if (spots.size() > 24) {
    std::sort(spots.begin(), spots.end(), lower);
  } else {
    for (std::size_t k = 1; k < spots.size(); ++k) {
      const State::Spot spot = spots[k];
      std::size_t j = k;
      for (; j > 0 && lower(spot, spots[j - 1]); --j) spots[j] = spots[j - 1];
      spots[j] = spot;
    }
  }
  if (!s.camera) open_circle(s);
  // Clusters whose order the keys leave open are sorted exactly.
  const double doubt = 2 * ruler.error;
  std::uint32_t ranks = 0;
  for (std::size_t first = 0; first < spots.size();) {
    std::size_t end = first + 1;
    while (end < spots.size() && spots[end].key - spots[end - 1].key <= doubt) ++end;
    for (std::size_t k = first + 1; k < end; ++k) {
      const State::Spot spot = spots[k];
      std::size_t j = k;
      while (j > first) {
        const Sign sign = after(s, line, spots[j - 1].corner, spot.corner);
        if (sign == 0) s.rays.unite(spots[j - 1].corner, spot.corner);
        if (sign >= 0) break;
        spots[j] = spots[j - 1];
        --j;
      }
      spots[j] = spot;
    }
    for (std::size_t k = first; k < end; ++k) {
      const bool again = k > first && s.rays.find(spots[k - 1].corner) == s.rays.find(spots[k].corner);
      if (!again) ++ranks;
      s.rank[spots[k].corner] = ranks - 1;
    }
    first = end;
  }
  std::uint32_t kept = 0;
  for (const State::Spot& spot : spots) {
    if (s.rank[spot.corner] == kept) spots[kept++] = spot;
  }
  return ranks;
}

void keep_or_dissolve(State& s, SightlineId line, CornerId from, CornerId to, std::uint32_t left, std::uint32_t right) {
  if (left == none && right == none) return;
  if (left != none && right != none) {
    if (s.polygon_of[left] == s.polygon_of[right]) {
      s.faces.unite(left, right);
      return;
    }
  } else if (!s.camera ||
             (line != s.border[0].id && line != s.border[1].id && line != s.border[2].id && line != s.border[3].id)) {
    throw std::logic_error("stitch: the fragments leave a gap");
  }
  s.intervals.push_back({line, from, to, left, right});
}

void cover(std::vector<std::uint32_t>& cells, std::uint32_t k, std::uint32_t fragment) {
  if (cells[k] != none) throw std::logic_error("stitch: the fragments overlap");
  cells[k] = fragment;
}

void lay_over(State& s, SightlineId line, std::span<const State::Side> sides) {
  s.spots.clear();
  for (const State::Side& side : sides) {
    for (const CornerId c : {side.from, side.to}) {
      if (s.stamp[c] == line) continue;
      s.stamp[c] = line;
      s.spots.push_back({0, c});
    }
  }
  if (s.spots.size() == 2 && sides.size() == 2 && sides[0].from == sides[1].from && sides[0].left != sides[1].left) {
    const bool first = sides[0].left;
    keep_or_dissolve(s, line, sides[0].from, sides[0].to, sides[first ? 0 : 1].fragment, sides[first ? 1 : 0].fragment);
    return;
  }
  Ruler ruler(s, line);
  const std::uint32_t ranks = sort_spots(s, line, ruler);
  s.left.assign(ranks, none);
  s.right.assign(ranks, none);
  for (const State::Side& side : sides) {
    auto& cells = side.left ? s.left : s.right;
    for (std::uint32_t k = s.rank[side.from], end = s.rank[side.to]; k != end; k = k + 1 == ranks ? 0 : k + 1) {
      cover(cells, k, side.fragment);
    }
  }
  for (std::uint32_t k = 0; k < ranks; ++k) {
    keep_or_dissolve(s, line, s.spots[k].corner, s.spots[k + 1 == ranks ? 0 : k + 1].corner, s.left[k], s.right[k]);
  }
}

/// Sides by line, each in its line's positive direction.
void sort_sides(State& s) {
  const Fragments& f = *s.fragments;
  s.line_start.assign(s.table->size() + 1, 0);
  const auto sides_of = [&](const Fragment& fragment) {
    return std::span(f.sides).subspan(fragment.first_side, fragment.side_count);
  };
  for (const Fragment& fragment : f.fragments) {
    if (fragment.side_count < 3) throw std::logic_error("stitch: a fragment with fewer than 3 sides");
    for (const FragmentSide& side : sides_of(fragment)) ++s.line_start[side.line.id];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& start : s.line_start) {
    sum += start;
    start = sum;
  }
  s.sides.resize(sum);
  for (std::uint32_t k = 0; k < f.fragments.size(); ++k) {
    for (const FragmentSide& side : sides_of(f.fragments[k])) {
      const bool left = side.line.sign > 0;
      s.sides[--s.line_start[side.line.id]] = {k, left ? side.from : side.to, left ? side.to : side.from, left};
    }
  }
}

/// On the sphere the intervals of a line go round: each line's list is made to begin where no edge goes on.
void begin_at_breaks(State& s) {
  for (std::size_t first = 0, end; first < s.intervals.size(); first = end) {
    end = first + 1;
    while (end < s.intervals.size() && s.intervals[end].line == s.intervals[first].line) ++end;
    for (std::size_t k = first; k < end; ++k) {
      const std::uint32_t root = s.rays.find(s.intervals[k].from);
      const Interval& before = s.intervals[k == first ? end - 1 : k - 1];
      if (s.degree[root] == 2 && s.rays.find(before.to) == root) continue;
      const auto begin = s.intervals.begin();
      std::rotate(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(k),
                  begin + static_cast<std::ptrdiff_t>(end));
      break;
    }
  }
}

}  // namespace

void arrange(State& s) {
  const Fragments& f = *s.fragments;
  const std::size_t count = f.fragments.size();
  s.polygon_of.resize(count);
  s.plane_of.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const bool hit = f.fragments[k].seen_count != 0;
    const Surface* surface = hit ? &s.scene->surfaces()[f.seen[f.fragments[k].first_seen]] : nullptr;
    s.polygon_of[k] = hit ? surface->polygon : none;
    s.plane_of[k] = hit ? surface->plane : none;
  }
  s.faces.reset(count);
  s.intervals.clear();
  take_corners(s);
  sort_sides(s);
  s.stamp.assign(s.corners.size(), none);
  s.rank.resize(s.corners.size());
  const auto lines = static_cast<SightlineId>(s.line_start.size() - 1);
  for (SightlineId line = 0; line < lines; ++line) {
    const std::uint32_t first = s.line_start[line], end = s.line_start[line + 1];
    if (first != end) lay_over(s, line, std::span(s.sides).subspan(first, end - first));
  }
  s.degree.assign(s.corners.size(), 0);
  for (const Interval& i : s.intervals) {
    ++s.degree[s.rays.find(i.from)];
    ++s.degree[s.rays.find(i.to)];
  }
  if (!s.camera) begin_at_breaks(s);
}

}  // namespace sightline::stitching
