#include "tests/stitch/brute_fragments.hpp"

#include "exact/window.hpp"

#include <algorithm>

namespace sightline::testing {
namespace {

using Vector = std::array<Integer, 3>;

Vector oriented(const SightlineTable& table, SightlineRef ref) {
  Vector n = table.normal(ref.id);
  for (Integer& k : n) k *= ref.sign;
  return n;
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector inner_ray(const SightlineTable& table, const Cell& cell) {
  Vector sum{};
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Vector r = cross(oriented(table, cell[(k + 1) % cell.size()]), oriented(table, cell[k]));
    for (std::size_t i = 0; i < 3; ++i) sum[i] += r[i];
  }
  return sum;
}

using Point = std::array<mpq_class, 3>;
mpq_class value(const PlaneTable& planes, PlaneId p, const Point& at) {
  return planes.integer(p, 0) * at[0] + planes.integer(p, 1) * at[1] + planes.integer(p, 2) * at[2] -
         planes.integer(p, 3);
}

Point eye_of(const SightlineTable& table) {
  Point eye;
  for (std::size_t k = 0; k < 3; ++k) eye[k] = mpq_class(table.eye().c[k]) / mpq_class(Integer(1) << table.eye().shift);
  return eye;
}

void cut_by_scene(const Scene& scene, SightlineTable& table, std::vector<Cell>& cells) {
  std::vector<PlaneId> planes;
  for (const Surface& surface : scene.surfaces()) {
    if (table.eye_side(surface.plane) == 0) continue;
    planes.push_back(surface.plane);
    for (const SurfaceEdge& edge : scene.edges(surface)) cut_cells(table, cells, table.of_points(edge.a, edge.b));
  }
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  for (const PlaneId p : planes) {
    for (const PlaneId q : planes) {
      if (p < q) cut_cells(table, cells, table.of_planes(p, q));
    }
  }
}

}  // namespace

Cell part_inside(SightlineTable& table, const Cell& cell, SightlineRef line) {
  const std::size_t n = cell.size();
  std::vector<Sign> at(n);  // of the corner between sides k and k + 1
  for (std::size_t k = 0; k < n; ++k) at[k] = table.order(cell[(k + 1) % n], cell[k], line);
  if (std::none_of(at.begin(), at.end(), [](Sign s) { return s > 0; })) return {};
  if (std::none_of(at.begin(), at.end(), [](Sign s) { return s < 0; })) return cell;
  Cell part;
  for (std::size_t k = 0; k < n; ++k) {
    const Sign before = at[(k + n - 1) % n];
    if (before > 0 || at[k] > 0) part.push_back(cell[k]);
    if (before > 0 && at[k] <= 0) part.push_back(line);
  }
  return part;
}

void cut_cells(SightlineTable& table, std::vector<Cell>& cells, SightlineRef line) {
  if (line.id == none) return;
  std::vector<Cell> parts;
  for (const Cell& cell : cells) {
    for (const SightlineRef side : {line, -line}) {
      Cell part = part_inside(table, cell, side);
      if (!part.empty()) parts.push_back(std::move(part));
    }
  }
  cells = std::move(parts);
}

Cell window_cell(SightlineTable& table, const Camera& camera) {
  const Window window(camera.forward, camera.right, camera.up);
  const SightlineRef left = window.side(table, Window::left), right = window.side(table, Window::right);
  const SightlineRef bottom = window.side(table, Window::bottom), top = window.side(table, Window::top);
  return window.handedness() > 0 ? Cell{bottom, right, top, left} : Cell{bottom, left, top, right};
}

std::vector<Cell> octant_cells(SightlineTable& table) {
  const SightlineRef x = table.of_normal({1, 0, 0}), y = table.of_normal({0, 1, 0}), z = table.of_normal({0, 0, 1});
  std::vector<Cell> cells;
  for (int k = 0; k < 8; ++k) {
    const SightlineRef a = k & 1 ? -x : x, b = k & 2 ? -y : y, c = k & 4 ? -z : z;
    // Counter-clockwise: the corner of the first two sides lies on the inner side of the third.
    cells.push_back(table.order(b, a, c) > 0 ? Cell{a, b, c} : Cell{b, a, c});
  }
  return cells;
}

std::vector<SurfaceId> look(const Scene& scene, const SightlineTable& table, const Cell& cell) {
  const Vector ray = inner_ray(table, cell);
  const Point eye = eye_of(table);
  const PlaneTable& planes = scene.planes();
  std::vector<SurfaceId> seen;
  mpq_class nearest;
  for (SurfaceId k = 0; k < scene.surfaces().size(); ++k) {
    const Surface& surface = scene.surfaces()[k];
    const mpq_class at_eye = value(planes, surface.plane, eye);
    mpq_class speed;
    for (std::size_t i = 0; i < 3; ++i) speed += planes.integer(surface.plane, static_cast<int>(i)) * ray[i];
    if (at_eye == 0 || speed == 0) continue;
    if (scene.options().one_sided && (at_eye > 0) == surface.flipped) continue;
    const mpq_class t = -at_eye / speed;
    if (t <= 0 || (!seen.empty() && t > nearest)) continue;
    Point hit;
    for (std::size_t i = 0; i < 3; ++i) hit[i] = eye[i] + t * ray[i];
    const auto edges = scene.edges(surface);
    if (!std::all_of(edges.begin(), edges.end(),
                     [&](const SurfaceEdge& e) { return sgn(value(planes, e.wall, hit)) == e.inside; })) {
      continue;
    }
    if (!seen.empty() && t < nearest) seen.clear();
    nearest = t;
    seen.push_back(k);
  }
  return seen;
}

Fragments brute_fragments(const Scene& scene, const Camera* camera, SightlineTable& table,
                          const BruteOptions& options) {
  std::mt19937 random(options.seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<Cell> cells;
  if (camera) {
    cells.push_back(window_cell(table, *camera));
  } else {
    cells = octant_cells(table);
  }
  for (int k = 0; k < options.extra_cuts; ++k) {
    const auto any_point = [&] { return static_cast<PointId>(below(static_cast<int>(scene.points().size()))); };
    const SightlineRef line =
        below(3) == 0 ? table.of_normal({below(19) - 9, below(19) - 9, 10}) : table.of_points(any_point(), any_point());
    cut_cells(table, cells, line);
  }
  cut_by_scene(scene, table, cells);
  if (options.shuffle) {
    std::shuffle(cells.begin(), cells.end(), random);
    for (Cell& cell : cells) std::rotate(cell.begin(), cell.begin() + below(static_cast<int>(cell.size())), cell.end());
  }
  Fragments fragments;
  for (const Cell& cell : cells) {
    fragments.add_convex(cell, look(scene, table, cell));
  }
  return fragments;
}

PolygonSoup random_soup(std::mt19937& random, int most) {
  const auto from = [&](int a, int b) { return a + static_cast<int>(random() % static_cast<unsigned>(b - a + 1)); };
  const int k = from(2, 4), count = from(2, most);
  PolygonSoup soup;
  soup.source = "random.obj";
  const auto corner = [&](const glm::dvec3& p) {
    // Sometimes an earlier vertex in the same place is shared.
    if (from(0, 1) == 0) {
      for (std::uint32_t v = 0; v < soup.vertices.size(); ++v) {
        if (soup.vertices[v] == p) return soup.corners.push_back(v);
      }
    }
    soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
    soup.vertices.push_back(p);
  };
  const auto anywhere = [&] { return glm::dvec3(from(-k, k), from(-1, 2 * k), from(-k, k)); };
  for (int n = 0; n < count; ++n) {
    const int shape = from(0, 99);
    if (shape < 50) {
      for (int i = 0; i < (shape < 40 ? 3 : 4); ++i) corner(anywhere());
    } else {
      const int axis = from(0, 2), height = axis == 1 ? from(0, k) : from(-k, k);
      const auto lift = [&](double a, double b) {
        glm::dvec3 p;
        p[axis] = height;
        p[(axis + 1) % 3] = a;
        p[(axis + 2) % 3] = b;
        return p;
      };
      double u0 = from(-k, k - 1), v0 = from(-k, k - 1), u1 = u0 + from(1, k), v1 = v0 + from(1, k);
      if (axis != 1) {
        u0 += k;
        u1 += k;
      }
      const double um = (u0 + u1) / 2, vm = (v0 + v1) / 2;
      std::vector<glm::dvec3> loop{lift(u0, v0), lift(u1, v0), lift(u1, v1), lift(u0, v1)};
      if (shape >= 85) loop = {lift(u0, v0), lift(u1, v0), lift(u1, vm), lift(um, vm), lift(um, v1), lift(u0, v1)};
      if (shape >= 94) loop = {lift(u0, v0), lift(um, v0), lift(u1, v0), lift(u1, v1), lift(u0, v1)};
      for (const glm::dvec3& p : loop) corner(p);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

Camera random_camera(std::mt19937& random) {
  const auto pick = [&](std::initializer_list<double> list) { return list.begin()[random() % list.size()]; };
  Camera c;
  c.eye = {pick({0, 0, 0.5, 1, 0.25}), pick({0, -1, -2, -3}), pick({0, 0, 0.5, 1})};
  const double shift = pick({0, 0, 0.25}), lift = shift == 0 ? 0 : -0.125;
  c.right = glm::dvec3(1, -shift, 0) * pick({2, 4});
  c.up = {0, 0, pick({2, 1.5, 3})};
  c.forward = {shift, 1, lift};
  return c;
}

}  // namespace sightline::testing
