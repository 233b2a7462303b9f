// Scenes walked through a degeneracy in steps of one unit in the last place, every step judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/stress/figures.hpp"
#include "tests/stress/judge.hpp"

namespace sightline::stress {
namespace {

/// Changes a case by so many units in the last place.
using Step = std::function<void(Case&, int)>;
struct Walk {
  std::string name;
  Case start;  // degenerate in one thing
  Step step;
};

constexpr int reach = 3;

/// What lies beside what, without places and names.
std::string shape(const VisibilityMap& map) {
  std::vector<std::string> items;
  const auto polygon = [&](std::uint32_t f) { return f == none ? "-" : std::to_string(map.faces[f].polygon); };
  for (const MapEdge& e : map.edges) {
    std::string sides[] = {polygon(e.left), polygon(e.right)};
    std::ranges::sort(sides);
    items.push_back(sides[0] + "|" + sides[1] + " " + std::to_string(static_cast<int>(e.kind)));
  }
  for (std::uint32_t f = 0; f < map.faces.size(); ++f) {
    std::string item = "face " + polygon(f) + " " + std::to_string(map.faces[f].loop_count);
    for (const PolygonId p : map.coincident_of(map.faces[f])) item += " " + std::to_string(p);
    items.push_back(item);
  }
  std::ranges::sort(items);
  std::string out;
  for (const std::string& item : items) out += item + "\n";
  return out;
}

/// Judges every step. Before the degeneracy and after it the map keeps its shape, if `one_thing` is all that happens.
void judge(const Walk& walk, bool one_thing) {
  std::string side[2];
  for (int k = -reach; k <= reach; ++k) {
    Case sample = walk.start;
    walk.step(sample, k);
    Court court(sample.soup, sample.options);
    const std::string now = shape(court.check(sample.camera, walk.name + " step " + std::to_string(k)));
    if (!one_thing || k == 0) continue;
    std::string& expected = side[k > 0];
    if (expected.empty()) expected = now;
    if (expected != now) court.fault("the map's shape changes where nothing happens:\n" + expected + "now:\n" + now);
  }
}

/// Steps one coordinate of some vertices.
Step moving(std::vector<std::size_t> vertices, int axis) {
  return [=](Case& c, int k) {
    for (const std::size_t v : vertices) c.soup.vertices[v][axis] = stepped(c.soup.vertices[v][axis], k);
  };
}

const Camera ahead{{0, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 2}};

/// An upright rectangle across the view.
void upright(Figure& figure, double y, double left, double right, double low, double high) {
  figure.add({{left, y, low}, {right, y, low}, {right, y, high}, {left, y, high}});
}

std::vector<Walk> walks() {
  std::vector<Walk> all;
  const auto add = [&all](const char* name, const Figure& figure, const Camera& camera, const Step& step) {
    Walk walk;
    walk.name = name;
    walk.start.soup = figure.soup;
    walk.start.camera = camera;
    walk.step = step;
    all.push_back(std::move(walk));
  };
  {
    Figure f;
    upright(f, 1, -0.25, 0.5, -0.25, 0.3);
    upright(f, 2, 1, 1.5, -0.7, 0.7);
    add("edge past an edge", f, ahead, moving({1, 2}, 0));
  }
  {
    Figure f;
    f.add({{0.125, 1, -0.25}, {0.375, 1, 0.0625}, {0.1, 1, 0.25}});
    upright(f, 2, 0.75, 1.5, -0.5, 0.5);
    add("corner past an edge", f, ahead, moving({1}, 0));
  }
  {
    Figure f;
    upright(f, 1, -0.25, 0.3, -0.25, 0.3);
    upright(f, 1, 0.3, 0.45, -0.2, 0.4);
    upright(f, 2, -0.9, 0.9, -0.9, 0.9);
    add("crack between neighbours", f, ahead, moving({1, 2}, 0));
    add("crack that opens at one end", f, ahead, moving({2}, 0));
  }
  {
    Figure f;
    upright(f, 1, -0.25, 0.3, -0.25, 0.3);
    upright(f, 1, 0.1, 0.45, -0.1, 0.4);
    add("one in front of the other", f, ahead, moving({4, 5, 6, 7}, 1));
  }
  {
    Figure f;
    f.add({{-0.25, 1, -0.25}, {0.25, 1, -0.125}, {0, 1, 0.25}});
    f.add({{-0.125, 1, -0.375}, {0.375, 1, 0.125}, {-0.25, 1, 0.125}});
    add("tilting out of a common plane", f, ahead, moving({4}, 1));
  }
  {
    Figure f;
    f.add({{-2, 1, -0.4}, {2, 1, -0.4}, {2, 3, -0.4}, {-2, 3, -0.4}});
    f.add({{-0.3, 2, 0.2}, {0.4, 2, 0.3}, {0.125, 1.75, -0.4}});
    add("corner through a floor", f, ahead, moving({6}, 2));
  }
  {
    Figure f;
    upright(f, 1, 0.1, 0.5, 0.1, 0.3);
    f.add({{0.9, 2, 0.25}, {-0.1, 2, 0.5}, {0.9, 2, 0.75}});
    upright(f, 3, 0.6, 0.9, 0.6, 1.2);
    add("corner behind a corner", f, ahead, moving({7, 10}, 0));
  }
  {
    Figure f;
    f.add({{-0.5, 1, 0}, {0.5, 1, 0}, {0, 1, -0.4}});         // the edge z = 0
    f.add({{0.25, 2, -0.5}, {0.25, 2, 0.5}, {0.9, 2, 0.1}});  // the edge x / y = 1/8
    f.add({{0, 4, -0.5}, {1, 4, 0.5}, {0, 4, 0.5}});          // the edge (x - z) / y = 1/8
    add("three edges through a point", f, ahead, moving({3, 4}, 0));
  }
  {
    Figure f;
    upright(f, 1, -0.25, 1, -0.25, 0.25);
    add("the window's side past an edge", f, ahead, [](Case& c, int k) { c.camera.right.x = stepped(2, k); });
  }
  {
    Figure f;
    f.add({{0.7, 1, -0.2}, {0.7, 2, -0.2}, {0.7, 2, 0.3}, {0.7, 1, 0.3}});
    upright(f, 3, -1, 2, -1, 1);
    Camera camera = ahead;
    camera.eye.x = 0.7;
    add("eye through a plane", f, camera, [](Case& c, int k) { c.camera.eye.x = stepped(c.camera.eye.x, k); });
  }
  {
    Figure f;
    f.add_box({0.1, 1, -1}, {0.7, 3, 0.3});
    Camera camera = ahead;
    for (const glm::dvec3& eye : {glm::dvec3{0.7, 1.5, -0.2}, {0.7, 1, -0.2}, {0.7, 1, 0.3}, {0.7, 0.5, 0.3}}) {
      camera.eye = eye;
      add("eye through the side of a box", f, camera,
          [](Case& c, int k) { c.camera.eye.x = stepped(c.camera.eye.x, k); });
      if (eye.y == 1)
        add("eye along the front of a box", f, camera,
            [](Case& c, int k) { c.camera.eye.y = stepped(c.camera.eye.y, k); });
    }
  }
  return all;
}

TEST(StressSweeps, ThroughOneDegeneracy) {
  for (const Walk& walk : walks()) judge(walk, true);
}

// Turned by a rounded rotation the same scenes are degenerate nowhere, but the walk comes by many near misses.
TEST(StressSweeps, PastIt) {
  for (std::uint64_t seed = 0; seed < times(1); ++seed) {
    Random random(seed);
    for (Walk walk : walks()) {
      const Turn turn = some_turn(random);
      walk.start.soup = placed(walk.start.soup, turn);
      for (glm::dvec3* v :
           {&walk.start.camera.eye, &walk.start.camera.forward, &walk.start.camera.right, &walk.start.camera.up}) {
        *v = turn(*v);
      }
      const Step in_place = walk.step;
      walk.name += " turned " + std::to_string(seed);
      if (walk.name.starts_with("the window")) {
        walk.step = [](Case& c, int k) { c.camera.right.x = stepped(c.camera.right.x, k); };
      }
      judge(walk, false);
    }
  }
}

// Any coordinate of any degenerate scene.
TEST(StressSweeps, OfAnyCoordinate) {
  for (std::uint64_t seed = 0; seed < times(20); ++seed) {
    Random random(seed + 5000);
    const Case sample = testing::make_case(seed, 4);
    const auto vertex = static_cast<std::size_t>(random.below(static_cast<int>(sample.soup.vertices.size())));
    const int axis = random.below(3);
    Step step = moving({vertex}, axis);
    if (random.once_in(3)) {
      step = [axis](Case& c, int k) { c.camera.eye[axis] = stepped(c.camera.eye[axis], k); };
    } else if (random.once_in(4)) {
      step = [axis](Case& c, int k) { c.camera.forward[axis] = stepped(c.camera.forward[axis], k); };
    }
    judge({"seed " + std::to_string(seed), sample, step}, false);
  }
}

}  // namespace
}  // namespace sightline::stress
