// Winged-pair files: what is read is what was written, to the bit, and writing it again gives the same bytes.
#include "winged_pair/file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "tests/oracle/scenes.hpp"
#include "tests/winged_pair/file_samples.hpp"
#include "tests/winged_pair/samples.hpp"

namespace sightline::testing {
namespace {

void expect_same_scene(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.soup().source, b.soup().source);
  EXPECT_EQ(a.soup().first, b.soup().first);
  EXPECT_EQ(a.soup().corners, b.soup().corners);
  EXPECT_EQ(a.soup().objects, b.soup().objects);
  EXPECT_EQ(a.soup().object_of, b.soup().object_of);
  EXPECT_EQ(a.options().snap, b.options().snap);
  EXPECT_EQ(a.options().one_sided, b.options().one_sided);
  ASSERT_EQ(a.soup().vertices.size(), b.soup().vertices.size());
  for (std::size_t k = 0; k < a.soup().vertices.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a.soup().vertices[k][i]),
                std::bit_cast<std::uint64_t>(b.soup().vertices[k][i]));
    }
  }
}

void expect_same_complex(const Complex& a, const Complex& b) {
  ASSERT_EQ(a.planes.size(), b.planes.size());
  for (PlaneId p = 0; p < a.planes.size(); ++p) {
    for (int k = 0; k < 4; ++k) ASSERT_EQ(a.planes.integer(p, k), b.planes.integer(p, k));
  }
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t k = 0; k < a.vertices.size(); ++k) {
    EXPECT_TRUE(std::ranges::equal(a.vertices[k].place.plane, b.vertices[k].place.plane));
    EXPECT_EQ(a.vertices[k].place.approx, b.vertices[k].place.approx);
    EXPECT_EQ(a.vertices[k].place.error, b.vertices[k].place.error);
    EXPECT_EQ(a.vertices[k].edge, b.vertices[k].edge);
  }
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t k = 0; k < a.edges.size(); ++k) {
    EXPECT_TRUE(std::ranges::equal(a.edges[k].vertex, b.edges[k].vertex));
    EXPECT_TRUE(std::ranges::equal(a.edges[k].plane, b.edges[k].plane));
    EXPECT_EQ(a.edges[k].pair, b.edges[k].pair);
    EXPECT_EQ(a.edges[k].a, b.edges[k].a);
    EXPECT_EQ(a.edges[k].b, b.edges[k].b);
  }
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (std::size_t k = 0; k < a.faces.size(); ++k) {
    EXPECT_TRUE(std::ranges::equal(a.faces[k].cell, b.faces[k].cell));
    EXPECT_EQ(a.faces[k].pair, b.faces[k].pair);
    EXPECT_EQ(a.faces[k].plane, b.faces[k].plane);
    EXPECT_EQ(a.faces[k].label, b.faces[k].label);
  }
  EXPECT_TRUE(std::ranges::equal(a.cells, b.cells, {}, &Cell::face, &Cell::face));
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (std::size_t k = 0; k < a.pairs.size(); ++k) {
    EXPECT_EQ(a.pairs[k].face, b.pairs[k].face);
    EXPECT_EQ(a.pairs[k].edge, b.pairs[k].edge);
    EXPECT_TRUE(std::ranges::equal(a.pairs[k].clock, b.pairs[k].clock));
    EXPECT_TRUE(std::ranges::equal(a.pairs[k].spin, b.pairs[k].spin));
    EXPECT_EQ(a.pairs[k].direction, b.pairs[k].direction);
  }
  EXPECT_EQ(a.label_first, b.label_first);
  EXPECT_EQ(a.label_surfaces, b.label_surfaces);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(a.box[0][k], b.box[0][k]);
    EXPECT_EQ(a.box[1][k], b.box[1][k]);
    EXPECT_EQ(a.box_plane[k][0], b.box_plane[k][0]);
    EXPECT_EQ(a.box_plane[k][1], b.box_plane[k][1]);
  }
}

void expect_round_trip(const Scene& scene) {
  const TemporaryFile file, again;
  const Complex complex = build(scene);
  write_wp(file.path(), scene, complex);
  const SceneAndComplex back = read_wp(file.path());
  expect_same_scene(scene, back.scene);
  expect_same_complex(complex, back.complex);
  EXPECT_EQ(joined(check(back.complex, back.scene)), "");
  write_wp(again.path(), back.scene, back.complex);
  EXPECT_EQ(content(file.path()), content(again.path()));
}

TEST(WingedPairFile, RoundTrip) {
  expect_round_trip(crossing_scene());
  expect_round_trip(empty_scene());
}

TEST(WingedPairFile, RoundTripOfDegenerateScenes) {
  for (std::uint64_t seed = 1000; seed < 1100; ++seed) {
    const Case sample = make_case(seed);
    expect_round_trip(make_scene(sample.soup, sample.options));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(WingedPairFile, Snapped) {
  for (const char* unit : {"1e-3", "0.25", "3"}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) expect_round_trip(make_scene(make_case(seed).soup, {.snap = unit}));
    ASSERT_FALSE(HasFailure()) << unit;
  }
}

TEST(WingedPairFile, NamesOfAllKinds) {
  PolygonSoup soup = crossing_scene().soup();
  soup.source = "a \"name\"\nwith \\x20 and \t, \r and \xc3\xa9 ";
  soup.objects = {"", " first", "second ", "\"", "\\", "end\n"};
  soup.object_of = {5, none, 0, 1};
  expect_round_trip(make_scene(soup));
}

TEST(WingedPairFile, HardNumbers) {
  // Offsets that no double stands for: huge and tiny coordinates in one scene.
  expect_round_trip(make_scene(soup_of({{{0, 0, 0x1p-60}, {1e9, 0, 0x1p-60}, {1e9, 1e9, 0x1p-60}},
                                        {{5e-324, 0.1, -0.0}, {0.3, 2.35, 1e-300}, {7, 1.0 / 3, 1e3}}})));
  expect_round_trip(make_scene(soup_of({{{1e15 + 0.125, 0, 0}, {1e15 + 3, 0, 1}, {1e15 + 7, 2, 1}}})));
}

TEST(WingedPairFile, OneRecordALine) {
  const TemporaryFile file;
  const Scene scene = crossing_scene();
  const Complex c = build(scene);
  write_wp(file.path(), scene, c);
  const std::string text = content(file.path());
  EXPECT_EQ(text.substr(0, text.find('\n')), "sightline-winged-pair 1");
  const auto lines = [&text](const std::string& keyword) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find("\n" + keyword + " ", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(lines("plane"), c.planes.size());
  EXPECT_EQ(lines("vertex"), c.vertices.size());
  EXPECT_EQ(lines("edge"), c.edges.size());
  EXPECT_EQ(lines("face"), c.faces.size());
  EXPECT_EQ(lines("cell"), c.cells.size());
  EXPECT_EQ(lines("pair"), c.pairs.size());
  EXPECT_EQ(lines("v"), scene.soup().vertices.size());
  EXPECT_EQ(lines("f"), scene.polygon_count());
}

}  // namespace
}  // namespace sightline::testing
