#include "binary_files.hpp"
#include "scene/read.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>

namespace sightline::test {
namespace {

using Index = std::vector<std::uint32_t>;

PolygonSoup read(const std::string& name, std::string_view content) {
  const TemporaryFolder folder;
  return read_polygons(folder.write(name, content));
}

TEST(ReadObj, PolygonsWithAllFormsOfCorners) {
  const PolygonSoup soup = read("a.obj",
                                "# a comment\n"
                                "v 0 0 0\r\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv\t0  1.5e0 +0.25 # behind\n"
                                "vt 0 0\nvn 0 0 1\nusemtl stone\n"
                                "f 1 2 3\nf 1/1 2/1 3/1 4/1\nf 1//1 2//1 4//1\nf 1/1/1 3/1/1 4/1/1\n"
                                "f -4 -2 -1\nl 1 2\np 1\nf 1 2 \\\n 3 4\n");
  EXPECT_EQ(soup.source, "a.obj");
  ASSERT_EQ(soup.vertices.size(), 4u);
  EXPECT_EQ(soup.vertices[3], glm::dvec3(0, 1.5, 0.25));
  EXPECT_EQ(soup.first, (Index{0, 3, 7, 10, 13, 16, 20}));
  EXPECT_EQ(soup.corners, (Index{0, 1, 2, 0, 1, 2, 3, 0, 1, 3, 0, 2, 3, 0, 2, 3, 0, 1, 2, 3}));
  EXPECT_TRUE(soup.objects.empty());
  EXPECT_TRUE(soup.object_of.empty());
}

TEST(ReadObj, NamesOfObjects) {
  const PolygonSoup soup =
      read("names.OBJ",
           "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no the wall \nf 1 2 3\ng roof#1\nf 1 2 3\n"
           "g the wall\nf 1 2 3\ng\nf 1 2 3");
  EXPECT_EQ(soup.objects, (std::vector<std::string>{"the wall", "roof#1"}));
  EXPECT_EQ(soup.object_of, (Index{none, 0, 1, 0, none}));
}

TEST(ReadObj, VerticesMayFollowTheirPolygons) {
  const PolygonSoup soup = read("late.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  EXPECT_EQ(soup.corners, (Index{0, 1, 2}));
}

TEST(ReadObj, NumbersAtTheEdgesOfDoubles) {
  const PolygonSoup soup = read("numbers.obj",
                                "v 1e-400 -1e-99999999999999999999 0e999999\n"
                                "v 4.9406564584124654e-324 2.4e-324 1.7976931348623157e308\n"
                                "v 0.1 0.30000000000000004 9007199254740993\n"
                                "v 0.000000000000000000000000000000000000000000000000000000000001e-300 -0.0 .5\n"
                                "v 10000000000000000000000000000000000000000000000000e-340 5. 1E5\nf 1 2 3\n");
  EXPECT_EQ(soup.vertices[0], glm::dvec3(0, -0.0, 0));
  EXPECT_TRUE(std::signbit(soup.vertices[0].y));
  EXPECT_EQ(soup.vertices[1], glm::dvec3(0x1p-1074, 0, 0x1.fffffffffffffp1023));
  EXPECT_EQ(soup.vertices[2], glm::dvec3(0.1, 0.30000000000000004, 9007199254740992.0));  // a tie, to even
  EXPECT_EQ(soup.vertices[3], glm::dvec3(0, -0.0, 0.5));
  EXPECT_EQ(soup.vertices[4], glm::dvec3(1e-291, 5, 1e5));
}

/// Halfway cases and long decimals, against the C library (which rounds correctly).
RC_GTEST_PROP(ReadObj, NumbersAreCorrectlyRounded, ()) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  const auto digits = *rc::gen::inRange(1, 40);
  const double value = std::abs(std::bit_cast<double>(bits));
  RC_PRE(std::isfinite(value));
  char text[64];
  std::snprintf(text, sizeof text, "%.*e", digits, value);
  // The decimal of the midpoint to the next double: just what a sum of digits in doubles gets wrong.
  char middle[1200];
  const long double half = static_cast<long double>(value) +
                           (static_cast<long double>(std::nextafter(value, 0.0)) - static_cast<long double>(value)) / 2;
  std::snprintf(middle, sizeof middle, "%.800Le", half);
  RC_PRE(std::isfinite(std::strtod(text, nullptr)));
  const PolygonSoup soup =
      read("x.obj", std::string("v ") + text + " -" + text + " " + middle + "\nv 0 0 0\nv 1 1 1\nf 1 2 3\n");
  RC_ASSERT(soup.vertices[0].x == std::strtod(text, nullptr));
  RC_ASSERT(soup.vertices[0].y == -std::strtod(text, nullptr));
  RC_ASSERT(soup.vertices[0].z == std::strtod(middle, nullptr));
}

TEST(ReadPly, Ascii) {
  const PolygonSoup soup =
      read("a.ply",
           "ply\r\nformat ascii 1.0\r\ncomment x\nobj_info y\nelement vertex 3\nproperty float nx\n"
           "property float x\nproperty float y\nproperty float z\nelement nothing 99999999999\n"
           "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n"
           "end_header\nnan 0.1 0 0\n0 1 0 0\n0 0 1\n0\n3 0 1 2 255\n3 2 1 0 0\n\n");
  ASSERT_EQ(soup.vertices.size(), 3u);
  EXPECT_EQ(soup.vertices[0], glm::dvec3(0.1, 0, 0));
  EXPECT_EQ(soup.corners, (Index{0, 1, 2, 2, 1, 0}));
  EXPECT_EQ(soup.first, (Index{0, 3, 6}));
}

TEST(ReadPly, Binary) {
  for (const bool big_endian : {false, true}) {
    const PolygonSoup soup = read("b.ply", binary_ply(big_endian));
    ASSERT_EQ(soup.vertices.size(), 4u);
    EXPECT_EQ(soup.vertices[0], glm::dvec3(0.1, double{0.1f}, -7));
    EXPECT_EQ(soup.vertices[2], glm::dvec3(1.25, 2.5, -7));
    EXPECT_EQ(soup.corners, (Index{3, 2, 1, 0}));
  }
}

TEST(ReadOff, WithCommentsAndColours) {
  const PolygonSoup soup = read("a.off",
                                "OFF # a square\n\n# counts\n4 2 0\n0 0 0\n1 0 0\n1 1 0.1 # top\n\n0 1 0\n"
                                "4 0 1 2 3  255 0 0\n3 0 1 2\n");
  EXPECT_EQ(soup.vertices[2], glm::dvec3(1, 1, 0.1));
  EXPECT_EQ(soup.first, (Index{0, 4, 7}));
  EXPECT_EQ(soup.corners, (Index{0, 1, 2, 3, 0, 1, 2}));
}

TEST(ReadOff, ColoursAndNormalsOfVertices) {
  for (const char* word : {"COFF", "NOFF", "CNOFF", "STOFF"}) {
    const PolygonSoup soup =
        read("a.off", std::string(word) + " 3 1\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n");
    EXPECT_EQ(soup.vertices[1], glm::dvec3(1, 0, 0)) << word;
  }
}

TEST(ReadStl, Ascii) {
  const PolygonSoup soup =
      read("a.stl",
           "solid a box\n facet normal nan nan nan\n  OUTER loop\n   vertex 0 0 0.1\n   vertex 1 0 0\n"
           "   vertex 0 1 0\n  endloop\n endfacet\nendsolid a box\nsolid\nfacet normal 0 0 1 outer loop "
           "vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid\n");
  EXPECT_EQ(soup.vertices.size(), 6u);
  EXPECT_EQ(soup.vertices[0], glm::dvec3(0, 0, 0.1));
  EXPECT_EQ(soup.corners, (Index{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(soup.first, (Index{0, 3, 6}));
}

TEST(ReadStl, Binary) {
  const PolygonSoup soup = read("a.stl", binary_stl());
  ASSERT_EQ(soup.vertices.size(), 6u);
  EXPECT_EQ(soup.vertices[4], glm::dvec3(1, 0, double{0.1f}));
  EXPECT_EQ(soup.corners, (Index{0, 1, 2, 3, 4, 5}));
}

TEST(ReadCameras, CommentsAndBlankLines) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("a.cameras", "# all\n\n1 2 0.1  0 2 0  0 0 1  90 1.5 # one\r\n  \n-1 0 0  1 0 0  0 0 1  60 1\n");
  const std::vector<Camera> cameras = read_cameras(file);
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].eye, glm::dvec3(1, 2, 0.1));
  EXPECT_EQ(cameras[0].forward, glm::dvec3(0, 1, 0));
  EXPECT_EQ(cameras[0].right, glm::dvec3(3, 0, 0));
  EXPECT_EQ(cameras[0].up, glm::dvec3(0, 0, 2));
}

}  // namespace
}  // namespace sightline::test
