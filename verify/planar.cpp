// How a map's edges lie to each other: that they are a planar subdivision of the window, with the loops it names.
#include "verify/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sightline::verify {

namespace {

/// Does the box certainly lie on one side of the line? (Its corners are points of the window but for 2^-49.)
bool beside(const Line& line, const Box& box) {
  const double s = (box.s0 + box.s1) / 2, t = (box.t0 + box.t1) / 2;
  const double reach = std::abs(line.a) * (box.s1 - box.s0) / 2 + std::abs(line.b) * (box.t1 - box.t0) / 2;
  return std::abs(line.a * s + line.b * t + line.c) > reach + 0x1p-46;
}

}  // namespace

bool Drawing::check_crossings(Report& report) {
  bool sound = true;
  const auto strictly_beside = [&](std::uint32_t line, std::uint32_t a, std::uint32_t b) {
    return side_at(line, a) * side_at(line, b) > 0;
  };
  const auto meet = [&](std::uint32_t i, std::uint32_t k) {
    const MapEdge &e = file_.edges[i], &f = file_.edges[k];
    const auto &u = e.vertices, &v = f.vertices;
    for (std::size_t x = 0; x < 2; ++x) {
      for (std::size_t y = 0; y < 2; ++y) {
        if (u[x] != v[y]) continue;
        // They share a vertex: they meet elsewhere only where they lead away from it in the same direction.
        const std::uint32_t p = u[1 - x], q = v[1 - y];
        if (p == q) return true;
        if (side_at(e.line, q) != 0) return false;
        return compare(vertices_[p], vertices_[u[x]]) == compare(vertices_[q], vertices_[u[x]]);
      }
    }
    if (strictly_beside(e.line, v[0], v[1]) || strictly_beside(f.line, u[0], u[1])) return false;
    if (side_at(e.line, v[0]) != 0 || side_at(e.line, v[1]) != 0) return true;
    const auto order = [&](std::uint32_t a, std::uint32_t b) { return compare(vertices_[a], vertices_[b]); };
    const bool forwards = order(u[0], u[1]) < 0, other = order(v[0], v[1]) < 0;
    const std::uint32_t low_e = u[forwards ? 0 : 1], high_e = u[forwards ? 1 : 0];
    const std::uint32_t low_f = v[other ? 0 : 1], high_f = v[other ? 1 : 0];
    return order(high_e, low_f) >= 0 && order(high_f, low_e) >= 0;
  };
  for (std::uint32_t i = 0; i < file_.edges.size(); ++i) {
    const Box& own = tree_.box(i);
    const Line& line = lines_[file_.edges[i].line];
    tree_.visit([&](const Box& b, double) { return b.meets(own) && !beside(line, b); },
                [&](std::uint32_t k) {
                  if (k > i && tree_.box(k).meets(own) && meet(i, k)) {
                    report.fault("crossings", named("edge", i),
                                 "meets edge " + std::to_string(k) + " outside a shared vertex");
                    sound = false;
                  }
                  return true;
                });
  }
  return sound;
}

int Drawing::rising(std::int32_t entry) const {
  const std::uint32_t e = edge_of(entry);
  int way = rightwards_[e];
  if (way == 0) way = compare_t(end(e), start(e));
  return entry >= 0 ? way : -way;
}

bool Drawing::directed_before(std::int32_t a, std::int32_t b) const {
  const int half_a = rising(a), half_b = rising(b);
  if (half_a != half_b) return half_a > half_b;
  const std::uint32_t e = edge_of(a);
  return left_sign_[e] * (a >= 0 ? 1 : -1) * side_at(file_.edges[e].line, to(b)) > 0;
}

void Drawing::sort_around() {
  first_around_.assign(vertices_.size() + 1, 0);
  for (const MapEdge& e : file_.edges) {
    for (const std::uint32_t v : e.vertices) ++first_around_[v + 1];
  }
  std::partial_sum(first_around_.begin(), first_around_.end(), first_around_.begin());
  around_.resize(2 * file_.edges.size());
  std::vector<std::uint32_t> next(first_around_.begin(), first_around_.end() - 1);
  for (std::size_t i = 0; i < file_.edges.size(); ++i) {
    const auto e = static_cast<std::int32_t>(i);
    around_[next[file_.edges[i].vertices[0]]++] = e;
    around_[next[file_.edges[i].vertices[1]]++] = -e - 1;
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    std::sort(around_.begin() + first_around_[v], around_.begin() + first_around_[v + 1],
              [&](std::int32_t a, std::int32_t b) { return directed_before(a, b); });
  }
}

bool Drawing::check_loops(Report& report) {
  bool sound = true;
  const auto fault = [&](const char* kind, std::size_t item, const std::string& what) {
    report.fault("loops", named(kind, item), what);
    sound = false;
  };
  const auto side_of = [](std::int32_t entry) { return 2 * edge_of(entry) + (entry >= 0 ? 0 : 1); };
  std::vector<std::uint32_t> used(2 * file_.edges.size(), 0);
  // The entry after which an entry leads on clockwise: seen from the vertex, the one before its way back.
  std::vector<std::int32_t> onwards(2 * file_.edges.size());
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    const auto ring = around(v);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      onwards[side_of(-ring[i] - 1)] = ring[(i + ring.size() - 1) % ring.size()];
    }
  }
  for (std::uint32_t f = 0; f < file_.faces.size(); ++f) {
    const auto& loops = file_.faces[f].loops;
    if (loops.empty()) fault("face", f, "has no loop");
    for (std::size_t k = 0; k < loops.size(); ++k) {
      const auto& loop = loops[k];
      const std::string name = "loop " + std::to_string(k) + " ";
      bool closed = !loop.empty();
      if (loop.empty()) fault("face", f, name + "is empty");
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::int32_t entry = loop[i], next = loop[(i + 1) % loop.size()];
        ++used[side_of(entry)];
        if (face(entry) != f) {
          fault("face", f,
                name + "has edge " + std::to_string(edge_of(entry)) + ", which does not have the face on that side");
        }
        if (to(entry) != from(next)) {
          closed = false;
          fault("face", f,
                name + "does not lead from edge " + std::to_string(edge_of(entry)) + " to edge " +
                    std::to_string(edge_of(next)));
        } else if (onwards[side_of(entry)] != next) {
          fault("face", f, name + "does not take the next edge clockwise at vertex " + std::to_string(to(entry)));
        }
      }
      if (!closed) continue;
      const int orientation = loop_orientation(*this, loop);
      if (k == 0 && orientation <= 0) fault("face", f, name + "(the outer one) does not run counter-clockwise");
      if (k > 0 && orientation >= 0) fault("face", f, name + "(a hole) does not run clockwise");
    }
  }
  for (std::size_t e = 0; e < file_.edges.size(); ++e) {
    for (const std::size_t way : {0U, 1U}) {
      const bool expected = (way == 0 ? file_.edges[e].left : file_.edges[e].right) != none;
      if (used[2 * e + way] != (expected ? 1U : 0U)) {
        fault("edge", e,
              std::string(way == 0 ? "forwards" : "backwards") + " stands " + std::to_string(used[2 * e + way]) +
                  " times in loops");
      }
    }
  }
  return sound;
}

bool Drawing::check_border(Report& report) {
  bool sound = true;
  const auto fault = [&](const std::string& item, const std::string& what) {
    report.fault("border", item, what);
    sound = false;
  };
  static constexpr std::array<const char*, 4> names{"left", "right", "bottom", "top"};
  const auto on = [&](std::size_t k, const Point& p) {
    return k == 0 ? p.r.x == 0 : k == 1 ? p.r.x == p.r.z : k == 2 ? p.r.y == 0 : p.r.y == p.r.z;
  };
  std::array<std::vector<std::array<std::uint32_t, 2>>, 4> along;  // lower and upper vertex of each edge of a side
  for (std::uint32_t i = 0; i < file_.edges.size(); ++i) {
    const MapEdge& e = file_.edges[i];
    std::size_t k = 0;
    while (k < 4 && !(on(k, start(i)) && on(k, end(i)))) ++k;
    if (k == 4) {
      if (e.left == none || e.right == none) fault(named("edge", i), "has null on a side that is inside the window");
      continue;
    }
    const int way = rightwards_[i] != 0 ? rightwards_[i] : compare_t(end(i), start(i));
    const Triple& inner = view_.border()[k].n;
    const bool left_inside = (rightwards_[i] != 0 ? way * sgn(inner.y) : -way * sgn(inner.x)) > 0;
    if ((left_inside ? e.right : e.left) != none) fault(named("edge", i), "has a face outside the window");
    if ((left_inside ? e.left : e.right) == none)
      fault(named("edge", i), "has null on a side that is inside the window");
    along[k].push_back({e.vertices[way > 0 ? 0 : 1], e.vertices[way > 0 ? 1 : 0]});
  }
  for (std::size_t k = 0; k < 4; ++k) {
    auto& edges = along[k];
    const std::string item = std::string(names[k]) + " side";
    std::sort(edges.begin(), edges.end(),
              [&](const auto& a, const auto& b) { return compare(vertices_[a[0]], vertices_[b[0]]) < 0; });
    const std::size_t low = k < 2 ? 2 : 0, high = low + 1;
    if (edges.empty() || !on(low, vertices_[edges.front()[0]]) || !on(high, vertices_[edges.back()[1]])) {
      fault(item, "is not covered by edges from corner to corner");
    }
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      if (edges[i][1] != edges[i + 1][0]) {
        fault(item, "is not covered by edges after vertex " + std::to_string(edges[i][1]));
      }
    }
  }
  return sound;
}

bool Drawing::check_holes(Report& report) {
  std::vector<std::uint32_t> parent(vertices_.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto component = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const MapEdge& e : file_.edges) parent[component(e.vertices[0])] = component(e.vertices[1]);
  // A hole belongs to its face where, the hole's own component left out, the face's boundary goes around it an odd
  // number of times: inside the outer loop and in no other hole.
  bool sound = true;
  for (std::uint32_t f = 0; f < file_.faces.size(); ++f) {
    const auto& loops = file_.faces[f].loops;
    for (std::size_t k = 1; k < loops.size(); ++k) {
      const std::uint32_t v = from(loops[k][0]), own = component(v);
      bool odd = false;
      below(vertices_[v], [&](std::uint32_t e) {
        odd ^= (file_.edges[e].left == f || file_.edges[e].right == f) && component(file_.edges[e].vertices[0]) != own;
      });
      if (odd) continue;
      report.fault("holes", named("face", f), "loop " + std::to_string(k) + " is no hole in it");
      sound = false;
    }
  }
  return sound;
}

int loop_orientation(const Drawing& drawing, std::span<const std::int32_t> loop) {
  const Point& o = drawing.vertex(drawing.from(loop[0]));
  double sum = 0, reach = 0;
  for (const std::int32_t entry : loop) {
    const Point &a = drawing.vertex(drawing.from(entry)), &b = drawing.vertex(drawing.to(entry));
    sum += (a.s - o.s) * (b.t - o.t) - (b.s - o.s) * (a.t - o.t);
    reach = std::max({reach, std::abs(a.s - o.s), std::abs(a.t - o.t)});
  }
  // Differences of magnitude `reach` are off by 2^-52; a term by 4 * 2^-52 reach + 2^-102, and by 3 roundings of
  // 2^-52 reach^2 at most; the sum of n terms of 2 reach^2 by n * n * 2^-52 reach^2.
  const auto n = static_cast<double>(loop.size());
  const double error = n * (reach * 0x1p-49 + 0x1p-100) + n * n * reach * reach * 0x1p-51;
  if (sum > error) return 1;
  if (sum < -error) return -1;
  Rational exact;
  for (const std::int32_t entry : loop) {
    const Triple &a = drawing.vertex(drawing.from(entry)).r, &b = drawing.vertex(drawing.to(entry)).r;
    Rational term(a.x * b.y - b.x * a.y, a.z * b.z);
    term.canonicalize();
    exact += term;
  }
  return sgn(exact);
}

}  // namespace sightline::verify
