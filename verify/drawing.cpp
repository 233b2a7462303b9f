// Lines, vertices and edges of a map, each by itself.
#include "verify/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sightline::verify {

bool Drawing::check(Report& report) {
  const auto stop = [&](const char* what) {
    report.left_out = what;
    return false;
  };
  if (!make_lines(report)) return stop("all checks after lines");
  if (!make_vertices(report)) return stop("all checks after vertices");
  if (!make_edges(report)) return stop("all checks after edges");
  if (!check_crossings(report)) return stop("all checks after crossings");
  sort_around();
  const bool border = check_border(report);
  if (!check_loops(report) || !border) return stop("all checks after loops and border");
  if (!check_holes(report)) return stop("all checks after holes");
  return true;
}

bool Drawing::make_lines(Report& report) {
  bool sound = true;
  const auto fault = [&](std::size_t i, const char* what) {
    report.fault("lines", named("line", i), what);
    sound = false;
  };
  for (std::size_t i = 0; i < file_.lines.size(); ++i) {
    const MapLine& name = file_.lines[i];
    Triple n;
    if (name.kind == MapLine::window) {
      n = view_.border()[name.v[0]].n;
    } else if (name.kind == MapLine::edge) {
      n = view_.line(cross(view_.ray(name.v[0]), view_.ray(name.v[1])));
      if (n.is_zero()) fault(i, "the eye and its two scene vertices lie on a line");
    } else {
      std::array<Triple, 2> normal;
      std::array<Integer, 2> height;
      bool planes = true;
      for (std::size_t k = 0; k < 2; ++k) {
        const Triple a = view_.ray(name.v[3 * k]);
        normal[k] = cross(view_.ray(name.v[3 * k + 1]) - a, view_.ray(name.v[3 * k + 2]) - a);
        height[k] = dot(normal[k], a);
        planes = planes && !normal[k].is_zero();
      }
      if (!planes) {
        fault(i, "three scene vertices of a plane lie on a line");
      } else if (cross(normal[0], normal[1]).is_zero()) {
        fault(i, "its two planes are parallel");
      } else {
        n = view_.line(height[1] * normal[0] - height[0] * normal[1]);
        if (n.is_zero()) fault(i, "its two planes meet in a line through the eye");
      }
    }
    lines_.push_back(make_line(std::move(n)));
  }
  return sound;
}

bool Drawing::make_vertices(Report& report) {
  bool sound = true;
  const auto fault = [&](std::size_t i, std::string what) {
    report.fault("vertices", named("vertex", i), std::move(what));
    sound = false;
  };
  for (std::size_t i = 0; i < file_.vertices.size(); ++i) {
    const MapVertex& v = file_.vertices[i];
    Triple r = cross(lines_[v.lines[0]].n, lines_[v.lines[1]].n);
    if (r.z == 0) {
      fault(i, r.is_zero() ? "its two lines are the same" : "its two lines meet in no point of the view");
      vertices_.emplace_back();
      continue;
    }
    if (r.z < 0) negate(r);
    const bool within = r.x >= 0 && r.x <= r.z && r.y >= 0 && r.y <= r.z;
    if (!within) fault(i, "lies outside the window");
    const double s = nearest_double(r.x, r.z), t = nearest_double(r.y, r.z);
    if (within && (s != v.st[0] || t != v.st[1])) {
      report.fault("st", named("vertex", i),
                   "is not the nearest doubles, (" + std::to_string(s) + ", " + std::to_string(t) + ")");
    }
    vertices_.push_back({std::move(r), s, t});
  }
  if (!sound) return false;
  // Equal points have equal nearest doubles.
  std::vector<std::uint32_t> order(vertices_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) { return std::array{vertices_[i].s, vertices_[i].t}; };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i; k-- > 0 && key(order[k]) == key(order[i]);) {
      if (compare(vertices_[order[k]], vertices_[order[i]]) == 0) {
        fault(order[i], "is the same point as vertex " + std::to_string(order[k]));
        break;
      }
    }
  }
  return sound;
}

bool Drawing::make_edges(Report& report) {
  bool sound = true;
  std::vector<std::uint32_t> degree(vertices_.size(), 0);
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < file_.edges.size(); ++i) {
    const MapEdge& e = file_.edges[i];
    const auto fault = [&](const std::string& what) {
      report.fault("edges", named("edge", i), what);
      sound = false;
    };
    const auto [a, b] = e.vertices;
    for (const std::uint32_t v : e.vertices) {
      ++degree[v];
      if (side_at(e.line, v) != 0) fault("its vertex " + std::to_string(v) + " is not on its line");
    }
    if (a == b) fault("has no length");
    if (e.left == none && e.right == none) fault("has no face on either side");
    const Point &p = vertices_[a], &q = vertices_[b];
    const int right = compare_s(q, p);
    // Leftwards of a direction (ds, dt) is (-dt, ds); the line's value rises along (A, B), and (ds, dt) is a multiple
    // k of (B, -A), so that leftwards is k (A, B).
    const Line& line = lines_[e.line];
    const int sign = right != 0 ? right * sgn(line.n.y) : -compare_t(q, p) * sgn(line.n.x);
    rightwards_.push_back(static_cast<signed char>(right));
    left_sign_.push_back(static_cast<signed char>(sign));
    Box box;
    box.add({p.s - 0x1p-49, p.t - 0x1p-49, p.s + 0x1p-49, p.t + 0x1p-49});
    box.add({q.s - 0x1p-49, q.t - 0x1p-49, q.s + 0x1p-49, q.t + 0x1p-49});
    boxes.push_back(box);
  }
  for (std::size_t i = 0; i < degree.size(); ++i) {
    if (degree[i] < 2) {
      report.fault("edges", named("vertex", i), "has fewer than two edges");
      sound = false;
    }
  }
  tree_ = EdgeTree(std::move(boxes));
  return sound;
}

bool Drawing::passes_below(std::uint32_t edge, const Point& p) const {
  const int right = rightwards_[edge];
  if (right == 0) return false;
  const Point &left = right > 0 ? start(edge) : end(edge), &far = right > 0 ? end(edge) : start(edge);
  if (compare_s(left, p) > 0 || compare_s(p, far) >= 0) return false;
  return side(lines_[file_.edges[edge].line], p) * left_sign_[edge] * right > 0;
}

std::uint32_t Drawing::locate(const Point& p) const {
  // Below a point, all faces but the one that holds it are entered as often as they are left.
  std::vector<std::uint32_t> odd;
  const auto flip = [&](std::uint32_t face) {
    const auto found = std::find(odd.begin(), odd.end(), face);
    if (found == odd.end()) {
      odd.push_back(face);
    } else {
      odd.erase(found);
    }
  };
  below(p, [&](std::uint32_t e) {
    flip(file_.edges[e].left);
    flip(file_.edges[e].right);
  });
  for (const std::uint32_t face : odd) {
    if (face != none) return face;
  }
  return none;
}

bool Drawing::holds(std::uint32_t face, const Point& p) const {
  bool odd = false;
  below(p, [&](std::uint32_t e) { odd ^= file_.edges[e].left == face || file_.edges[e].right == face; });
  return odd;
}

}  // namespace sightline::verify
