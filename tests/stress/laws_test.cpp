// Metamorphic laws: what is done to a scene or a camera, and what that does to the map, compared in exact numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/stress/drawing.hpp"
#include "tests/stress/figures.hpp"
#include "tests/stress/judge.hpp"
#include "visibility_map/write.hpp"

namespace sightline::stress {
namespace {

/// A case, its drawing, and whatever a law needs of it.
struct Known {
  Case sample;
  std::string name;
  Scene scene;
  Drawing drawn;
};

using Law = std::function<void(const Known&, Random&)>;

/// How often a law was held against a map.
std::uint64_t applied = 0;

/// Fails where most of the cases are none for the law.
void for_cases(std::uint64_t count, const Law& law) {
  const std::uint64_t before = applied;
  for (std::uint64_t seed = 0; seed < times(count); ++seed) {
    Random random(seed + 70000);
    Known known{testing::make_case(seed + 200, 7), "seed " + std::to_string(seed + 200), {}, {}};
    Court court(known.sample.soup, known.sample.options, {.complex = false, .oracle = false});
    // Which side of a polygon that crosses itself is its front is not defined.
    if (known.sample.options.one_sided && court.scene().report().self_crossing > 0) continue;
    known.drawn = drawing(court.scene(), court.check(known.sample.camera, known.name));
    known.scene = court.scene();
    law(known, random);
  }
  EXPECT_GE(applied - before, times(count) / 3);
}

/// Only scenes of planar polygons: how others are cut into triangles depends on where they begin, which way they run
/// and how they lie to the axes.
void for_planar_cases(std::uint64_t count, const Law& law) {
  for_cases(count, [&](const Known& known, Random& random) {
    if (known.scene.report().nonplanar == 0) law(known, random);
  });
}

using Change = std::function<Drawing(Drawing)>;
/// Judges the changed case; what is drawn, seen through `image`, must be what was `expected`.
void expect(const Case& changed, const std::string& name, const Drawing& expected, const Change& image) {
  Court court(changed.soup, changed.options, {.oracle = false});
  const VisibilityMap& map = court.check(changed.camera, name);
  ++applied;
  const std::string different = difference(expected, image(drawing(court.scene(), map)));
  if (!different.empty()) court.fault("the law does not hold\n" + different);
}
Drawing as_it_is(Drawing drawing) { return drawing; }

std::vector<std::uint32_t> corners_of(const PolygonSoup& soup, std::size_t p) {
  return {soup.corners.begin() + soup.first[p], soup.corners.begin() + soup.first[p + 1]};
}
void append(PolygonSoup& soup, const std::vector<std::uint32_t>& corners) {
  soup.corners.insert(soup.corners.end(), corners.begin(), corners.end());
  soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
}
/// Polygons run the other way round.
void reverse(PolygonSoup& soup) {
  for (std::size_t p = 0; p + 1 < soup.first.size(); ++p) {
    std::reverse(soup.corners.begin() + soup.first[p], soup.corners.begin() + soup.first[p + 1]);
  }
}

/// An order of the polygons at random, but for those that share a plane with each other: they keep theirs, since where
/// they overlap the first is seen.
std::vector<PolygonId> some_order(const Scene& scene, Random& random) {
  std::vector<PolygonId> group(scene.polygon_count());
  std::iota(group.begin(), group.end(), 0u);
  for (const Surface& s : scene.surfaces()) {
    for (const Surface& t : scene.surfaces()) {
      if (s.plane != t.plane || group[s.polygon] == group[t.polygon]) continue;
      const PolygonId from = std::max(group[s.polygon], group[t.polygon]);
      const PolygonId to = std::min(group[s.polygon], group[t.polygon]);
      std::ranges::replace(group, from, to);
    }
  }
  std::vector<PolygonId> order(group.size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t k = order.size(); k > 1; --k) {
    std::swap(order[k - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
  }
  for (PolygonId g = 0; g < group.size(); ++g) {  // the group's members, ascending, into the places that they drew
    std::vector<std::size_t> places;
    std::vector<PolygonId> members;
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (group[order[k]] != g) continue;
      places.push_back(k);
      members.push_back(order[k]);
    }
    std::ranges::sort(members);
    for (std::size_t k = 0; k < places.size(); ++k) order[places[k]] = members[k];
  }
  return order;
}

TEST(StressLaws, OrderOfPolygonsAndVertices) {
  for_cases(30, [](const Known& known, Random& random) {
    const PolygonSoup& old = known.sample.soup;
    std::vector<std::uint32_t> vertex(old.vertices.size());
    std::iota(vertex.begin(), vertex.end(), 0u);
    for (std::size_t k = vertex.size(); k > 1; --k) {
      std::swap(vertex[k - 1], vertex[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
    }
    const std::vector<PolygonId> order = some_order(known.scene, random);
    Case changed = known.sample;
    PolygonSoup& soup = changed.soup;
    for (std::size_t v = 0; v < vertex.size(); ++v) soup.vertices[vertex[v]] = old.vertices[v];
    soup.first = {0};
    soup.corners.clear();
    for (const PolygonId p : order) {
      std::vector<std::uint32_t> corners = corners_of(old, p);
      for (std::uint32_t& v : corners) v = vertex[v];
      if (known.scene.planar(p)) {
        std::rotate(corners.begin(), corners.begin() + random.below(static_cast<int>(corners.size())), corners.end());
      }
      append(soup, corners);
    }
    // Of vertices that are seen in one place the lowest is named: only whether there is one stays the same.
    const auto unnamed = [](Drawing d) { return marked(std::move(d), [](PointId) { return 0; }); };
    expect(changed, known.name + " in another order", unnamed(known.drawn),
           [&](Drawing d) { return unnamed(renamed(std::move(d), [&](PolygonId p) { return order[p]; })); });
  });
}

/// Half way between, if that is a double.
bool middle(const glm::dvec3& a, const glm::dvec3& b, glm::dvec3& out) {
  for (int axis = 0; axis < 3; ++axis) {
    out[axis] = a[axis] * 0.5 + b[axis] * 0.5;
    if (mpq_class(out[axis]) * 2 != mpq_class(a[axis]) + mpq_class(b[axis])) return false;
  }
  return true;
}

/// Cuts a plainly convex polygon in two, if there is a way: the second part comes after the first, a new vertex last.
bool cut(const Scene& scene, PolygonId p, PolygonSoup& soup, Random& random) {
  const PolygonSoup old = soup;
  const auto surfaces = scene.surfaces(p);
  std::vector<std::uint32_t> corners = corners_of(old, p);
  if (surfaces.size() != 1 || surfaces[0].edge_count != corners.size()) return false;
  std::rotate(corners.begin(), corners.begin() + random.below(static_cast<int>(corners.size())), corners.end());
  if (corners.size() == 3 || random.once_in(2)) {  // from the middle of the last side, else from the last corner
    glm::dvec3 between;
    if (!middle(old.vertices[corners.back()], old.vertices[corners.front()], between)) return false;
    soup.vertices.push_back(between);
    corners.push_back(static_cast<std::uint32_t>(soup.vertices.size() - 1));
  }
  const std::ptrdiff_t to = 1 + random.below(static_cast<int>(corners.size()) - 3);
  std::vector<std::uint32_t> one(corners.begin(), corners.begin() + to + 1);
  one.push_back(corners.back());
  const std::vector<std::uint32_t> two(corners.begin() + to, corners.end());
  soup.first = {0};
  soup.corners.clear();
  for (PolygonId q = 0; q < scene.polygon_count(); ++q) {
    append(soup, q == p ? one : corners_of(old, q));
    if (q == p) append(soup, two);
  }
  return true;
}

TEST(StressLaws, APolygonInTwo) {
  for_cases(40, [](const Known& known, Random& random) {
    Case changed = known.sample;
    const std::uint32_t count = known.scene.polygon_count();
    const std::uint32_t first = static_cast<std::uint32_t>(random.below(static_cast<int>(count)));
    for (std::uint32_t k = 0; k < count; ++k) {
      const PolygonId p = (first + k) % count;
      if (!cut(known.scene, p, changed.soup, random)) continue;
      const auto vertices = static_cast<PointId>(known.sample.soup.vertices.size());
      const auto as_before = [&](Drawing d) {
        d = renamed(std::move(d), [&](PolygonId q) { return q > p ? q - 1 : q; });
        return united(marked(std::move(d), [&](PointId v) { return v >= vertices ? none : v; }));
      };
      expect(changed, known.name + ", polygon " + std::to_string(p) + " in two", united(known.drawn), as_before);
      return;
    }
  });
}

TEST(StressLaws, HiddenPolygonsAreNotSeen) {
  for_cases(30, [](const Known& known, Random& random) {
    Case changed = known.sample;
    PolygonSoup& soup = changed.soup;
    const PolygonSoup& old = known.sample.soup;
    const glm::dvec3 eye = known.sample.camera.eye;
    if (!known.sample.options.one_sided) {
      for (PolygonId p = 0; p < known.scene.polygon_count(); ++p) {  // twice as far behind itself
        if (!known.scene.planar(p)) continue;
        std::vector<glm::dvec3> far;
        for (const std::uint32_t v : corners_of(old, p)) {
          glm::dvec3 back;
          const glm::dvec3 place = old.vertices[v] * 2.0 - eye;
          if (middle(place, eye, back) && back == old.vertices[v]) far.push_back(place);
        }
        if (far.size() < corners_of(old, p).size()) continue;
        Figure figure{soup};
        figure.add(far);
        soup = figure.soup;
      }
    }
    const glm::dvec3 ahead = known.sample.camera.forward;
    Figure figure{soup};
    // In a plane with the eye; without area; behind the eye.
    figure.add({eye, eye + ahead, old.vertices[0]});
    figure.add({old.vertices[0], old.vertices.back(), old.vertices[0]});
    const glm::dvec3 back = eye - 100.0 * (known.sample.camera.forward + known.sample.camera.right);
    const glm::dvec3 off = static_cast<double>(random.between(1, 3)) * known.sample.camera.up;
    figure.add({back, back + off, back - ahead});
    soup = figure.soup;
    const auto vertices = static_cast<PointId>(old.vertices.size());
    expect(changed, known.name + " with hidden polygons", known.drawn,
           [&](Drawing d) { return marked(std::move(d), [&](PointId v) { return v >= vertices ? none : v; }); });
  });
}

TEST(StressLaws, Mirrors) {
  for_planar_cases(50, [](const Known& known, Random& random) {
    const int axis = random.below(3);
    const auto mirror = [axis](glm::dvec3 v) {
      v[axis] = -v[axis];
      return v;
    };
    Case changed = known.sample;
    changed.soup = placed(known.sample.soup, mirror);
    reverse(changed.soup);
    for (glm::dvec3* v : {&changed.camera.eye, &changed.camera.forward, &changed.camera.right, &changed.camera.up})
      *v = mirror(*v);
    expect(changed, known.name + " in a mirror", known.drawn, as_it_is);
    for (const auto& [s, t] : {std::pair{true, false}, {false, true}, {true, true}}) {
      Case turned = known.sample;
      if (s) turned.camera.right = -turned.camera.right;
      if (t) turned.camera.up = -turned.camera.up;
      expect(turned, known.name + ", window mirrored", mirrored(known.drawn, s, t), as_it_is);
    }
  });
}

TEST(StressLaws, SwappedAxes) {
  for_planar_cases(30, [](const Known& known, Random&) {
    int axes[] = {0, 1, 2};
    while (std::next_permutation(std::begin(axes), std::end(axes))) {
      const auto swapped = [&](const glm::dvec3& v) { return glm::dvec3{v[axes[0]], v[axes[1]], v[axes[2]]}; };
      Case changed = known.sample;
      changed.soup = placed(known.sample.soup, swapped);
      const bool odd = (axes[0] == 0) + (axes[1] == 1) + (axes[2] == 2) == 1;
      if (odd) reverse(changed.soup);
      for (glm::dvec3* v : {&changed.camera.eye, &changed.camera.forward, &changed.camera.right, &changed.camera.up})
        *v = swapped(*v);
      expect(changed, known.name + ", axes swapped", known.drawn, as_it_is);
    }
  });
}

// Polygons may run either way round where both sides are opaque.
TEST(StressLaws, PolygonsTurnedRound) {
  for_planar_cases(50, [](const Known& known, Random&) {
    if (known.sample.options.one_sided) return;
    Case changed = known.sample;
    reverse(changed.soup);
    expect(changed, known.name + ", polygons turned round", known.drawn, as_it_is);
  });
}

// A longer picture plane is the same window.
TEST(StressLaws, VectorsOfAnyLength) {
  for_cases(25, [](const Known& known, Random&) {
    for (const double factor : {0x1p-300, 4.0, 0x1p500}) {
      Case changed = known.sample;
      for (glm::dvec3* v : {&changed.camera.forward, &changed.camera.right, &changed.camera.up}) *v *= factor;
      expect(changed, known.name + ", window elsewhere", known.drawn, as_it_is);
    }
  });
}

// Every part of the window sees its part of the map: the same edges, wherever they end within it, and of every
// polygon together the same area.
TEST(StressLaws, PartsOfTheWindow) {
  for_cases(30, [](const Known& known, Random& random) {
    const double s = random.between(1, 15) / 16.0, t = random.between(1, 15) / 16.0;
    std::map<PolygonId, mpq_class> left;
    for (const DrawnFace& f : known.drawn.faces) left[f.polygon] += f.area;
    Court court(known.sample.soup, known.sample.options, {.oracle = false});
    for (const auto& [low, high] :
         {std::pair<glm::dvec2, glm::dvec2>{{0, 0}, {s, t}}, {{s, 0}, {1, t}}, {{0, t}, {s, 1}}, {{s, t}, {1, 1}}}) {
      Camera part = known.sample.camera;
      try {
        part = crop(known.sample.camera, low, high);
      } catch (const std::invalid_argument&) {  // no doubles
        return;
      }
      Drawing drawn = drawing(court.scene(), court.check(part, known.name + ", part of the window"));
      const mpq_class w = mpq_class(high.x) - mpq_class(low.x), h = mpq_class(high.y) - mpq_class(low.y);
      for (const DrawnFace& f : drawn.faces) left[f.polygon] -= f.area * w * h;
      const auto in_part = [](const oracle::Point& p) { return p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1; };
      for (DrawnEdge& e : drawn.edges) {
        if (!in_part(e.a) || !in_part(e.b)) continue;
        for (oracle::Point* p : {&e.a, &e.b}) *p = {mpq_class(low.x) + p->x * w, mpq_class(low.y) + p->y * h};
        if (std::ranges::find(known.drawn.edges, e) == known.drawn.edges.end())
          court.fault("an edge of a part of the window is none of the window's");
      }
    }
    ++applied;
    for (const auto& [polygon, area] : left) {
      if (area != 0) court.fault("the parts see another area of polygon " + std::to_string(polygon));
    }
  });
}

}  // namespace
}  // namespace sightline::stress
