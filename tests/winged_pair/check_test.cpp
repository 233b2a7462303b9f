// check() against complexes made by hand: right ones, and right ones that do not fit the scene.
#include "winged_pair/check.hpp"

#include <gtest/gtest.h>

#include "tests/winged_pair/samples.hpp"
#include "winged_pair/split.hpp"

namespace sightline::testing {
namespace {

Complex box_around(const Scene& scene, int margin) {
  Integer low[3], high[3];
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = high[k] = scene.points().point(0)[k];
    for (PointId p = 1; p < scene.points().size(); ++p) {
      const Integer x = scene.points().point(p)[k];
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
    low[k] -= margin;
    high[k] += margin;
  }
  return make_box(scene, low, high);
}

TEST(Check, BoxIsRight) {
  const Scene scene = empty_scene();
  const Complex c = box_around(scene, 0);
  EXPECT_EQ(c.cells.size(), 1u);
  EXPECT_EQ(c.faces.size(), 6u);
  EXPECT_EQ(c.edges.size(), 12u);
  EXPECT_EQ(c.vertices.size(), 8u);
  EXPECT_EQ(c.pairs.size(), 24u);
  EXPECT_EQ(joined(check(c, scene)), "");
}

TEST(Check, CutBoxIsRight) {
  const Scene scene = empty_scene();
  Complex c = box_around(scene, 1);
  Splitter splitter(c);
  const PlaneId middle = c.planes.add_axis(0, (c.box[0][0] + c.box[1][0]) / 2).id;
  ASSERT_NE(splitter.cut_cell(0, middle).front, none);
  EXPECT_EQ(joined(check(c, scene)), "");
}

TEST(Check, SurfaceOnNoFace) {
  const Scene scene = make_scene(soup_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 4}}}));
  EXPECT_NE(joined(check(box_around(scene, 1), scene)).find("surface 0 of polygon 0: on no face"), std::string::npos);
}

TEST(Check, FacePartlyInside) {
  const Scene scene =
      make_scene(soup_of({{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 3, 1}}, {{0, 0, 0}, {1, 1, 1}, {4, 4, 4}}}));
  Complex c = box_around(scene, 1);
  Splitter splitter(c);
  ASSERT_NE(splitter.cut_cell(0, scene.surfaces()[0].plane).front, none);
  EXPECT_NE(joined(check(c, scene)).find("partly inside surface 0 of polygon 0"), std::string::npos);
}

TEST(Check, SurfaceHalfCovered) {
  // The surface spans the whole box. The plane x = middle cuts it; only one of its two halves is made a face.
  const Scene scene =
      make_scene(soup_of({{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}}, {{0, 0, 0}, {1, 1, 1}, {4, 4, 4}}}));
  Complex c = box_around(scene, 0);
  Splitter splitter(c);
  Labels labels(c);
  const CellId front = splitter.cut_cell(0, c.planes.add_axis(0, (c.box[0][0] + c.box[1][0]) / 2).id).front;
  ASSERT_NE(front, none);
  c.faces[splitter.cut_cell(front, scene.surfaces()[0].plane).face].label = labels.with(0, 0);
  EXPECT_NE(joined(check(c, scene)).find("surface 0 of polygon 0: not covered beyond edge"), std::string::npos);
  c.faces[splitter.cut_cell(0, scene.surfaces()[0].plane).face].label = labels.with(0, 0);
  EXPECT_EQ(joined(check(c, scene)), "");
}

TEST(Check, AtMost) {
  const Scene scene = crossing_scene();
  Complex c = build(scene);
  for (Vertex& v : c.vertices) v.edge = none;
  EXPECT_EQ(check(c, scene, 3).size(), 3u);
  EXPECT_EQ(check(c, scene, 1).size(), 1u);
}

}  // namespace
}  // namespace sightline::testing
