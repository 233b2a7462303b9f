// Small scenes in which nothing is in general position: what random numbers never reach, made on purpose.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sightline::testing {

/// The same numbers everywhere, for ever (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ull + 0x2545f4914f6cdd1dull) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// 0 .. n-1.
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool once_in(int n) { return below(n) == 0; }
  /// All 53 bits, in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

/// A scene and a camera in it.
struct Case {
  PolygonSoup soup;
  SceneOptions options;
  Camera camera;
};

/// Polygons drawn from few points, few planes and few directions. Which degeneracies a scene has depends on its seed.
class SceneMaker {
 public:
  explicit SceneMaker(std::uint64_t seed) : random_(seed) {
    family_ = static_cast<Family>(random_.below(5));
    range_ = random_.between(2, 8);
    nudges_ = random_.once_in(3);
    soup_.source = "case" + std::to_string(seed) + ".obj";
  }

  /// `most` polygons at most, two at least.
  Case make(int most) {
    const int count = random_.between(2, most);
    for (int k = 0; k < count; ++k) add_polygon();
    if (nudges_) nudge();
    Case result{soup_, {}, camera()};
    result.options.one_sided = random_.once_in(8);
    return result;
  }

 private:
  enum Family { integers, eighths, decimals, doubles, mixed };
  struct Frame {  // a plane with a lattice in it
    glm::dvec3 origin, u, v;
    glm::dvec3 at(int i, int j) const { return origin + static_cast<double>(i) * u + static_cast<double>(j) * v; }
  };

  double coordinate() {
    switch (family_) {
      case integers:
        return random_.between(0, range_);
      case eighths:
        return random_.between(0, 8 * range_) / 8.0;
      case decimals:
        return random_.between(0, 10 * range_) / 10.0;
      case doubles:
        return random_.unit() * range_;
      case mixed:
        return random_.once_in(3)   ? random_.between(0, range_)
               : random_.once_in(2) ? random_.between(0, 100 * range_) / 100.0
                                    : std::ldexp(random_.unit() * range_, -random_.below(12));
    }
    return 0;
  }
  glm::dvec3 point() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

  /// An old vertex, where there is one; else a new point.
  std::uint32_t vertex() {
    if (!soup_.vertices.empty() && random_.once_in(3)) {
      return static_cast<std::uint32_t>(random_.below(static_cast<int>(soup_.vertices.size())));
    }
    return add_vertex(point());
  }
  std::uint32_t add_vertex(const glm::dvec3& x) {
    // The same point gets the same index or another, so that both ways of sharing occur.
    for (std::uint32_t k = 0; k < soup_.vertices.size(); ++k) {
      if (soup_.vertices[k] == x && !random_.once_in(4)) return k;
    }
    soup_.vertices.push_back(x);
    return static_cast<std::uint32_t>(soup_.vertices.size() - 1);
  }

  Frame frame() {
    if (!frames_.empty() && random_.once_in(3))
      return frames_[static_cast<std::size_t>(random_.below(static_cast<int>(frames_.size())))];
    Frame f{point(), {}, {}};
    const int axis = random_.below(3);
    const double step = family_ == integers || random_.once_in(2) ? 1.0 : coordinate() / range_;
    if (random_.once_in(2)) {
      f.u[(axis + 1) % 3] = step;
      f.v[(axis + 2) % 3] = step;
    } else {
      f.u = {random_.between(-1, 1), random_.between(-1, 1), random_.between(0, 1)};
      f.v = {random_.between(-1, 1), random_.between(0, 1), random_.between(-1, 1)};
      if (random_.once_in(2)) f.u *= step;
    }
    frames_.push_back(f);
    return f;
  }

  void add_polygon() {
    switch (random_.below(10)) {
      case 0:
      case 1:
      case 2:
        return add_triangle();
      case 3:
      case 4:
      case 5:
        return add_rectangle();
      case 6:
        return add_lattice_polygon();
      case 7:
        return add_on_old_edge();
      case 8:
        return random_.once_in(2) ? add_copy() : add_rectangle();
      default:
        return random_.once_in(3) ? add_loose_quad() : add_triangle();
    }
  }
  void add(std::vector<std::uint32_t> corners) {
    if (random_.once_in(3)) std::reverse(corners.begin(), corners.end());
    if (random_.once_in(8)) {  // a repeated corner
      const std::size_t k = static_cast<std::size_t>(random_.below(static_cast<int>(corners.size())));
      corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(k), corners[k]);
    }
    soup_.corners.insert(soup_.corners.end(), corners.begin(), corners.end());
    soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
  }
  void add_triangle() {
    const std::uint32_t a = vertex(), b = vertex(), c = vertex();
    add({a, b, c});
  }
  void add_rectangle() {
    const Frame f = frame();
    const int i = random_.between(-1, 2), j = random_.between(-1, 2), w = random_.between(1, 4),
              h = random_.between(1, 4);
    std::vector<std::uint32_t> corners;
    for (const auto& [x, y] : {std::pair{i, j}, {i + w, j}, {i + w, j + h}, {i, j + h}}) {
      corners.push_back(add_vertex(f.at(x, y)));
      if (random_.once_in(8)) {  // a vertex on the side that follows, or not quite
        const glm::dvec3 next = x == i ? f.at(x + (y == j ? w : 0), y) : f.at(x, y + (y == j ? h : 0));
        corners.push_back(add_vertex((f.at(x, y) + next) * 0.5));
      }
    }
    add(corners);
  }
  /// Any closed walk over few points of a plane: not convex, or crossing itself, or with spurs.
  void add_lattice_polygon() {
    const Frame f = frame();
    const int n = random_.between(4, 7);
    std::vector<std::uint32_t> corners;
    if (random_.once_in(2)) {  // an L or a U
      const std::vector<std::pair<int, int>> l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
      const std::vector<std::pair<int, int>> u{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
      for (const auto& [x, y] : random_.once_in(2) ? l : u) corners.push_back(add_vertex(f.at(x, y)));
    } else {
      for (int k = 0; k < n; ++k) {
        const int x = random_.between(0, 3), y = random_.between(0, 3);
        corners.push_back(add_vertex(f.at(x, y)));
      }
    }
    add(corners);
  }
  /// Shares an edge with an old polygon, whole or extended.
  void add_on_old_edge() {
    if (soup_.first.size() < 2) return add_triangle();
    const auto p = static_cast<std::size_t>(random_.below(static_cast<int>(soup_.first.size()) - 1));
    const std::uint32_t first = soup_.first[p], count = soup_.first[p + 1] - first;
    const auto k = static_cast<std::uint32_t>(random_.below(static_cast<int>(count)));
    const std::uint32_t a = soup_.corners[first + k];
    std::uint32_t b = soup_.corners[first + (k + 1) % count];
    if (random_.once_in(3)) b = add_vertex(2.0 * soup_.vertices[b] - soup_.vertices[a]);
    const std::uint32_t c = vertex();
    if (random_.once_in(2)) return add({a, b, c});
    const std::uint32_t d = add_vertex(soup_.vertices[a] + soup_.vertices[c] - soup_.vertices[b]);
    add({a, b, c, d});
  }
  /// The same polygon again, turned round, or with vertices of its own.
  void add_copy() {
    if (soup_.first.size() < 2) return add_triangle();
    const auto p = static_cast<std::size_t>(random_.below(static_cast<int>(soup_.first.size()) - 1));
    std::vector<std::uint32_t> corners(soup_.corners.begin() + soup_.first[p],
                                       soup_.corners.begin() + soup_.first[p + 1]);
    if (random_.once_in(2)) {
      for (std::uint32_t& v : corners) {
        soup_.vertices.push_back(glm::dvec3(soup_.vertices[v]));
        v = static_cast<std::uint32_t>(soup_.vertices.size() - 1);
      }
    }
    std::rotate(corners.begin(), corners.begin() + random_.below(static_cast<int>(corners.size())), corners.end());
    add(corners);
  }
  /// Four points, hardly ever in a plane.
  void add_loose_quad() {
    const std::uint32_t a = vertex(), b = vertex(), c = vertex(), d = vertex();
    add({a, b, c, d});
  }

  /// Moves a few coordinates by one unit in the last place.
  void nudge() {
    for (int k = random_.between(1, 3); k > 0; --k) {
      const auto v = static_cast<std::size_t>(random_.below(static_cast<int>(soup_.vertices.size())));
      double& x = soup_.vertices[v][random_.below(3)];
      x = std::nextafter(x, random_.once_in(2) ? 1e9 : -1e9);
    }
  }

  glm::dvec3 some_vertex() {
    return soup_.vertices[static_cast<std::size_t>(random_.below(static_cast<int>(soup_.vertices.size())))];
  }
  glm::dvec3 eye() {
    switch (random_.below(7)) {
      case 0:
        return some_vertex();
      case 1:
        return (some_vertex() + some_vertex()) * 0.5;  // often on an edge, a polygon or a plane
      case 2:
        return frames_.empty() ? point() : frames_[0].at(random_.between(-2, 5), random_.between(-2, 5));
      case 3:
        return 2.0 * some_vertex() - some_vertex();  // in line with two vertices
      case 4:
        return point() - glm::dvec3(2.0 * range_, 0, 0);
      default:
        return point();
    }
  }
  glm::dvec3 middle() const {
    glm::dvec3 sum{0, 0, 0};
    for (const glm::dvec3& v : soup_.vertices) sum += v;
    return sum / static_cast<double>(soup_.vertices.size());
  }
  Camera camera() {
    for (;;) {
      Camera c;
      c.eye = eye();
      switch (random_.below(4)) {
        case 0: {
          c.forward = {0, 0, 0};
          c.forward[random_.below(3)] = random_.once_in(2) ? 1 : -1;
          break;
        }
        case 1:
          c.forward = some_vertex() - c.eye;
          break;
        default:
          c.forward = {random_.between(-2, 2), random_.between(-2, 2), random_.between(-2, 2)};
      }
      // Mostly towards the scene: a camera that looks away from it sees nothing.
      if (!random_.once_in(5) && glm::dot(c.forward, middle() - c.eye) < 0) c.forward = -c.forward;
      const glm::dvec3 hint = random_.once_in(2) ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
      c.right = glm::cross(c.forward, hint);
      c.up = glm::cross(c.right, c.forward);
      if (family_ == doubles && random_.once_in(2)) {
        for (glm::dvec3* v : {&c.forward, &c.right, &c.up})
          *v += 0.1 * glm::dvec3(random_.unit(), random_.unit(), random_.unit());
      }
      const double wide = random_.between(1, 4);
      c.right *= wide;
      c.up *= wide / 2;
      if (random_.once_in(6)) c.right = -c.right;
      const double determinant = glm::dot(glm::cross(c.forward, c.right), c.up);
      if (std::abs(determinant) > 1e-3 && std::isfinite(determinant)) return c;
    }
  }

  Random random_;
  Family family_;
  int range_;
  bool nudges_;
  PolygonSoup soup_;
  std::vector<Frame> frames_;
};

inline Case make_case(std::uint64_t seed, int most_polygons = 12) { return SceneMaker(seed).make(most_polygons); }

}  // namespace sightline::testing
